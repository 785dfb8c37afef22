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
"""Hulls of labels: closed, in one piece, and around all that the labels fill."""

import itk
import numpy as np
import pytest
from conftest import cells_of, labels_of, make_image, points_of, volumes_of


def hull_of(surface, *labels):
    hull = itk.LabelHullMeshFilter.New(surface, labels=list(labels))
    hull.Update()
    return hull


def edges_of(triangles):
    """Each triangle's edges, in the direction that it goes round."""
    return np.vstack([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)


def enclosed_volume(mesh):
    """By the divergence theorem; negative if normals point inward."""
    return np.linalg.det(points_of(mesh)[cells_of(mesh, 3)]).sum() / 6.0


def number_of_components(triangles):
    group = np.arange(triangles.max() + 1)
    while True:
        least = group.copy()
        np.minimum.at(least, triangles, group[triangles].min(axis=1, keepdims=True))
        if (least == group).all():
            return len(np.unique(group[triangles]))
        group = least


def check_closed_and_connected(mesh):
    edges = [tuple(edge) for edge in edges_of(cells_of(mesh, 3))]
    assert len(set(edges)) == len(edges)
    assert {(b, a) for a, b in edges} == set(edges)
    assert number_of_components(cells_of(mesh, 3)) == 1


@pytest.mark.parametrize("labels", [(2,), (1, 2)])
def test_hull_of_nested_labels_is_closed_and_holds_them(meshed, labels):
    mesh = hull_of(meshed.GetSurface(), *labels).GetOutput()
    check_closed_and_connected(mesh)
    assert set(labels_of(mesh)[:, 0]) <= set(labels)
    inside = np.isin(labels_of(meshed.GetOutput()), labels)
    assert enclosed_volume(mesh) == pytest.approx(volumes_of(meshed.GetOutput())[inside].sum(), rel=1e-9)


def test_cavity_is_left_out(meshed):
    """The shell's hull is that of the shell and what it holds."""
    shell, ball = (hull_of(meshed.GetSurface(), *labels).GetOutput() for labels in ((1,), (1, 2)))
    assert enclosed_volume(shell) == pytest.approx(enclosed_volume(ball), rel=1e-12)
    assert shell.GetNumberOfCells() == ball.GetNumberOfCells()


def test_hull_counts_what_it_leaves_out():
    labels = np.zeros((12, 12, 24), np.uint8)
    labels[3:9, 3:9, 3:10] = 5
    labels[4:8, 4:8, 15:19] = 5
    _, surface, _ = itk.label_image_to_tetrahedral_mesh_filter(make_image(labels))
    hull = hull_of(surface, 5)
    check_closed_and_connected(hull.GetOutput())
    assert hull.GetNumberOfOtherParts() == 1
    assert (hull.GetNumberOfPinchedEdges(), hull.GetNumberOfPinchedPoints(), hull.GetNumberOfHandles()) == (0, 0, 0)
    voxels = 6 * 6 * 7 * 8.0
    assert 0.8 * voxels < enclosed_volume(hull.GetOutput()) < 1.05 * voxels


def test_ring_has_a_handle():
    labels = np.zeros((10, 18, 18), np.uint8)
    labels[3:7, 2:16, 2:16] = 1
    labels[:, 7:11, 7:11] = 0
    _, surface, _ = itk.label_image_to_tetrahedral_mesh_filter(make_image(labels))
    assert hull_of(surface, 1).GetNumberOfHandles() == 1


def test_hull_by_a_function(meshed):
    hull = itk.label_hull_mesh_filter(meshed.GetSurface(), labels=[1, 2])
    assert hull.GetNumberOfCells() == hull_of(meshed.GetSurface(), 1, 2).GetOutput().GetNumberOfCells()


def test_hull_of_nothing_is_an_error(meshed):
    with pytest.raises(RuntimeError, match="None of the labels of the hull has a surface"):
        hull_of(meshed.GetSurface(), 7)
