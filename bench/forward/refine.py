#!/usr/bin/env python3
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
"""usage: refine.py [--spacing MM] [--factor F] [--rounds N] [--labels L[,L...]] [--folder out] [--program multimaterial-mesh]

Refines by the errors of a solution: solves for the field between pairs of electrodes on the spheres of compare.py, estimates
the error in each tetrahedron by a smoother gradient, has the mesh refined by that, and solves again. Beside each of these
meshes stands one that is finer everywhere and has as many tetrahedra.
"""

import argparse
import pathlib

import compare
import numpy as np
import spheres
from compare import find_program, judge, line, mesh_images
from solution import Conductor, Samples


def errors_of(grid, reference, labels):
    """The norm over each tetrahedron of the difference between the gradient and a smoother one, in the norm of the power
    that is lost; 0 in other labels. All pairs of electrodes count alike."""
    conductor = Conductor(grid, spheres.CONDUCTIVITIES)
    potentials = conductor.solve((reference.electrodes + spheres.MIDDLE) * 1e-3)
    pairs = np.stack([potentials[:, a] - potentials[:, b] for a, b in reference.pairs], axis=1)
    squares = np.zeros(grid.n_cells)
    for label in labels:
        cells = np.flatnonzero(conductor.labels == label)
        smooth = conductor.smooth_gradient(label, pairs)
        own = Samples(conductor, cells, np.full((3, 1), 0.25)).gradient_of(pairs)
        for corner in conductor.mesh.t[:, cells]:
            squares[cells] += np.sum((smooth[:, corner] - own) ** 2, axis=(0, 2)) / 4
    volumes = np.abs(grid.compute_cell_sizes(length=False, area=False)["Volume"])
    return np.sqrt(conductor.sigma * squares * volumes)


def main():
    parser = argparse.ArgumentParser(description="Meshes of four spheres, refined by the errors of solutions.")
    parser.add_argument("--spacing", type=float, default=2.0, metavar="MM", help="of the voxels (default: %(default)s)")
    parser.add_argument("--factor", type=float, default=2.0, help="of the number of tetrahedra (default: %(default)s)")
    parser.add_argument("--rounds", type=int, default=2, help="of refinement (default: %(default)s)")
    parser.add_argument("--labels", default="1,2,3,4", help="in which errors count (default: %(default)s)")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()
    program = find_program("multimaterial-mesh", arguments.program)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    labels = arguments.folder / "spheres.nrrd"
    spheres.write_labels(labels, arguments.spacing)
    reference = spheres.Reference()

    def mesh(name, *options):
        grid = mesh_images(program, [labels], arguments.folder / "refined.vtu", "--quiet", *options)
        print(line(f"{name}, {grid.n_cells:,} tetrahedra", judge(grid, reference)), flush=True)
        return grid

    print(compare.HEADER)
    grid = mesh("defaults")
    field = arguments.folder / "errors.vtu"
    for round_ in range(1, arguments.rounds + 1):
        grid["error"] = errors_of(grid, reference, map(int, arguments.labels.split(",")))
        grid.save(field)
        grid = mesh(f"refined {round_}", "--refine-by", str(field), "--refine-factor", str(arguments.factor))
        mesh("finer everywhere", "--tetrahedra", str(grid.n_cells))


if __name__ == "__main__":
    main()
