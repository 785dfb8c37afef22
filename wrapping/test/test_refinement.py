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
"""Meshes that are refined by the errors of a solution."""

import numpy as np
import pytest

import itk


@pytest.fixture(scope="module")
def ball():
    z, y, x = np.indices((24, 24, 24)) - 11.5
    return (x**2 + y**2 + z**2 < 81).astype(np.uint8)


@pytest.fixture(scope="module")
def coarse(ball):
    return itk.multimaterial_mesh(ball)


def heights(mesh):
    return mesh.points[mesh.tetrahedra].mean(axis=1)[:, 2]


def test_there_are_more_tetrahedra_where_errors_are(ball, coarse):
    errors = np.where(heights(coarse) > 11.5, 1.0, 0.1)
    fine = itk.multimaterial_mesh(ball, refine_by=(coarse, errors), refine_factor=3)
    assert len(fine.tetrahedra) == pytest.approx(3 * len(coarse.tetrahedra), rel=0.3)
    assert (heights(fine) > 15).sum() > 3 * (heights(coarse) > 15).sum()
    assert (heights(fine) < 8).sum() < 1.5 * (heights(coarse) < 8).sum()


def test_files_are_as_good(ball, coarse, tmp_path):
    errors = np.where(heights(coarse) > 11.5, 1.0, 0.1)
    grid = coarse.to_pyvista()
    grid["error"] = errors
    grid.save(tmp_path / "errors.vtu")
    by_file = itk.multimaterial_mesh(ball, refine_by=tmp_path / "errors.vtu")
    by_arrays = itk.multimaterial_mesh(ball, refine_by=(coarse, errors))
    np.testing.assert_array_equal(by_file.points, by_arrays.points)


def test_wrong_errors_are_refused(ball, coarse):
    count = len(coarse.tetrahedra)
    with pytest.raises(RuntimeError, match="errors for"):
        itk.multimaterial_mesh(ball, refine_by=(coarse, np.ones(count - 1)))
    with pytest.raises(RuntimeError, match="at least 0"):
        itk.multimaterial_mesh(ball, refine_by=(coarse, -np.ones(count)))
    with pytest.raises(RuntimeError, match="Factor is 1"):
        itk.multimaterial_mesh(ball, refine_by=(coarse, np.ones(count)), refine_factor=1)
    with pytest.raises(TypeError, match="one number for each tetrahedron"):
        itk.multimaterial_mesh(ball, refine_by=(coarse, np.ones((count, 3))))
