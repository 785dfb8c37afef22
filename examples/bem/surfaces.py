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
"""One closed surface per tissue, for the boundary element method.

usage: surfaces.py [LABELS] [--folder out] [--program multimaterial-mesh]

Without LABELS, a synthetic head is meshed, which the program make-head-phantom writes. Each surface is checked for what
boundary elements need: closed, oriented outwards, and as large a volume as the label's voxels. A tissue that encloses
others has a surface of several parts, whose inner ones are oriented inwards.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pyvista

COLORS = ("#e8b594", "#f5e6a8", "#408cde", "#8c8c94", "#ededf2", "#cc4545")


def find_program(name, program=None):
    """The path that was given, or the program on the PATH, or the one that was built in this checkout."""
    built = pathlib.Path(__file__).resolve().parents[2] / "build" / "bin" / name
    return program or shutil.which(name) or str(built)


def label_of(file):
    return int(file.stem.rpartition("_")[2])


def check(surface):
    """What is wrong with a surface, by the numbers of faces that its edges have."""
    faces = surface.regular_faces
    edges = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    return {"open edges": int((counts % 2).sum()), "pinched edges": int((counts > 2).sum())}


def volume_of(surface):
    """The volume inside in ml, negative if the normals point inwards."""
    a, b, c = np.moveaxis(surface.points[surface.regular_faces].astype(float), 1, 0)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6000.0


def draw(surfaces, picture):
    """All surfaces, those of the outer tissues cut away further."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(1000, 900))
    box = pyvista.merge(list(surfaces.values()))
    center = np.array(box.center)
    by_size = sorted(surfaces, key=lambda label: -surfaces[label].length)
    for place, label in enumerate(by_size):
        cut = center + np.array([0.0, 0.0, 0.36 * (box.bounds[5] - center[2])]) * place
        shown = surfaces[label].clip(normal=(0, 0, 1), origin=cut) if label != by_size[-1] else surfaces[label]
        plotter.add_mesh(shown, color=COLORS[(label - 1) % len(COLORS)], label=f" label {label}", smooth_shading=False)
    plotter.add_legend(bcolor="#c8c8c8", face="rectangle", size=(0.18, 0.2))
    plotter.camera_position = [center + box.length * np.array([0.9, -1.0, 0.9]), center, (0, 0, 1)]
    plotter.camera.zoom(1.3)
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description="One closed surface per tissue.")
    parser.add_argument("labels", nargs="?", help="label image; default: a synthetic head of 2 mm voxels")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    labels = arguments.labels
    if not labels:
        labels = folder / "head.nrrd"
        subprocess.run([find_program("make-head-phantom"), str(labels), "2"], check=True)
    program = find_program("multimaterial-mesh", arguments.program)
    prefix = folder / "tissue_"
    command = [
        program,
        str(labels),
        str(folder / "tissues.vtu"),
        "--surface-only",
        "--surface-per-label",
        f"{prefix}.vtu",
    ]
    subprocess.run(command, check=True)

    surfaces = {}
    failures = 0
    for file in sorted(folder.glob("tissue_*.vtu"), key=label_of):
        surface = pyvista.read(file).extract_surface(algorithm="dataset_surface")
        surfaces[label_of(file)] = surface
        defects = check(surface)
        volume = volume_of(surface)
        failures += defects["open edges"] > 0 or volume <= 0
        parts = surface.connectivity()["RegionId"].max() + 1
        print(
            f"label {label_of(file)}: {surface.n_cells} triangles in {parts} parts, volume {volume:.1f} ml, "
            + ", ".join(f"{count} {name}" for name, count in defects.items())
        )
    draw(surfaces, folder / "tissues.png")
    if failures:
        sys.exit(f"surfaces.py: {failures} surfaces are not closed")


if __name__ == "__main__":
    main()
