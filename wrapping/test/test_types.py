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
"""Checkers of types know itk.multimaterial_mesh() and what it returns."""

import pytest

USE = """
import itk
import numpy as np
import numpy.typing as npt

mesh = itk.multimaterial_mesh("labels.nii.gz", exterior_labels=[0, 5], label_sizes={3: {"max": 2.0}, 7: 1}, seed=2)
mesh.save("head.vtu")
points: npt.NDArray[np.float64] = mesh.points
labels: npt.NDArray[np.int32] = mesh.labels
stages = [stage.seconds for stage in mesh.report.stages]
again: itk.MultiMaterialMesh = itk.multimaterial_mesh(np.zeros((3, 3, 3)), (1.0, 1.0, 2.0), compare_topology=True)
reader = itk.ImageFileReader.New()
"""


@pytest.fixture
def check(tmp_path):
    """The errors of a program, one a line."""
    api = pytest.importorskip("mypy.api")

    def run(program):
        file = tmp_path / "program.py"
        file.write_text(program)
        output, trouble, _ = api.run(["--strict", "--cache-dir", str(tmp_path.parent / "mypy-cache"), str(file)])
        assert trouble == ""
        return [line for line in output.splitlines() if ": error:" in line]

    return run


def test_use_is_right(check):
    assert check(USE) == []


@pytest.mark.parametrize(
    "line",
    [
        "itk.multimaterial_mesh('labels.nii.gz', epsilon='fine')",
        "itk.multimaterial_mesh('labels.nii.gz', exterior_labels=0.5)",
        "itk.multimaterial_mesh('labels.nii.gz', label_sizes=[1.0])",
        "itk.multimaterial_mesh()",
        "mesh.tetraheda",
        "mesh.save(3)",
        "wrong: npt.NDArray[np.int32] = mesh.points",
    ],
)
def test_mistakes_are_found(check, line):
    errors = check(USE + line)
    assert len(errors) == 1 and f"program.py:{USE.count(chr(10)) + 1}: error" in errors[0]
