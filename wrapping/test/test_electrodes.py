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
"""Electrodes from a file, as exact shapes on top of labels."""

import json

import itk
import numpy as np
import pytest
from conftest import labels_of, make_image

RADIUS = 12.0


def make_ball():
    z, y, x = np.mgrid[:32, :32, :32] - 15.5
    return make_image((x**2 + y**2 + z**2 < RADIUS**2).astype(np.uint8), (1.0,) * 3, (-15.5,) * 3)


def write(path, **changes):
    disc = {"name": "Cz", "label": 101, "shape": "disc", "radius": 4, "thickness": 2, "position": [0, 0, 13], **changes}
    path.write_text(json.dumps({"space": "LPS", "electrodes": [disc]}))
    return str(path)


def test_a_disc_has_its_contact_area(tmp_path):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(make_ball())
    mesher.SetElectrodes(write(tmp_path / "cap.json"))
    mesher.Update()
    (report,) = mesher.GetElectrodeReports()
    cap = 2.0 * np.pi * RADIUS * (RADIUS - np.sqrt(RADIUS**2 - 16.0))
    assert report.name == "Cz"
    assert report.contact_area == pytest.approx(cap, rel=0.015)
    assert report.expected_area == pytest.approx(cap, rel=0.015)
    assert set(labels_of(mesher.GetOutput())) == {1, 101}


def test_a_dictionary_is_taken_as_a_file_is(tmp_path):
    name = write(tmp_path / "cap.json")
    electrodes = json.loads(open(name).read())
    electrodes["electrodes"][0]["position"] = np.array([0.0, 0.0, 13.0])
    meshes = [itk.multimaterial_mesh(make_ball(), electrodes=given) for given in (name, electrodes)]
    assert meshes[1].names == {101: "Cz"}
    assert np.array_equal(meshes[0].points, meshes[1].points)
    electrodes["electrodes"][0]["radius"] = -1
    with pytest.raises(RuntimeError, match=r"electrodes\[0\].radius: -1 mm is not positive"):
        itk.multimaterial_mesh(make_ball(), electrodes=electrodes)


def test_reports_have_the_electrodes(tmp_path):
    files = [str(tmp_path / "report.json"), str(tmp_path / "report.html")]
    for file in files:
        itk.multimaterial_mesh(make_ball(), electrodes=write(tmp_path / "cap.json"), report=file)
    (electrode,) = json.loads(open(files[0]).read())["electrodes"]
    assert electrode["name"] == "Cz"
    assert electrode["contact_area_mm2"] == pytest.approx(electrode["expected_area_mm2"], rel=0.015)
    assert ">Electrodes</h2>" in open(files[1]).read()


def test_names_are_those_of_the_file(tmp_path):
    mesh = itk.multimaterial_mesh(make_ball(), electrodes=write(tmp_path / "cap.json"))
    assert mesh.names == {101: "Cz"}
    assert set(mesh.labels) == {1, 101}


def test_errors_tell_the_place_in_the_file(tmp_path):
    with pytest.raises(RuntimeError, match=r"cap.json: electrodes\[0\].radius: -1 mm is not positive"):
        itk.multimaterial_mesh(make_ball(), electrodes=write(tmp_path / "cap.json", radius=-1))
    with pytest.raises(RuntimeError, match=r"cap.json: electrodes\[0\].label: the image has the label 1 already"):
        itk.multimaterial_mesh(make_ball(), electrodes=write(tmp_path / "cap.json", label=1))
