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
