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
"""Surfaces from files, alone and on top of a label image."""

import itk
import numpy as np
import pytest
from conftest import labels_of, make_image, volumes_of

RADIUS = 8.0


@pytest.fixture
def sphere(tmp_path):
    """The name of a file: a ball around the origin, its points in LPS."""
    steps = 32
    polar, azimuth = np.meshgrid(np.linspace(0, np.pi, steps + 1), np.arange(2 * steps) * np.pi / steps, indexing="ij")
    points = RADIUS * np.stack(
        [np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1
    ).reshape(-1, 3)
    file = tmp_path / "sphere.off"
    lines = [" ".join(map(repr, map(float, point))) for point in points]
    for i in range(steps):
        for j in range(2 * steps):
            a, b = 2 * steps * i + j, 2 * steps * i + (j + 1) % (2 * steps)
            lines += [f"3 {a} {a + 2 * steps} {b}", f"3 {b} {a + 2 * steps} {b + 2 * steps}"]
    file.write_text(f"OFF\n{len(points)} {len(lines) - len(points)} 0\n" + "\n".join(lines) + "\n")
    return str(file)


def read(file):
    reader = itk.SurfaceFileReader.New(file_name=file)
    return reader.Read()


def make_grid(labels=None):
    return make_image(np.zeros((24, 24, 24), np.uint8) if labels is None else labels, (1.0,) * 3, (-11.5,) * 3)


def test_distance_is_that_of_the_sphere(sphere):
    distance = itk.TriangleSurfaceToDistanceImageFilter.New(read(sphere), reference_image=make_grid())
    distance.Update()
    z, y, x = np.mgrid[:24, :24, :24] - 11.5
    known = np.clip(RADIUS - np.sqrt(x**2 + y**2 + z**2), -3.0, 3.0)
    assert np.abs(itk.array_from_image(distance.GetOutput()) - known).max() < 0.1
    assert distance.GetNumberOfBoundaryEdges() == 0
    assert not distance.GetHasOverlaps()


def test_a_surface_goes_on_top_of_labels(sphere):
    labels = np.zeros((24, 24, 24), np.uint8)
    labels[:, :, 12:] = 1
    image = make_grid(labels)
    distance = itk.TriangleSurfaceToDistanceImageFilter.New(read(sphere), reference_image=image)
    distance.Update()
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(image)
    mesher.SetSurfaceDistanceImage(0, distance.GetOutput())
    mesher.SetSurfaceLabels([5])
    mesher.Update()
    tissue = labels_of(mesher.GetOutput())
    assert set(tissue) == {1, 5}
    assert volumes_of(mesher.GetOutput())[tissue == 5].sum() == pytest.approx(4.0 / 3.0 * np.pi * RADIUS**3, rel=0.02)


def test_what_is_no_surface_is_refused(tmp_path):
    file = tmp_path / "quadrilateral.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    with pytest.raises(RuntimeError, match="cell 0 has 4 points; triangulate the surface first"):
        read(str(file))
