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
"""Meshes of second order."""

import copy

import itk
import numpy as np
import pytest

# in VTK's order of mid-nodes
EDGES = np.array([[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]])


@pytest.fixture(scope="module")
def mesh(spheres):
    return itk.multimaterial_mesh(spheres, element_order=2)


def test_first_order_has_no_mid_nodes(spheres):
    mesh = itk.multimaterial_mesh(spheres)
    assert mesh.mid_nodes is None and mesh.mid_node_edges is None
    assert mesh.report.curving.volumes == {}


def test_is_what_the_filter_makes(mesh, spheres):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres, ElementOrder=2)
    mesher.Update()
    mid_nodes = mesher.GetMidNodes()
    np.testing.assert_array_equal(itk.array_from_vector_container(mid_nodes.GetPoints()), mesh.mid_nodes)
    np.testing.assert_array_equal(np.asarray(mid_nodes.GetPointData()), mesh.mid_node_edges)


def test_mid_nodes_are_those_of_edges_of_triangles(mesh):
    edges = {tuple(edge) for edge in np.sort(mesh.triangles[:, EDGES[:3]].reshape(-1, 2)).tolist()}
    assert {tuple(edge) for edge in mesh.mid_node_edges.tolist()} <= edges
    curving = mesh.report.curving
    assert len(mesh.mid_nodes) == curving.edges - curving.without_place - curving.inverting
    assert set(curving.volumes) == {1, 2}
    assert curving.smallest_jacobian > 0.0


def test_quadratic_has_one_node_for_each_edge(mesh):
    points, tetrahedra, triangles = mesh.quadratic()
    edges = np.sort(tetrahedra[:, EDGES].reshape(-1, 2))
    pairs = np.unique(np.column_stack([edges, tetrahedra[:, 4:].reshape(-1)]), axis=0)
    assert len(pairs) == len(np.unique(edges, axis=0)) == len(points) - len(mesh.points)
    np.testing.assert_array_equal(tetrahedra[:, :4], mesh.tetrahedra)
    np.testing.assert_array_equal(triangles[:, :3], mesh.triangles)
    places = {tuple(pair[:2]): points[pair[2]] for pair in pairs.tolist()}
    for edge, place in zip(mesh.mid_node_edges.tolist(), mesh.mid_nodes):
        np.testing.assert_array_equal(places.pop(tuple(edge)), place)
    for edge, place in places.items():
        np.testing.assert_allclose(place, mesh.points[list(edge)].mean(axis=0))


@pytest.mark.parametrize("again", [copy.deepcopy, copy.copy])
def test_can_be_copied(mesh, again):
    np.testing.assert_array_equal(again(mesh).mid_nodes, mesh.mid_nodes)


@pytest.mark.parametrize("name", ["mesh.vtu", "mesh.msh"])
def test_save_writes_the_same_elements(mesh, tmp_path, name):
    meshio = pytest.importorskip("meshio")
    mesh.save(tmp_path / name)
    again = meshio.read(tmp_path / name)
    points, tetrahedra, _ = mesh.quadratic()
    if name.endswith(".msh"):
        # group by group
        tetrahedra = tetrahedra[np.argsort(mesh.labels, kind="stable")]
    np.testing.assert_allclose(again.points[again.cells_dict["tetra10"]], points[tetrahedra], atol=1e-12)


def test_to_meshio_and_pyvista_have_nodes_of_second_order(mesh):
    meshio, pyvista = pytest.importorskip("meshio"), pytest.importorskip("pyvista")
    assert isinstance(mesh.to_meshio(), meshio.Mesh)
    assert set(mesh.to_meshio().cells_dict) == {"tetra10", "triangle6"}
    grid = mesh.to_pyvista()
    assert set(grid.cells_dict) == {pyvista.CellType.QUADRATIC_TETRA}


def test_other_orders_are_refused(spheres):
    with pytest.raises(RuntimeError, match="The element order is 3. It must be 1 or 2."):
        itk.multimaterial_mesh(spheres, element_order=3)


def test_files_of_first_order_are_refused(mesh, tmp_path):
    with pytest.raises(RuntimeError, match="cannot have elements of second order"):
        mesh.save(tmp_path / "mesh.mesh")
