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
"""The meshes that are compared: those of programs, and the voxels themselves."""

import itertools

import numpy as np
import pyvista

# the corners of a voxel in VTK's order of a hexahedron
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])


def number_of_corner(offsets):
    return int(np.flatnonzero((CORNERS == offsets).all(axis=1))[0])


def paths_of_tetrahedra():
    """Six tetrahedra that fill a voxel: each follows three edges from the first corner to the opposite one."""
    steps = np.eye(3, dtype=int)
    return np.array(
        [
            [number_of_corner(steps[list(axes[:n])].sum(axis=0)) for n in range(4)]
            for axes in itertools.permutations(range(3))
        ]
    )


def make_grid(points, cells, labels):
    """A grid without the points that no cell has."""
    used, numbers = np.unique(cells, return_inverse=True)
    kind = pyvista.CellType.TETRA if cells.shape[1] == 4 else pyvista.CellType.HEXAHEDRON
    grid = pyvista.UnstructuredGrid({kind: numbers.reshape(cells.shape)}, points[used])
    grid["label"] = labels
    return grid


def shift_of_corners(labels):
    """How far, in voxels, corners move towards the middle of what few of the eight voxels around them are.

    The part is 0.33 of the way, as is usual (Wolters et al., IEEE Trans. Biomed. Eng. 54, 2007); 0.5 would degenerate.
    Corners at which no label is rarer than all others stay."""
    padded = np.pad(labels, 1)
    around = np.stack(
        [padded[tuple(slice(o, o + n + 1) for o, n in zip(offset, labels.shape))] for offset in CORNERS], axis=-1
    )
    kinds = np.unique(labels)
    counts = np.stack([(around == kind).sum(axis=-1) for kind in kinds], axis=-1)
    counts[counts == 0] = len(CORNERS) + 1
    fewest = counts.min(axis=-1)
    moves = ((counts == fewest[..., None]).sum(axis=-1) == 1) & (fewest < len(CORNERS))
    rare = around[moves] == kinds[counts[moves].argmin(axis=-1)][:, None]
    shift = np.zeros((*moves.shape, 3))
    shift[moves] = 0.33 * (rare @ (CORNERS - 0.5)) / rare.sum(axis=1, keepdims=True)
    return shift


def voxel_grid(labels, origin, spacing, kind):
    """The voxels that are not 0, as "hexahedra", as hexahedra "shifted" towards rare labels, or as "tetrahedra".

    labels: array of [z, y, x]; origin: of the first voxel's centre, the same in x, y and z; in mm."""
    labels = labels.transpose()
    shape = np.array(labels.shape) + 1
    places = np.stack(np.indices(shape), axis=-1).astype(float)
    if kind == "shifted":
        places += shift_of_corners(labels)
    points = origin + (places.reshape(-1, 3) - 0.5) * spacing
    voxels = np.argwhere(labels)
    cells = np.ravel_multi_index(np.moveaxis(voxels[:, None] + CORNERS, -1, 0), shape)
    inside = labels[tuple(voxels.T)]
    if kind == "tetrahedra":
        paths = paths_of_tetrahedra()
        cells = cells[:, paths].reshape(-1, 4)
        inside = np.repeat(inside, len(paths))
    return make_grid(points, cells, inside)
