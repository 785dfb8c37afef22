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
"""itk.meshwrite() and itk.meshread() know .vtu once the package is installed, and so do other packages."""

import itk
import numpy as np
import pytest
from conftest import cells_of, labels_of, points_of


def read(mesh_type, file):
    reader = itk.MeshFileReader[mesh_type].New(FileName=str(file))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("compression", [False, True])
def test_tetrahedra_come_back(meshed, tmp_path, compression):
    mesh = meshed.GetOutput()
    file = tmp_path / "mesh.vtu"
    itk.meshwrite(mesh, file, compression=compression)
    again = read(type(mesh), file)
    np.testing.assert_array_equal(points_of(again), points_of(mesh))
    np.testing.assert_array_equal(cells_of(again, 4), cells_of(mesh, 4))
    np.testing.assert_array_equal(labels_of(again), labels_of(mesh))


def test_meshread_gives_a_mesh_of_itks_own_types(meshed, tmp_path):
    """These have coordinates of float."""
    file = tmp_path / "mesh.vtu"
    itk.meshwrite(meshed.GetOutput(), file)
    for mesh in (itk.meshread(file), itk.meshread(file, itk.SS)):
        labels = itk.array_from_vector_container(mesh.GetCellData())
        np.testing.assert_array_equal(labels, labels_of(meshed.GetOutput()))
        np.testing.assert_allclose(points_of(mesh), points_of(meshed.GetOutput()), rtol=1e-6)


@pytest.mark.parametrize("output, data", [("GetSurface", "GetCellData"), ("GetParticles", "GetPointData")])
def test_surface_and_particles_come_back(meshed, tmp_path, output, data):
    mesh = getattr(meshed, output)()
    file = tmp_path / "mesh.vtu"
    itk.meshwrite(mesh, file)
    again = read(type(mesh), file)
    np.testing.assert_array_equal(points_of(again), points_of(mesh))
    np.testing.assert_array_equal(np.asarray(getattr(again, data)()), np.asarray(getattr(mesh, data)()))


def test_surface_has_an_array_for_each_side(meshed, tmp_path):
    file = tmp_path / "surface.vtu"
    itk.meshwrite(meshed.GetSurface(), file)
    text = file.read_text()
    assert 'Name="label_a"' in text and 'Name="label_b"' in text


@pytest.mark.parametrize("compression", [False, True])
def test_pyvista_reads_it(meshed, tmp_path, compression):
    pyvista = pytest.importorskip("pyvista")
    mesh = meshed.GetOutput()
    file = tmp_path / "mesh.vtu"
    itk.meshwrite(mesh, file, compression=compression)
    grid = pyvista.read(file)
    np.testing.assert_array_equal(grid.points, points_of(mesh))
    np.testing.assert_array_equal(grid.cells_dict[pyvista.CellType.TETRA], cells_of(mesh, 4))
    np.testing.assert_array_equal(grid["label"], labels_of(mesh))
    itk.meshwrite(meshed.GetSurface(), file, compression=compression)
    surface = pyvista.read(file)
    sides = np.column_stack([surface["label_a"], surface["label_b"]])
    np.testing.assert_array_equal(sides, np.asarray(meshed.GetSurface().GetCellData()))


@pytest.mark.parametrize("compression", [False, True])
def test_meshio_reads_it(meshed, tmp_path, compression):
    meshio = pytest.importorskip("meshio")
    mesh = meshed.GetOutput()
    file = tmp_path / "mesh.vtu"
    itk.meshwrite(mesh, file, compression=compression)
    again = meshio.read(file)
    np.testing.assert_array_equal(again.points, points_of(mesh))
    np.testing.assert_array_equal(again.cells_dict["tetra"], cells_of(mesh, 4))
    np.testing.assert_array_equal(again.cell_data_dict["label"]["tetra"], labels_of(mesh))


def test_damaged_file_is_refused(tmp_path):
    file = tmp_path / "mesh.vtu"
    file.write_text("<VTKFile type='UnstructuredGrid'>")
    with pytest.raises(RuntimeError, match="Cannot read"):
        itk.meshread(file, itk.F)
