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
"""What itk.multimaterial_mesh() does not take: one exception in one line, which says what is taken."""

from types import SimpleNamespace

import itk
import numpy as np
import pytest
from conftest import make_spheres


@pytest.fixture
def array():
    return itk.array_from_image(make_spheres())


def fails(error, words, *arguments, **options):
    with pytest.raises(error, match=words) as raised:
        itk.multimaterial_mesh(*arguments, **options)
    text = str(raised.value)
    assert "\n" not in text and "ITK ERROR" not in text and ".hxx" not in text and "0x" not in text
    return text


TAKEN = "give a NumPy array, an itk.Image, an image of nibabel or the name of a file"


@pytest.mark.parametrize("labels", [None, 3, [[[0, 1]]], {"labels": 1}, object(), itk.Image])
def test_labels_of_a_wrong_type(labels):
    fails(TypeError, TAKEN, labels)


@pytest.mark.parametrize("dtype", [complex, "U1", object, "datetime64[s]"])
def test_arrays_of_a_wrong_type(dtype):
    fails(TypeError, "labels are integers, bool or whole numbers", np.zeros((3, 3, 3), dtype))


@pytest.mark.parametrize("shape", [(), (5,), (5, 5), (5, 5, 5, 2)])
def test_arrays_of_a_wrong_dimension(shape):
    fails(TypeError, f"has {len(shape)} dimensions; one with three is needed", np.zeros(shape, np.uint8))


def test_image_of_a_wrong_dimension():
    fails(
        TypeError, "has 2 dimensions; a three-dimensional label image", itk.image_from_array(np.zeros((5, 5), np.uint8))
    )


def test_mesh_in_place_of_labels(meshed):
    fails(TypeError, "A label image is needed, not an object of itkMesh", meshed.GetOutput())


@pytest.mark.parametrize("value", [0.5, np.nan, np.inf, 2.0**31])
def test_values_that_are_no_labels(array, value):
    labels = array.astype(float)
    labels[3, 2, 1] = value
    fails(ValueError, r"Voxel \(1, 2, 3\) has the value (0.5|nan|inf|2147483648.0); ", labels)


def test_integers_out_of_range(array):
    labels = array.astype(np.uint64)
    labels[3, 2, 1] = 2**40
    fails(ValueError, r"Voxel \(1, 2, 3\) has the value 1099511627776; labels have to be from", labels)


def test_empty_array():
    fails(RuntimeError, "a single value: there is nothing to mesh", np.zeros((0, 3, 3), np.uint8))


@pytest.mark.parametrize("spacing", ["1", (1.0, 2.0), [[1.0]], (1, None, 1)])
def test_spacing_of_a_wrong_type(array, spacing):
    fails(TypeError, "a length in mm, or three along x, y and z, is taken", array, spacing)


@pytest.mark.parametrize("spacing", [0, -1.0, (1.0, 1.0, np.nan)])
def test_spacing_of_a_wrong_value(array, spacing):
    fails(ValueError, "lengths are positive", array, spacing)


def test_spacing_of_an_image(spheres):
    fails(TypeError, "A spacing is taken with an array only", spheres, 2.0)


@pytest.mark.parametrize("step", [0.0, np.nan])
def test_affine_without_a_place(array, step):
    image = SimpleNamespace(dataobj=array.T, affine=np.diag([1.0, step, 1.0, 1.0]), header=None)
    fails(ValueError, "its affine is singular", image)


@pytest.mark.parametrize(
    "name, value, words",
    [
        ("epsilon", "fine", "a number is taken"),
        ("epsilon", [1.0], "a number is taken"),
        ("surface_only", "yes", "True or False is taken"),
        ("seed", 1.5, "a whole number, at least 0, is taken"),
        ("seed", -1, "a whole number, at least 0, is taken"),
        ("minimum_island_size", "8", "a whole number, at least 0, is taken"),
        ("exterior_labels", "0", "a whole number, or some of them, or None is taken"),
        ("exterior_labels", 1.5, "a whole number, or some of them, or None is taken"),
        ("exterior_labels", [0, None], "a whole number, or some of them, or None is taken"),
        ("label_sizes", 2.0, "a dictionary by label is taken"),
        ("label_sizes", {1: {"maximum": 2.0}}, "a dictionary of numbers named factor, min, max is taken"),
        ("label_sizes", {1: "2"}, "a dictionary of numbers named factor, min, max is taken"),
        ("label_sizes", {"skin": 2.0}, "by label, a number"),
        ("sizing_image", 3.0, "an itk.Image of the right type of pixels is taken"),
        ("epsilonn", 1.0, "has no option epsilonn"),
    ],
)
def test_options_of_a_wrong_type(spheres, name, value, words):
    assert name in fails(TypeError, words, spheres, **{name: value})


def test_errors_of_the_filter(spheres, array):
    assert fails(RuntimeError, "epsilon is -1. It must be positive", spheres, epsilon=-1.0)[0] != "/"
    fails(RuntimeError, "single value, 0: there is nothing to mesh", np.zeros_like(array))
    fails(RuntimeError, "Sizes are given for 9, which is no label here", spheres, label_sizes={9: 2.0})


def test_errors_of_files(tmp_path):
    fails(RuntimeError, "no-such-file.nii.gz", tmp_path / "no-such-file.nii.gz")
    file = tmp_path / "labels.nrrd"
    file.write_text("NRRD")
    fails(RuntimeError, "labels.nrrd", str(file))
    itk.imwrite(itk.image_from_array(np.linspace(0.0, 1.0, 1000).reshape(10, 10, 10)), file)
    fails(RuntimeError, "a label image has integer values", str(file))
