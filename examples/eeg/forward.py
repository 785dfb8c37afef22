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
"""The potential of a current dipole in a labelled tetrahedral mesh, by finite elements of first order (scikit-fem).

The potential is split in that of the dipole in an unbounded conductor, which is known, and the rest, which is smooth and
is solved for ("full subtraction"). The dipole should be a few millimeters from the next change of conductivity.
"""

import json
import pathlib
import shutil
import subprocess

import numpy as np
import pyvista
import skfem
from scipy.sparse.linalg import LinearOperator, cg
from skfem.helpers import dot, grad


# of the synthetic head, in mm, LPS
FIDUCIALS = {"nasion": [0, -95, -10], "inion": [0, 99, -10], "left": [79, 0, -10], "right": [-79, 0, -10]}


def write_electrodes(name, electrodes, fiducials=None):
    """The file of electrodes that stand at sites, by the fiducials of another JSON file or those of the synthetic head."""
    places = json.loads(pathlib.Path(fiducials).read_text()) if fiducials else FIDUCIALS
    name.write_text(json.dumps({"space": "LPS", "fiducials": places, "electrodes": electrodes}, indent=1))
    return places


def find_program(name, program=None):
    """The path that was given, or the program on the PATH, or the one that was built in this checkout."""
    built = pathlib.Path(__file__).resolve().parents[2] / "build" / "bin" / name
    return program or shutil.which(name) or str(built)


def labels_or_phantom(labels, folder, spacing="2"):
    """The label image that was given, or a synthetic head of such voxels, in mm."""
    if labels:
        return labels
    phantom = folder / "head.nrrd"
    subprocess.run([find_program("make-head-phantom"), str(phantom), spacing], check=True)
    return phantom


def mesh_images(program, images, output, *options):
    """Runs multimaterial-mesh."""
    subprocess.run([program, *map(str, images), str(output), *options], check=True)
    return pyvista.read(output)


def solve(grid, conductivities, position, moment):
    """The potential in V at the points of a mesh in mm.

    conductivities: S/m by label; position in mm, within a tetrahedron; moment in A m."""
    tetrahedra = grid.cells_dict[pyvista.CellType.TETRA]
    mesh = skfem.MeshTet(
        np.ascontiguousarray(grid.points.T, float) * 1e-3, np.ascontiguousarray(tetrahedra.T, np.int64)
    )
    position = np.asarray(position, float) * 1e-3
    moment = np.asarray(moment, float)
    sigma = np.array([conductivities[label] for label in grid["label"]])
    source = sigma[mesh.element_finder()(*position.reshape(3, 1))[0]]

    def free_gradient(x):
        """The gradient of the potential in an unbounded conductor, times the conductivity there."""
        r = x - position.reshape(3, *[1] * (x.ndim - 1))
        # the dipole may be where the integrand is asked for; there it does not count, as the conductivity is the source's
        distance = np.maximum(np.sqrt(np.sum(r**2, axis=0)), 1e-9)
        along = np.einsum("i,i...->...", moment, r)
        direction = moment.reshape(3, *[1] * (x.ndim - 1))
        return (direction / distance**3 - 3 * along * r / distance**5) / (4 * np.pi)

    @skfem.BilinearForm
    def stiffness(u, v, w):
        return w.sigma * dot(grad(u), grad(v))

    @skfem.LinearForm
    def inner_source(v, w):
        return (1 - w.sigma / source) * dot(free_gradient(w.x), grad(v))

    @skfem.LinearForm
    def boundary_source(v, w):
        return -dot(free_gradient(w.x), w.n) * v

    basis = skfem.Basis(mesh, skfem.ElementTetP1(), intorder=3)
    constant = basis.with_element(skfem.ElementTetP0())
    matrix = stiffness.assemble(basis, sigma=constant.interpolate(sigma))
    load = inner_source.assemble(basis, sigma=constant.interpolate(sigma))
    load += boundary_source.assemble(skfem.FacetBasis(mesh, skfem.ElementTetP1(), intorder=3))
    load -= load.mean()

    diagonal = matrix.diagonal()
    preconditioner = LinearOperator(matrix.shape, lambda r: r / diagonal)
    rest, failed = cg(matrix, load, rtol=1e-8, maxiter=20000, M=preconditioner)
    if failed:
        raise RuntimeError("The conjugate gradients did not converge.")
    r = mesh.p - position[:, None]
    potential = rest + moment @ r / (4 * np.pi * source * np.sum(r**2, axis=0) ** 1.5)
    return potential - potential.mean()


def skin_of(grid):
    """The outer surface with the potential that the mesh has at its points."""
    return grid.extract_surface(algorithm="dataset_surface", pass_pointid=True)
