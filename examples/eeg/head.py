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
"""The potential on the skin of a head whose brain has a current dipole in it: an EEG forward solution.

usage: head.py [LABELS] [--folder out] [--program multimaterial-mesh]

Without LABELS, a synthetic head is meshed, which the program make-head-phantom writes. Labels are those of the common
six-tissue head models: 1 scalp, 2 skull, 3 cerebrospinal fluid, 4 gray matter, 5 white matter, 6 air. Air is not meshed.
"""

import argparse
import pathlib

import numpy as np
import pyvista
from forward import find_program, labels_or_phantom, mesh_images, skin_of, solve
from scipy.spatial import cKDTree

CONDUCTIVITIES = {1: 0.43, 2: 0.01, 3: 1.79, 4: 0.33, 5: 0.14}  # S/m
GRAY_MATTER = 4
MOMENT = 1e-8  # A m


def choose_dipole(grid):
    """A place in the upper left gray matter, as far as possible from other tissues, and the way to the nearest of them."""
    gray = grid["label"] == GRAY_MATTER
    tetrahedra = grid.cells_dict[pyvista.CellType.TETRA]
    others = grid.points[np.intersect1d(tetrahedra[gray], tetrahedra[~gray])]
    places = grid.points[tetrahedra[gray]].mean(axis=1)
    places = places[(places - places.mean(axis=0)) @ [0.5, 0.0, 1.0] > 40.0]
    distance, nearest = cKDTree(others).query(places)
    best = distance.argmax()
    print(f"dipole at {places[best].round(1)} mm, {distance[best]:.1f} mm from other tissues")
    direction = others[nearest[best]] - places[best]
    return places[best], direction / np.linalg.norm(direction)


def bar(place):
    return {"title": f"potential {place}, \N{MICRO SIGN}V", "fmt": "%.2g"}


def draw(grid, position, picture):
    skin = skin_of(grid)
    center = np.array(grid.center)
    half = grid.extract_cells(grid.cell_centers().points[:, 1] > position[1])
    limit = np.abs(skin["potential"]).max()
    plotter = pyvista.Plotter(off_screen=True, window_size=(1200, 600), shape=(1, 2))
    plotter.add_mesh(
        skin, scalars="potential", cmap="coolwarm", clim=(-limit, limit), scalar_bar_args=bar("on the skin")
    )
    plotter.camera_position = [center + skin.length * np.array([0.9, -0.5, 0.9]), center, (0, 0, 1)]
    plotter.camera.zoom(0.9)
    plotter.subplot(0, 1)
    plotter.add_mesh(
        half.copy(),
        scalars="potential",
        cmap="coolwarm",
        clim=(-5 * limit, 5 * limit),
        show_edges=True,
        line_width=0.2,
        scalar_bar_args=bar("inside"),
    )
    plotter.camera_position = [center + skin.length * np.array([0.2, -1.5, 0.3]), center, (0, 0, 1)]
    plotter.camera.zoom(1.3)
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description="An EEG forward solution.")
    parser.add_argument("labels", nargs="?", help="label image; default: a synthetic head of 2 mm voxels")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    program = find_program("multimaterial-mesh", arguments.program)
    labels = labels_or_phantom(arguments.labels, folder)
    grid = mesh_images(program, [labels], folder / "head-eeg.vtu", "--exterior", "0,6")
    position, direction = choose_dipole(grid)
    grid["potential"] = 1e6 * solve(grid, CONDUCTIVITIES, position, MOMENT * direction)
    skin = skin_of(grid)
    print(f"potential on the skin: {skin['potential'].min():.3g} to {skin['potential'].max():.3g} \N{MICRO SIGN}V")
    grid.save(folder / "head-eeg.vtu")
    draw(grid, position, folder / "head-eeg.png")


if __name__ == "__main__":
    main()
