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
"""What meshes of one label image are worth in the solution: EEG and the field between electrodes in four spheres.

usage: compare.py [--spacing MM] [--families F[,F...]] [--options TEXT]... [--folder out] [--program multimaterial-mesh]

Writes the label image, meshes it, solves for the potentials of currents at electrodes, and compares what dipoles give
there, and the field in the brain, with the known solution. Prints a table, keeps the rows in FOLDER/rows.json, and draws
error against unknowns of all that is kept there, in FOLDER/forward.svg.
"""

import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "eeg"))

import numpy as np
import spheres
from forward import find_program, mesh_images
from meshes import voxel_grid
from picture import draw
from solution import Conductor, monopoles

BRAIN = 1
FAMILIES = ("hexahedra", "shifted", "tetrahedra")
OPTIONS = ("", "--max-size 4", "--max-size 3", "--order 2")
CGAL_OPTIONS = ("--no-weights", "")


def norm(values):
    return np.linalg.norm(values, axis=0)


def errors_of_dipoles(values, expected, eccentricities):
    """In %: of topography, 0 to 200, and of magnitude; medians by eccentricity. Columns are dipoles."""
    values, expected = values - values.mean(axis=0), expected - expected.mean(axis=0)
    topography = 100 * norm(values / norm(values) - expected / norm(expected))
    magnitude = 100 * (norm(values) / norm(expected) - 1)
    return {
        name: {e: float(np.median(error[eccentricities == e])) for e in spheres.ECCENTRICITIES}
        for name, error in (("rdm", topography), ("magnitude", magnitude))
    }


def error_of_field(values, expected):
    """In %, of the whole brain: the median over pairs of electrodes."""
    size = lambda field: np.sqrt(np.sum(field**2, axis=(1, 2)))
    return float(100 * np.median(size(values - expected) / size(expected)))


def judge(grid, reference):
    """A row of the table."""
    place = lambda points: (points + spheres.MIDDLE) * 1e-3
    conductor = Conductor(grid, spheres.CONDUCTIVITIES)
    potentials = conductor.solve(place(reference.electrodes))

    positions = place(reference.positions)
    gradients = conductor.within(BRAIN, positions).gradient_of(potentials)
    partial = np.einsum("ape,pa->ep", gradients, reference.moments)
    venant = (monopoles(conductor, BRAIN, positions, reference.moments).T @ potentials).T

    pairs = np.stack([potentials[:, a] - potentials[:, b] for a, b in reference.pairs], axis=1)
    samples = conductor.within(BRAIN, place(reference.points))
    raw = samples.gradient_of(pairs).transpose(2, 1, 0)
    smooth = np.stack([samples.value_of(g) for g in conductor.smooth_gradient(BRAIN, pairs)]).transpose(2, 1, 0)
    return {
        "nodes": grid.n_points,
        "cells": grid.n_cells,
        "venant": errors_of_dipoles(venant, reference.potentials, reference.eccentricities),
        "partial": errors_of_dipoles(partial, reference.potentials, reference.eccentricities),
        "field": error_of_field(raw, reference.fields),
        "smooth field": error_of_field(smooth, reference.fields),
    }


HEADER = """\
| mesh | nodes | RDM, St. Venant, at 0.5 / 0.9 / 0.98 | magnitude | RDM, partial integration, at 0.2 / 0.5 / 0.9 | field: as it is / recovered |
|---|---|---|---|---|---|"""


def line(name, row):
    columns = lambda values, at, form: " / ".join(format(values[e], form) for e in at)
    return " | ".join(
        [
            f"| {name}",
            f"{row['nodes']:,}",
            columns(row["venant"]["rdm"], (0.5, 0.9, 0.98), ".2f"),
            columns(row["venant"]["magnitude"], (0.5, 0.9, 0.98), "+.1f"),
            columns(row["partial"]["rdm"], (0.2, 0.5, 0.9), ".2f"),
            f"{row['field']:.1f} / {row['smooth field']:.1f} |",
        ]
    )


def meshes(arguments, labels):
    """Names and grids, one after the other."""
    spacing = arguments.spacing
    for options in arguments.options or OPTIONS:
        ours = "ours of second order" if "--order 2" in options else "ours"
        name = f"{ours}, `{options}`" if options else f"{ours}, defaults"
        yield name, mesh_images(arguments.program, [labels], arguments.folder / "ours.vtu", "--quiet", *options.split())
    for family in filter(None, arguments.families.split(",")):
        yield f"voxels: {family}", voxel_grid(*spheres.label_image(spacing), spacing, family)
    if pathlib.Path(arguments.cgal).exists():
        for options in CGAL_OPTIONS:
            name = f"CGAL Mesh_3, `{options}`" if options else "CGAL Mesh_3"
            yield name, mesh_images(arguments.cgal, [labels], arguments.folder / "cgal.vtu", *options.split())


def main():
    parser = argparse.ArgumentParser(description="What meshes of four spheres are worth in the solution.")
    parser.add_argument("--spacing", type=float, default=2.0, metavar="MM", help="of the voxels (default: %(default)s)")
    parser.add_argument(
        "--families", default=",".join(FAMILIES), help="of voxels, separated by commas (default: %(default)s)"
    )
    parser.add_argument(
        "--options",
        action="append",
        help="of multimaterial-mesh, as one text; may be repeated (default: none; --max-size 4; --max-size 3; --order 2)",
    )
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    parser.add_argument("--cgal", help="path of cgal-mesh3; without it, it is used if it was built")
    arguments = parser.parse_args()
    arguments.program = find_program("multimaterial-mesh", arguments.program)
    arguments.cgal = find_program("cgal-mesh3", arguments.cgal)
    arguments.folder.mkdir(parents=True, exist_ok=True)

    labels = arguments.folder / "spheres.nrrd"
    spheres.write_labels(labels, arguments.spacing)
    reference = spheres.Reference()
    kept = arguments.folder / "rows.json"
    rows = json.loads(kept.read_text()) if kept.exists() else {}
    print(HEADER)
    for name, grid in meshes(arguments, labels):
        row = judge(grid, reference)
        print(line(name, row), flush=True)
        rows[f"{arguments.spacing:g} mm {name}"] = row
        kept.write_text(json.dumps(rows, indent=1))
    draw(json.loads(kept.read_text()), arguments.folder / "forward.svg")


if __name__ == "__main__":
    main()
