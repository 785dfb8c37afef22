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
# =========================================================================
"""Label images and what all tests ask of meshes. The tests run on the installed package."""

import itk
import numpy as np
import pytest

SPACING = (2.0, 2.0, 2.0)
ORIGIN = (-10.0, 20.0, 30.0)


def pytest_configure(config):
    # SWIG's own types, in all of ITK
    config.addinivalue_line("filterwarnings", "ignore:builtin type .* has no __module__ attribute")


def make_spheres(dtype=np.uint8):
    """A ball of label 2 in a ball of label 1, with a geometry that is not the default one."""
    z, y, x = np.mgrid[:24, :22, :20]
    distance = np.sqrt((x - 9.5) ** 2 + (y - 10.5) ** 2 + (z - 11.5) ** 2)
    labels = np.zeros(distance.shape, dtype)
    labels[distance < 8.0] = 1
    labels[distance < 4.5] = 2
    return make_image(labels)


def make_image(labels, spacing=SPACING, origin=ORIGIN, direction=None):
    image = itk.image_from_array(labels)
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    if direction is not None:
        image.SetDirection(np.asarray(direction, float))
    return image


def make_head(size=(23, 28, 23), spacing=8.0):
    """Ellipsoids in each other, as scalp, skull, fluid and folded gray and white matter, and a pocket of air."""
    z, y, x = np.meshgrid(*(spacing * (np.arange(n) - (n - 1) / 2) for n in reversed(size)), indexing="ij")
    radius = np.sqrt(x**2 + (y / 1.2) ** 2 + z**2)
    folds = 4.0 * np.sin(0.2 * x) * np.sin(0.2 * y) * np.sin(0.2 * z)
    labels = np.zeros(radius.shape, np.uint8)
    for label, outside in enumerate((86.0, 74.0, 62.0), 1):
        labels[radius < outside] = label
    for label, outside in enumerate((52.0, 36.0), 4):
        labels[radius + folds < outside] = label
    labels[x**2 + (y + 88.0) ** 2 + z**2 < 16.0**2] = 6
    return make_image(labels, [spacing] * 3)


@pytest.fixture(scope="session")
def spheres():
    return make_spheres()


@pytest.fixture(scope="session")
def meshed(spheres):
    """The filter for the whole pipeline, updated."""
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres)
    mesher.KeepIntermediatesOn()
    mesher.Update()
    return mesher


@pytest.fixture(scope="session")
def head():
    return make_head()


@pytest.fixture(scope="session")
def meshed_head(head):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(head)
    mesher.Update()
    return mesher


def points_of(mesh):
    return itk.array_from_vector_container(mesh.GetPoints())


def cells_of(mesh, corners):
    """The corners' points, a cell per row. ITK's array has each cell's type and number of corners before them."""
    return itk.array_from_vector_container(mesh.GetCellsArray()).reshape(-1, corners + 2)[:, 2:]


def labels_of(mesh):
    return np.asarray(mesh.GetCellData())


def volumes_of(mesh):
    corners = points_of(mesh)[cells_of(mesh, 4)]
    return np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6.0


FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])


def faces_of(mesh):
    """All faces of the tetrahedra, four a row of cells_of(), each sorted, and the cell that each belongs to."""
    cells = cells_of(mesh, 4).astype(np.int64)
    faces = np.sort(cells[:, FACES].reshape(-1, 3), axis=1)
    return faces, np.repeat(np.arange(len(cells)), 4)
