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
"""Each mistake gives one exception that says what is wrong."""

import itk
import numpy as np
import pytest
from conftest import make_image, make_spheres


def mesh(image, **settings):
    return itk.label_image_to_tetrahedral_mesh_filter(image, **settings)


def test_image_of_one_value():
    with pytest.raises(RuntimeError, match="single value, 0: there is nothing to mesh"):
        mesh(make_image(np.zeros((5, 5, 5), np.uint8)))


def test_nothing_but_exterior(spheres):
    with pytest.raises(RuntimeError, match="exterior"):
        mesh(spheres, exterior_labels=[0, 1, 2])


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_intensity_image(dtype):
    values = np.linspace(0.0, 900.0, 1000).reshape(10, 10, 10).astype(dtype)
    with pytest.raises(ValueError, match=r"Voxel \(1, 0, 0\) has the value 0.9.*; a label image has whole numbers"):
        mesh(make_image(values))


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_value_that_is_not_finite(value):
    labels = itk.array_from_image(make_spheres(np.float32))
    labels[3, 2, 1] = value
    with pytest.raises(ValueError, match=r"Voxel \(1, 2, 3\) has the value (nan|inf)"):
        mesh(make_image(labels))


def test_label_out_of_range():
    labels = itk.array_from_image(make_spheres(np.float64))
    labels[3, 2, 1] = 2.0**40
    with pytest.raises(ValueError, match="labels have to be from -2147483648 to 2147483647"):
        mesh(make_image(labels))


@pytest.mark.parametrize("dimension", [2, 4])
def test_wrong_dimension(dimension):
    image = itk.image_from_array(np.zeros((4,) * dimension, np.uint8))
    with pytest.raises(TypeError, match=f"has {dimension} dimensions; a three-dimensional label image is needed"):
        mesh(image)


def test_series_from_a_file(tmp_path):
    file = tmp_path / "series.nii.gz"
    itk.imwrite(itk.image_from_array(np.zeros((4, 5, 6, 7), np.int16)), file)
    with pytest.raises(TypeError, match="has 4 dimensions; a three-dimensional label image is needed"):
        mesh(itk.imread(file))


@pytest.mark.parametrize("dtype", [np.int16, np.uint16, np.float32])
def test_t1_image_of_whole_numbers(tmp_path, dtype):
    file = tmp_path / "t1.nii.gz"
    values = np.random.default_rng(1).integers(0, 900, (20, 20, 20)).astype(dtype)
    itk.imwrite(itk.image_from_array(values), file)
    words = "values, from 0 to 899 that change from voxel to voxel, and looks like an intensity image; segment it"
    with pytest.raises(RuntimeError, match=words):
        mesh(itk.imread(file))


def test_mesh_in_place_of_an_image(meshed, tmp_path):
    with pytest.raises(TypeError, match="A label image is needed, not an object of itkMesh"):
        mesh(meshed.GetOutput())
    file = tmp_path / "mesh.vtu"
    itk.meshwrite(meshed.GetOutput(), file)
    with pytest.raises(RuntimeError, match="Could not create IO object for reading file"):
        itk.imread(file)


def test_name_in_place_of_an_image():
    with pytest.raises(TypeError, match=r"not the name of a file; itk.imread\('labels.nrrd'\) reads one"):
        mesh("labels.nrrd")


def test_vectors():
    image = itk.image_from_array(np.zeros((4, 4, 4, 3), np.uint8), is_vector=True)
    with pytest.raises(TypeError, match="several components"):
        mesh(image)


def test_parameter_out_of_range(spheres):
    with pytest.raises(RuntimeError, match="epsilon is -1. It must be positive"):
        mesh(spheres, epsilon=-1.0)


def test_unknown_parameter(spheres):
    with pytest.raises(AttributeError, match="Epsilonn"):
        mesh(spheres, epsilonn=1.0)


def test_sizing_image_of_another_grid(spheres):
    sizes = make_image(np.ones((3, 3, 3), np.float32))
    with pytest.raises(RuntimeError, match="(?i)sizing image"):
        mesh(spheres, sizing_image=sizes)


def test_missing_files(tmp_path):
    with pytest.raises(RuntimeError, match="doesn't exist"):
        itk.imread(tmp_path / "labels.nrrd")
    with pytest.raises(RuntimeError, match="doesn't exist"):
        itk.meshread(tmp_path / "mesh.vtu")


def test_filter_works_again_after_an_error(spheres):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres, epsilon=-1.0)
    with pytest.raises(RuntimeError):
        mesher.Update()
    mesher.SetEpsilon(2.5)
    mesher.Update()
    assert mesher.GetOutput().GetNumberOfCells() > 0
