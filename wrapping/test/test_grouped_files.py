"""Gmsh and Medit files: labels are groups and references."""

import itk
import numpy as np
import pytest
from conftest import cells_of, labels_of, points_of


@pytest.mark.parametrize("extension", ["msh", "mesh"])
def test_tetrahedra_come_back(meshed, tmp_path, extension):
    mesh = meshed.GetOutput()
    file = tmp_path / f"tetrahedra.{extension}"
    itk.meshwrite(mesh, file)
    reader = itk.MeshFileReader[type(mesh)].New(FileName=str(file))
    reader.Update()
    again = reader.GetOutput()
    np.testing.assert_array_equal(points_of(again), points_of(mesh))
    np.testing.assert_array_equal(cells_of(again, 4), cells_of(mesh, 4))
    np.testing.assert_array_equal(labels_of(again), labels_of(mesh))
