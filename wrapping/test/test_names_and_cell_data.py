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
"""Names of labels, and numbers of tetrahedra."""

import itk
import numpy as np
import pytest
from conftest import make_spheres


@pytest.fixture(scope="module")
def mesh(spheres):
    return itk.multimaterial_mesh(spheres, names={1: "shell", 2: "core"})


def group_names_of(file):
    io = itk.GmshMeshIO.New(FileName=str(file))
    io.ReadMeshInformation()
    text = file.read_bytes().partition(b"$EndPhysicalNames")[0].decode()
    return [line.partition('"')[2].rstrip('"') for line in text.splitlines() if '"' in line]


def test_names_reach_files(mesh, tmp_path):
    assert mesh.names == {1: "shell", 2: "core"}
    mesh.save(tmp_path / "mesh.msh")
    assert {"shell", "core", "shell|core", "label 0|shell"} <= set(group_names_of(tmp_path / "mesh.msh"))


def test_names_are_read_and_found(tmp_path):
    image = tmp_path / "x_dseg.nii.gz"
    itk.imwrite(make_spheres(), image)
    (tmp_path / "x_dseg.tsv").write_text("index\tname\tcolor\n1\tshell\t#ff0000\n2\tcore\tn/a\n")
    (tmp_path / "names.json").write_text('{"1": "rind"}')
    assert itk.multimaterial_mesh(image).names == {1: "shell", 2: "core"}
    assert itk.multimaterial_mesh(image, names=tmp_path / "names.json").names == {1: "rind"}
    assert itk.multimaterial_mesh(image, names={}).names == {}
    reader = itk.LabelTableReader.New(FileName=str(tmp_path / "x_dseg.tsv"))
    reader.Read()
    table = reader.GetLabelTable()
    assert list(table[1].color) == [1.0, 0.0, 0.0] and table[2].color is None


def test_broken_table_is_one_line(spheres, tmp_path):
    (tmp_path / "names.txt").write_text("1 shell\nx\n")
    with pytest.raises(RuntimeError, match=r"^\S*names.txt: line 2 is not LABEL NAME") as error:
        itk.multimaterial_mesh(spheres, names=tmp_path / "names.txt")
    assert "\n" not in str(error.value)


def test_image_is_sampled_where_the_mesh_is(mesh, spheres, tmp_path):
    array = itk.array_from_image(spheres)
    ramp = itk.image_from_array(np.indices(array.shape)[2].astype(np.float32))
    ramp.CopyInformation(spheres)
    x = (mesh.points[mesh.tetrahedra].mean(axis=1)[:, 0] - spheres.GetOrigin()[0]) / spheres.GetSpacing()[0]
    np.testing.assert_allclose(mesh.sample(ramp), x, atol=1e-4)
    np.testing.assert_allclose(mesh.sample(ramp, "linear"), x, atol=1e-4)
    itk.imwrite(ramp, tmp_path / "ramp.nrrd")
    np.testing.assert_array_equal(mesh.sample(tmp_path / "ramp.nrrd"), mesh.sample(ramp))
    with pytest.raises(RuntimeError, match="no mode 'median'"):
        mesh.sample(ramp, "median")


def test_numbers_of_tetrahedra_reach_files(mesh, tmp_path):
    mesh.cell_data["conductivity"] = np.where(mesh.labels == 2, 1.79, 0.33)
    mesh.cell_data["tensor"] = np.broadcast_to(np.eye(3), (len(mesh.labels), 3, 3))
    mesh.save(tmp_path / "mesh.vtu")
    text = (tmp_path / "mesh.vtu").read_text()
    assert 'Name="conductivity"' in text
    assert 'Name="tensor" NumberOfComponents="9"' in text
    with pytest.raises(RuntimeError, match="cannot have data of tetrahedra"):
        mesh.save(tmp_path / "mesh.mesh")
