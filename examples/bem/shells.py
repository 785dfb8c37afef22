# =========================================================================
#
#  Copyright NumFOCUS
#
#  Licensed under the Apache License, Version 2.0 (the "License");
#  you may not use this file except in compliance with the License.
#  You may obtain a copy of the License at
#
#         https://www.apache.org/licenses/LICENSE-2.0.txt
#
#  Unless required by applicable law or agreed to in writing, software
#  distributed under the License is distributed on an "AS IS" BASIS,
#  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
#  See the License for the specific language governing permissions and
#  limitations under the License.
#
"""Three spheres as a head, from a label image to the potential of dipoles by boundary elements of MNE-Python.

usage: shells.py [--radii MM MM MM] [--spacing MM] [--size MM] [--folder out] [--program multimaterial-mesh]

Writes a label image of a brain, a skull and a skin, has multimaterial-mesh write the hull of each with what it holds,
and hands them to MNE-Python as the surfaces of a subject. MNE-Python checks that they are closed and in each other.
Radial and tangential dipoles at several depths are compared with the known solution.
"""

import argparse
import pathlib
import subprocess
import sys

import mne
import numpy as np
import pyvista
from surfaces import draw, find_program

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "eeg"))
from sphere_model import compare, distances, surface_potential, write_image  # noqa: E402

HULLS = {"inner_skull": "1", "outer_skull": "1,2", "outer_skin": "1,2,3"}
CONDUCTIVITIES = (0.33, 0.0066, 0.33)  # S/m
DEPTHS = np.array([0.5, 0.25, 0.125])  # of the inner radius
ELECTRODES = 200
AXIS = np.array([0.36, -0.48, 0.8])
ACROSS = np.array([0.8, 0.6, 0.0])


def mesh_spheres(program, folder, radii, spacing, size):
    """Writes the hulls to where MNE-Python looks for those of the subject "spheres"."""
    surfaces = folder / "subjects" / "spheres" / "bem"
    surfaces.mkdir(parents=True, exist_ok=True)
    layers = np.searchsorted(radii, distances(radii[-1], spacing))
    labels = np.where(layers < len(radii), layers + 1, 0).astype(np.uint8)
    write_image(folder / "shells.nrrd", labels, spacing)
    command = [program, folder / "shells.nrrd", folder / "shells.vtu", "--quiet", "--surface-only"]
    command += ["--min-size", size, "--tolerance", 0.15 * size]
    for name, inside in HULLS.items():
        command += ["--hull", f"{surfaces / name}.surf={inside}"]
    done = subprocess.run([str(word) for word in command], check=True, stderr=subprocess.PIPE, text=True)
    if done.stderr:
        sys.exit(f"shells.py: {done.stderr}")
    return surfaces


def electrodes_on(radius):
    """Places that are spread evenly over a sphere, by name."""
    turn = np.arange(ELECTRODES) + 0.5
    z = 1.0 - 2.0 * turn / ELECTRODES
    angle = np.pi * (1.0 + np.sqrt(5.0)) * turn
    ring = np.sqrt(1.0 - z**2)
    points = radius * np.column_stack([ring * np.cos(angle), ring * np.sin(angle), z])
    return {f"E{i}": point for i, point in enumerate(points)}


def lead_field(folder, electrodes, positions):
    """The potential at the electrodes of unit dipoles along x, y and z: (electrodes, 3 positions)."""
    surfaces = mne.make_bem_model("spheres", ico=None, conductivity=CONDUCTIVITIES, subjects_dir=folder / "subjects")
    solution = mne.make_bem_solution(surfaces)
    info = mne.create_info(list(electrodes), 1.0, "eeg")
    info.set_montage(mne.channels.make_dig_montage(electrodes, coord_frame="head"))
    directions = np.tile(AXIS, (len(positions), 1))
    source = mne.setup_volume_source_space(pos={"rr": positions, "nn": directions})
    # the spheres' center is that of the head: no transformation
    return mne.make_forward_solution(info, None, source, solution, meg=False, mindist=0.0)["sol"]["data"]


def main():
    parser = argparse.ArgumentParser(
        description="Boundary elements in three spheres, compared with the known solution."
    )
    parser.add_argument(
        "--radii", type=float, nargs=3, default=[80.0, 86.0, 92.0], metavar="MM", help="from the inside"
    )
    parser.add_argument("--spacing", type=float, default=3.0, metavar="MM", help="of the voxels (default: %(default)s)")
    parser.add_argument("--size", type=float, default=6.0, metavar="MM", help="of edges (default: %(default)s)")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    mne.set_log_level("WARNING")
    radii = np.array(arguments.radii)
    program = find_program("multimaterial-mesh", arguments.program)
    folder = mesh_spheres(program, arguments.folder, radii, arguments.spacing, arguments.size)
    surfaces = {}
    for label, name in enumerate(HULLS, start=1):
        surfaces[label] = pyvista.PolyData.from_regular_faces(*mne.read_surface(f"{folder / name}.surf"))
        volume = surfaces[label].volume / (4 / 3 * np.pi * radii[label - 1] ** 3) - 1
        print(f"{name}: {surfaces[label].n_points} points, {surfaces[label].n_cells} triangles, volume {volume:+.2%}")

    electrodes = electrodes_on(radii[-1] * 1e-3)
    positions = (radii[0] * (1 - DEPTHS) * 1e-3)[:, None] * AXIS
    fields = lead_field(arguments.folder, electrodes, positions)
    print("depth mm  dipole      relative error     RDM     MAG")
    for i, position in enumerate(positions):
        for name, direction in (("radial", AXIS), ("tangential", ACROSS)):
            potential = fields[:, 3 * i : 3 * i + 3] @ direction
            points = np.array(list(electrodes.values()))
            expected = surface_potential(points, position, direction, radii * 1e-3, np.array(CONDUCTIVITIES))
            error, topography, magnitude = compare(potential, expected)
            print(f"{radii[0] * DEPTHS[i]:8.0f}  {name:10s} {error:14.2%} {topography:10.4f} {magnitude:7.4f}")
    draw(surfaces, arguments.folder / "shells.png")


if __name__ == "__main__":
    main()
