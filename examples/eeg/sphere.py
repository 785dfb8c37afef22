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
"""Compares the potential of dipoles in a mesh of four concentric spheres with the known solution.

usage: sphere.py [--spacing MM] [--depths MM...] [--indicators] [--folder out] [--program multimaterial-mesh]

Writes a label image of a brain, cerebrospinal fluid, a skull and a skin, or an image per tissue of how far inside each
voxel is, meshes that, solves for radial and tangential dipoles at several depths, prints the errors on the skin, and
draws the last of them.
"""

import argparse
import pathlib

import numpy as np
import pyvista
from forward import find_program, mesh_images, skin_of, solve
from sphere_model import compare, distances, surface_potential, write_image

RADII = np.array([78.0, 80.0, 86.0, 92.0])  # mm
CONDUCTIVITIES = np.array([0.33, 1.79, 0.01, 0.43])  # S/m
MOMENT = 1e-8  # A m


def write_labels(folder, spacing):
    """Labels 1 to 4 from the inside out; 0 is outside. Returns the arguments of multimaterial-mesh."""
    layers = np.searchsorted(RADII, distances(RADII[-1], spacing))
    labels = np.where(layers < len(RADII), layers + 1, 0).astype(np.uint8)
    write_image(folder / "spheres.nrrd", labels, spacing)
    return [folder / "spheres.nrrd"]


def write_indicators(folder, spacing):
    """An image for each layer: the distance to its nearer sphere, positive inside."""
    distance = distances(RADII[-1], spacing)
    files = [folder / f"sphere-{layer}.nrrd" for layer in range(1, len(RADII) + 1)]
    for file, inner, outer in zip(files, [-np.inf, *RADII], RADII):
        write_image(file, np.minimum(distance - inner, outer - distance).astype(np.float32), spacing)
    return ["--indicators", *files]


def draw(skin, position, picture):
    plotter = pyvista.Plotter(off_screen=True, window_size=(1000, 500), shape=(1, 2))
    for column, (name, title) in enumerate([("potential", "finite elements"), ("series", "series")]):
        plotter.subplot(0, column)
        plotter.add_mesh(
            skin.copy(),
            scalars=name,
            cmap="coolwarm",
            show_edges=True,
            line_width=0.3,
            scalar_bar_args={"title": f"{title}, \N{MICRO SIGN}V"},
        )
        plotter.camera_position = [3.4 * skin.length * np.array([0.75, -0.4, 0.55]) / 1.7, (0, 0, 0), (0, 0, 1)]
        plotter.camera.zoom(1.1)
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description="Compares dipoles in a mesh of spheres with the known solution.")
    parser.add_argument("--spacing", type=float, default=2.0, metavar="MM", help="of the voxels (default: %(default)s)")
    parser.add_argument(
        "--depths", type=float, nargs="+", default=[60.0, 40.0, 20.0, 10.0], metavar="MM", help="below the fluid"
    )
    parser.add_argument("--indicators", action="store_true", help="mesh signed distances instead of labels")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    images = (write_indicators if arguments.indicators else write_labels)(folder, arguments.spacing)
    program = find_program("multimaterial-mesh", arguments.program)
    grid = mesh_images(program, images, folder / "spheres.vtu", "--quiet")
    print(f"{grid.n_points} points, {grid.n_cells} tetrahedra")
    volumes = 4 / 3 * np.pi * np.diff(RADII**3, prepend=0.0)
    sizes = np.abs(grid.compute_cell_sizes(length=False, area=False)["Volume"])
    for label, volume in enumerate(volumes, start=1):
        print(f"label {label}: volume {sizes[grid['label'] == label].sum() / volume - 1:+.2%}")

    skin = skin_of(grid)
    outer = skin["vtkOriginalPointIds"]
    conductivities = dict(enumerate(CONDUCTIVITIES, start=1))
    axis = np.array([0.36, -0.48, 0.8])
    across = np.array([0.8, 0.6, 0.0])
    print("depth mm  dipole      relative error     RDM     MAG")
    for depth in arguments.depths:
        position = (RADII[0] - depth) * axis
        for name, direction in (("radial", axis), ("tangential", across)):
            moment = MOMENT * direction
            potential = solve(grid, conductivities, position, moment)[outer]
            expected = surface_potential(skin.points * 1e-3, position * 1e-3, moment, RADII * 1e-3, CONDUCTIVITIES)
            error, topography, magnitude = compare(potential, expected)
            print(f"{depth:8.0f}  {name:10s} {error:14.2%} {topography:10.4f} {magnitude:7.4f}")
    skin["potential"] = 1e6 * potential
    skin["series"] = 1e6 * expected
    draw(skin, position, folder / "spheres-potential.png")


if __name__ == "__main__":
    main()
