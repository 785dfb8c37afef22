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
"""The command line program makes the same mesh. MULTIMATERIAL_MESH tells where it is, if it is not on the PATH."""

import os
import shutil
import subprocess

import itk
import numpy as np
import pytest
from conftest import cells_of, labels_of, make_image, points_of

PROGRAM = os.environ.get("MULTIMATERIAL_MESH") or shutil.which("multimaterial-mesh")
ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


@pytest.mark.skipif(not PROGRAM, reason="multimaterial-mesh was not found")
@pytest.mark.parametrize(
    "spacing, direction",
    [((8.0, 8.0, 8.0), np.eye(3)), ((6.0, 8.0, 9.5), ROTATION)],
    ids=["plain", "anisotropic and oblique"],
)
def test_same_mesh(head, tmp_path, spacing, direction):
    file = str(tmp_path / "labels.nrrd")
    itk.imwrite(make_image(itk.array_view_from_image(head), spacing, (3.0, -4.5, 10.0), direction), file)
    subprocess.run(
        [PROGRAM, file, "mesh.vtu", "--surface", "surface.vtu", "--quiet"], cwd=tmp_path, check=True, timeout=60
    )
    # The direction in a file is not the one in memory to the last bit.
    mesh, surface, _ = itk.label_image_to_tetrahedral_mesh_filter(itk.imread(file))
    for ours, name, corners in ((mesh, "mesh.vtu", 4), (surface, "surface.vtu", 3)):
        reader = itk.MeshFileReader[type(ours)].New(FileName=str(tmp_path / name))
        reader.Update()
        theirs = reader.GetOutput()
        np.testing.assert_array_equal(points_of(theirs), points_of(ours))
        np.testing.assert_array_equal(cells_of(theirs, corners), cells_of(ours, corners))
        np.testing.assert_array_equal(labels_of(theirs), labels_of(ours))
