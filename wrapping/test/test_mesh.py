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
"""What every mesh has to be: conforming, of positive volume, with the image's labels and in the image's place."""

import itk
import numpy as np
import pytest
from conftest import cells_of, faces_of, labels_of, make_image, points_of, volumes_of


@pytest.fixture(params=["meshed", "meshed_head"])
def mesher(request):
    return request.getfixturevalue(request.param)


def test_volumes_are_positive(mesher):
    assert volumes_of(mesher.GetOutput()).min() > 0.0


def test_labels_are_kept(mesher):
    image = itk.array_view_from_image(mesher.GetInput())
    assert set(labels_of(mesher.GetOutput())) == set(np.unique(image)) - {0}
    assert mesher.GetVanishedLabels() == {}


def test_every_point_is_used_and_none_is_twice(mesher):
    mesh = mesher.GetOutput()
    assert len(np.unique(cells_of(mesh, 4))) == mesh.GetNumberOfPoints()
    assert len(np.unique(points_of(mesh), axis=0)) == mesh.GetNumberOfPoints()


def test_tetrahedra_share_whole_faces(mesher):
    """No face has more than two tetrahedra, and those with one bound a closed surface."""
    faces, _ = faces_of(mesher.GetOutput())
    outer, counts = np.unique(faces, axis=0, return_counts=True)
    assert counts.max() == 2
    outer = outer[counts == 1]
    edges = np.concatenate([outer[:, [0, 1]], outer[:, [1, 2]], outer[:, [0, 2]]])
    assert (np.unique(edges, axis=0, return_counts=True)[1] % 2 == 0).all()


def test_surface_is_the_faces_between_labels(mesher):
    mesh, surface = mesher.GetOutput(), mesher.GetSurface()
    count = surface.GetNumberOfPoints()
    np.testing.assert_array_equal(points_of(mesh)[:count], points_of(surface))

    faces, cells = faces_of(mesh)
    _, inverse, counts = np.unique(faces, axis=0, return_inverse=True, return_counts=True)
    inverse = inverse.ravel()
    labels = labels_of(mesh)[cells]
    lower = np.full(len(counts), np.iinfo(np.int32).max)
    upper = np.full(len(counts), np.iinfo(np.int32).min)
    np.minimum.at(lower, inverse, labels)
    np.maximum.at(upper, inverse, labels)
    lower[counts == 1] = mesher.GetOutsideLabel()
    between = (lower != upper)[inverse]
    expected = {tuple(face) + (lower[i], upper[i]) for face, i in zip(faces[between], inverse[between])}

    triangles = np.sort(cells_of(surface, 3).astype(np.int64), axis=1)
    found = {tuple(row) for row in np.hstack([triangles, np.asarray(surface.GetCellData())])}
    assert found == expected


def test_tetrahedra_fill_the_labels(spheres, meshed):
    mesh = meshed.GetOutput()
    image = itk.array_view_from_image(spheres)
    volumes = volumes_of(mesh)
    labels = labels_of(mesh)
    for label in (1, 2):
        voxels = 8.0 * np.count_nonzero(image == label)
        assert volumes[labels == label].sum() == pytest.approx(voxels, rel=0.15)


def test_triangles_point_from_the_lower_label_to_the_higher(meshed):
    surface = meshed.GetSurface()
    corners = points_of(surface)[cells_of(surface, 3)]
    center = np.array([-10.0 + 2 * 9.5, 20.0 + 2 * 10.5, 30.0 + 2 * 11.5])
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outwards = np.einsum("ij,ij->i", normals, corners.mean(axis=1) - center)
    # labels grow towards the center
    assert (outwards < 0.0).all()


ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


@pytest.mark.parametrize(
    "scale, direction",
    [(1.0, ROTATION), (0.25, np.eye(3)), (1.0, np.diag([-1.0, 1.0, 1.0]))],
    ids=["oblique", "other unit", "reflected"],
)
@pytest.mark.parametrize("spacing", [(2.0, 2.0, 2.0), (1.0, 1.5, 2.0)], ids=["isotropic", "anisotropic"])
def test_geometry_moves_the_mesh_only(spheres, spacing, scale, direction):
    labels = itk.array_view_from_image(spheres)
    plain, *_ = itk.label_image_to_tetrahedral_mesh_filter(make_image(labels, spacing, (0.0, 0.0, 0.0)))
    origin = np.array([7.0, -5.0, 100.0])
    moved, *_ = itk.label_image_to_tetrahedral_mesh_filter(
        make_image(labels, [scale * length for length in spacing], origin, direction)
    )
    np.testing.assert_array_equal(labels_of(moved), labels_of(plain))
    np.testing.assert_array_equal(np.sort(cells_of(moved, 4), axis=1), np.sort(cells_of(plain, 4), axis=1))
    np.testing.assert_allclose(points_of(moved), origin + scale * points_of(plain) @ direction.T, atol=1e-9)
    assert volumes_of(moved).min() > 0.0


def test_number_of_threads_does_not_matter(spheres, meshed):
    threads = itk.MultiThreaderBase.GetGlobalDefaultNumberOfThreads()
    itk.MultiThreaderBase.SetGlobalDefaultNumberOfThreads(1)
    try:
        mesh, *_ = itk.label_image_to_tetrahedral_mesh_filter(spheres)
    finally:
        itk.MultiThreaderBase.SetGlobalDefaultNumberOfThreads(threads)
    np.testing.assert_array_equal(points_of(mesh), points_of(meshed.GetOutput()))
    np.testing.assert_array_equal(cells_of(mesh, 4), cells_of(meshed.GetOutput(), 4))
