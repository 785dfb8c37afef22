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
"""Potentials of unit currents at electrodes by finite elements of first or second order, and what follows from them: by
reciprocity the potential of a dipole at the electrodes, and the field between electrodes."""

import numpy as np
import pyvista
import scipy.sparse
import skfem
from meshes import CORNERS, number_of_corner
from multigrid import Multigrid
from skfem.helpers import dot, grad
from skfem.refdom import RefHex

HEXAHEDRON_IN_VTK = [number_of_corner(corner) for corner in RefHex.p.T]
CELLS_AT_ONCE = 100000  # bounds the memory of assembly
NEWTON_STEPS = 6  # more than enough for hexahedra that are nearly cubes; tetrahedra and cubes take one
TOLERANCE = 1e-7  # of the solver, relative to the load


@skfem.BilinearForm
def stiffness(u, v, w):
    return w.sigma * dot(grad(u), grad(v))


def second_order_mesh(points, cells):
    """Of tetrahedra with ten nodes, which scikit-fem has in the same order as VTK, but numbered by itself."""
    corners, numbers = np.unique(cells[:, :4], return_inverse=True)
    straight = skfem.MeshTet(
        np.ascontiguousarray(points[:, corners]), np.ascontiguousarray(numbers.reshape(-1, 4).T), sort_t=False
    )
    dofs = skfem.assembly.Dofs(straight, skfem.ElementTetP2())
    places = np.zeros((3, dofs.N))
    places[:, dofs.element_dofs] = points[:, cells.T]
    return skfem.MeshTet2(places, straight.t, sort_t=False)


class Samples:
    """Points in cells: the cells' nodes, shape functions (nodes, points) and their gradients (axes, nodes, points)."""

    def __init__(self, conductor, cells, local):
        self.cells = cells
        self.nodes = conductor.nodes[:, cells]
        mapping = conductor.mesh.mapping()
        shapes = [conductor.element.gbasis(mapping, local, n, tind=cells)[0] for n in range(len(self.nodes))]
        self.values = np.stack([np.broadcast_to(s.value[..., 0], len(cells)) for s in shapes])
        self.gradients = np.stack([s.grad[..., 0] for s in shapes], axis=1)

    def value_of(self, nodal):
        """nodal: (nodes, ...); result (points, ...)."""
        return np.einsum("np,np...->p...", self.values, nodal[self.nodes])

    def gradient_of(self, nodal):
        """Result (axes, points, ...)."""
        return np.einsum("anp,np...->ap...", self.gradients, nodal[self.nodes])


class Conductor:
    """A labelled grid in mm as a conductor; everything that goes in and comes out is in m and S/m."""

    def __init__(self, grid, conductivities):
        self.straight = grid  # in which places are looked for
        self.labels = np.asarray(grid["label"]).astype(int)
        self.sigma = np.array([0.0, *conductivities])[self.labels]
        points = np.ascontiguousarray(grid.points.T, float) * 1e-3
        (cells,) = grid.cells_dict.values()
        if cells.shape[1] == len(CORNERS):
            self.mesh = skfem.MeshHex(points, np.ascontiguousarray(cells.T[HEXAHEDRON_IN_VTK], np.int64))
            self.element = skfem.ElementHex1()
        elif cells.shape[1] == 10:
            self.mesh = second_order_mesh(points, cells)
            self.straight = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: cells[:, :4]}, grid.points)
            self.element = skfem.ElementTetP2()
        else:
            self.mesh = skfem.MeshTet(points, np.ascontiguousarray(cells.T, np.int64), sort_t=False)
            self.element = skfem.ElementTetP1()
        self.nodes = skfem.assembly.Dofs(self.mesh, self.element).element_dofs  # of each cell; corners are the first
        self.number_of_nodes = self.nodes.max() + 1
        self.order = 2 if len(self.nodes) == 10 else 1

    def assemble(self):
        matrix = 0
        cells = np.arange(len(self.sigma))
        for part in np.array_split(cells, -(-len(cells) // CELLS_AT_ONCE)):
            basis = skfem.Basis(self.mesh, self.element, elements=part, intorder=2 * self.order)
            matrix += stiffness.assemble(basis, sigma=np.broadcast_to(self.sigma[part, None], basis.dx.shape))
        return matrix.tocsr()

    def locate(self, points, cells):
        """Points that are in cells, or are beside them by no more than rounding."""
        mapping = self.mesh.mapping()
        local = np.full((3, len(points), 1), 0.5)
        for _ in range(NEWTON_STEPS):
            misses = points.T[:, :, None] - mapping.F(local, tind=cells)
            local += np.einsum("ijkl,jkl->ikl", mapping.invDF(local, tind=cells), misses)
        return Samples(self, cells, np.clip(local, 0.0, 1.0))

    def on_surface(self, points):
        """The places of the outer surface that are the nearest to points."""
        skin = self.straight.extract_surface(algorithm="dataset_surface", pass_cellid=True)
        faces, places = skin.find_closest_cell(points * 1e3, return_closest_point=True)
        return self.locate(places * 1e-3, np.asarray(skin["vtkOriginalCellIds"])[faces])

    def within(self, label, points):
        """Points in cells of a label; those that are outside of it go to the nearest place in it."""
        part = self.straight.extract_cells(self.labels == label)
        cells, places = part.find_closest_cell(points * 1e3, return_closest_point=True)
        return self.locate(places * 1e-3, np.asarray(part["vtkOriginalCellIds"])[cells])

    def solve(self, electrodes):
        """Potentials (nodes, electrodes) for 1 A into each electrode, out of all of them in equal parts."""
        at = self.on_surface(electrodes)
        loads = np.zeros((self.number_of_nodes, len(electrodes)))
        np.add.at(loads, (at.nodes, np.arange(len(electrodes))), at.values)
        loads -= loads.mean(axis=1, keepdims=True)
        matrix = self.assemble()
        matrix[0, 0] *= 2.0  # ground at one node: no current goes there, and the solution is unique
        return Multigrid(matrix).solve(loads, TOLERANCE)

    def smooth_gradient(self, label, nodal):
        """Gradients (axes, nodes, ...) at the nodes of a label: the mean of those of its cells there, by their volumes."""
        cells = np.flatnonzero(self.labels == label)
        middle = np.full((3, 1), 0.25 if len(self.mesh.t) == 4 else 0.5)
        volumes = np.abs(self.mesh.mapping().detDF(middle, tind=cells))[:, 0]
        sums, total = 0.0, 0.0
        for node, place in enumerate(self.element.doflocs):
            # elements of first order are the best in the middle
            samples = Samples(self, cells, place[:, None] if self.order > 1 else middle)
            share = scipy.sparse.csr_matrix(
                (volumes, (samples.nodes[node], np.arange(len(cells)))), shape=(self.number_of_nodes, len(cells))
            )
            sums = sums + np.stack([share @ gradient for gradient in samples.gradient_of(nodal)])
            total = total + share.sum(axis=1).A
        return sums / np.maximum(total, np.finfo(float).tiny)


def monopoles(conductor, label, positions, moments, reach=0.02, weight=1e-6):
    """St. Venant's loads: currents (nodes, dipoles) into the nodes around the one of a label that is the nearest.

    They have no sum, the dipole's moment and no second moments, as nearly as they can be, with least currents far away
    (Buchner et al., Phys. Med. Biol. 42, 1997; mixed moments as in Medani et al., Prog. Electromagn. Res. 153, 2015).
    Moments count in units of `reach`, in m."""
    mesh = conductor.mesh
    cells = mesh.t[:, conductor.labels == label]
    ids = np.unique(cells)
    places = mesh.doflocs.T
    cloud = pyvista.PolyData(places[ids])
    owners = scipy.sparse.csr_matrix(
        (np.ones(cells.size, bool), (cells.ravel(), np.tile(np.arange(cells.shape[1]), len(cells)))),
        shape=(mesh.nvertices, cells.shape[1]),
    )
    products = [(a, b) for a in range(3) for b in range(a, 3)]
    rows, columns, currents = [], [], []
    for dipole, (position, moment) in enumerate(zip(positions, moments)):
        nearest = ids[cloud.find_closest_point(position)]
        around = np.unique(cells[:, owners[nearest].indices])
        offset = (places[around] - position) / reach
        equations = np.vstack([np.ones(len(around)), offset.T, *(offset[:, a] * offset[:, b] for a, b in products)])
        wanted = np.concatenate([[0.0], moment / reach, np.zeros(len(products))])
        penalty = weight * np.diag(np.sum(offset**2, axis=1))
        currents.append(np.linalg.solve(equations.T @ equations + penalty, equations.T @ wanted))
        rows.append(around)
        columns.append(np.full(len(around), dipole))
    shape = (conductor.number_of_nodes, len(positions))
    return scipy.sparse.csr_matrix(
        (np.concatenate(currents), (np.concatenate(rows), np.concatenate(columns))), shape=shape
    )
