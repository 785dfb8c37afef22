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
"""The command line program of the package makes the same mesh, and so does the one that MULTIMATERIAL_MESH names."""

import importlib.metadata
import os
import subprocess
import sysconfig

import itk
import numpy as np
import pytest
from conftest import cells_of, labels_of, make_image, points_of

PACKAGED = os.path.join(sysconfig.get_path("scripts"), "multimaterial-mesh")
PROGRAMS = [PACKAGED] + [os.environ[name] for name in ["MULTIMATERIAL_MESH"] if os.environ.get(name)]
ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])


@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize(
    "spacing, direction",
    [((8.0, 8.0, 8.0), np.eye(3)), ((6.0, 8.0, 9.5), ROTATION)],
    ids=["plain", "anisotropic and oblique"],
)
def test_same_mesh(head, tmp_path, spacing, direction, program):
    file = str(tmp_path / "labels.nrrd")
    itk.imwrite(make_image(itk.array_view_from_image(head), spacing, (3.0, -4.5, 10.0), direction), file)
    subprocess.run(
        [program, file, "mesh.vtu", "--surface", "surface.vtu", "--quiet"], cwd=tmp_path, check=True, timeout=60
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


def test_program_has_the_version_of_the_package():
    answer = subprocess.run([PACKAGED, "--version"], check=True, capture_output=True, text=True).stdout
    assert importlib.metadata.version("itk-multimaterialmeshing") in answer.split()


def test_second_program_is_there(tmp_path, head):
    optimizer = os.path.join(sysconfig.get_path("scripts"), "optimize-tetrahedral-mesh")
    itk.imwrite(head, str(tmp_path / "labels.nrrd"))
    subprocess.run([PACKAGED, "labels.nrrd", "mesh.vtu", "--quiet"], cwd=tmp_path, check=True)
    subprocess.run([optimizer, "mesh.vtu", "better.vtu"], cwd=tmp_path, check=True)
    assert (tmp_path / "better.vtu").exists()


def test_exit_code_and_message_come_through():
    result = subprocess.run([PACKAGED, "no-such-image.nrrd", "mesh.vtu"], capture_output=True, text=True)
    assert result.returncode == 1
    assert result.stderr.count("\n") == 1 and "no-such-image.nrrd" in result.stderr


def test_licences_are_in_the_package():
    package = importlib.metadata.distribution("itk-multimaterialmeshing")
    names = {file.name for file in package.files if "licenses" in file.parts}
    assert names == {"LICENSE", "NOTICE", "LICENSE.TetGen"}
    assert package.metadata["License-Expression"] == "Apache-2.0 AND AGPL-3.0-or-later"
