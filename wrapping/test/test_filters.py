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
"""The filters in Python: what goes in, what comes out, and that the numbers arrive in NumPy."""

import gc

import itk
import numpy as np
import pytest
from conftest import cells_of, labels_of, make_spheres, points_of, volumes_of


@pytest.mark.parametrize("dtype", [np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.float32, np.float64])
def test_takes_labels_of_any_type(meshed, dtype):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(make_spheres(dtype))
    mesher.Update()
    mesh = mesher.GetOutput()
    assert labels_of(mesh).dtype == np.int32
    np.testing.assert_array_equal(labels_of(mesh), labels_of(meshed.GetOutput()))
    np.testing.assert_array_equal(points_of(mesh), points_of(meshed.GetOutput()))


@pytest.mark.parametrize("pixel_type", [itk.SS, itk.F])
def test_takes_filters_as_input(spheres, meshed, pixel_type):
    caster = itk.CastImageFilter[type(spheres), itk.Image[pixel_type, 3]].New(spheres)
    mesh, *_ = itk.label_image_to_tetrahedral_mesh_filter(caster)
    np.testing.assert_array_equal(points_of(mesh), points_of(meshed.GetOutput()))


def test_labels_need_not_be_small():
    labels = make_spheres(np.int32)
    values = itk.array_view_from_image(labels)
    values[values == 2] = 2_000_000
    values[values == 1] = -7
    mesh, surface, _ = itk.label_image_to_tetrahedral_mesh_filter(labels)
    assert set(labels_of(mesh)) == {-7, 2_000_000}
    assert {tuple(pair) for pair in np.asarray(surface.GetCellData())} == {(-7, 0), (-7, 2_000_000)}


def test_functional_interface_returns_all_outputs(spheres, meshed):
    mesh, surface, particles = itk.label_image_to_tetrahedral_mesh_filter(spheres)
    np.testing.assert_array_equal(points_of(mesh), points_of(meshed.GetOutput()))
    assert surface.GetNumberOfCells() == meshed.GetSurface().GetNumberOfCells()
    assert particles.GetNumberOfPoints() == surface.GetNumberOfPoints()


def test_functional_interface_takes_arrays_and_settings(spheres):
    mesh, surface, _ = itk.label_image_to_tetrahedral_mesh_filter(
        itk.array_view_from_image(spheres), exterior_labels=[0, 2], epsilon=4.0, surface_only=True
    )
    assert mesh.GetNumberOfCells() == 0
    assert labels_of(mesh).shape == (0,)
    assert {tuple(pair) for pair in np.asarray(surface.GetCellData())} == {(0, 1)}


def test_settings(spheres):
    coarse = itk.LabelImageToTetrahedralMeshFilter.New(spheres, epsilon=4.0, minimum_size=6.0)
    coarse.SetExteriorLabels([0, 2])
    coarse.Update()
    assert set(labels_of(coarse.GetOutput())) == {1}
    assert coarse.GetEpsilon() == 4.0
    assert list(coarse.GetExteriorLabels()) == [0, 2]


def test_data_are_views_that_outlive_the_mesh(spheres):
    mesh, surface, _ = itk.label_image_to_tetrahedral_mesh_filter(spheres)
    labels, sides = labels_of(mesh), np.asarray(surface.GetCellData())
    assert not labels.flags.owndata and not sides.flags.owndata
    labels[0] = 77
    assert labels_of(mesh)[0] == 77
    copies = [array.copy() for array in (labels, sides)]
    del mesh, surface
    gc.collect()
    itk.label_image_to_tetrahedral_mesh_filter(spheres, surface_only=True)
    for array, copy in zip((labels, sides), copies):
        np.testing.assert_array_equal(array, copy)


def test_points_can_be_viewed_and_moved(spheres):
    mesh, *_ = itk.label_image_to_tetrahedral_mesh_filter(spheres)
    view = itk.array_view_from_vector_container(mesh.GetPoints())
    view += 5.0
    np.testing.assert_array_equal(points_of(mesh), view)


def test_data_of_another_type_are_copies(meshed):
    labels = meshed.GetOutput().GetCellData()
    assert np.asarray(labels, float).dtype == float
    assert np.array(labels).flags.owndata


def test_particles(meshed):
    particles = meshed.GetParticles()
    data = np.asarray(particles.GetPointData())
    assert data.shape == (particles.GetNumberOfPoints(), 5)
    assert set(data[:, 0]) <= {0, 1, 2}


def test_junctions(spheres):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres)
    mesher.SetExteriorLabels([])
    mesher.Update()
    data = np.asarray(mesher.GetJunctions().GetCellData())
    assert data.shape == (mesher.GetJunctions().GetNumberOfCells(), 6)
    # eight corners and twelve edges of the image's box
    assert (data[:, 0] == -1).sum() == 8
    assert set(data[:, 0]) == set(range(-1, 12))


def test_reports(meshed):
    assert list(meshed.GetLabels()) == [0, 1, 2]
    assert meshed.GetOutsideLabel() == 0
    assert meshed.GetVanishedLabels() == {}
    assert meshed.GetIslandRecords()[2].voxels_after > 0
    assert meshed.GetReport().particles[2] > 0
    stages = meshed.GetStageRecords()
    assert len(stages) > 3
    assert all(stage.name and stage.seconds >= 0.0 for stage in stages)


def test_intermediate_images(spheres, meshed):
    indicator = meshed.GetIndicatorImage(2)
    middle = indicator.TransformPhysicalPointToIndex(spheres.TransformIndexToPhysicalPoint([10, 10, 11]))
    assert indicator.GetPixel(middle) > 0.0
    assert itk.array_view_from_image(meshed.GetComputedSizingImage()).min() > 0.0


def test_sizing_image(spheres):
    sizes = itk.image_from_array(np.full((24, 22, 20), 2.5, np.float32))
    sizes.CopyInformation(spheres)
    fine, *_ = itk.label_image_to_tetrahedral_mesh_filter(spheres, sizing_image=sizes)
    corners = points_of(fine)[cells_of(fine, 4)]
    assert np.linalg.norm(corners[:, 0] - corners[:, 1], axis=1).mean() < 3.5


def test_stages_one_by_one(spheres, meshed):
    merged = itk.merge_label_islands_image_filter(spheres)
    indicators = itk.LabelImageToIndicatorImagesFilter.New(merged)
    indicators.Update()
    labels = list(indicators.GetLabels())
    assert labels == [0, 1, 2]

    sizing = itk.IndicatorImagesToSizingImageFilter.New()
    mesher = itk.IndicatorImagesToMeshFilter.New()
    for n, label in enumerate(labels):
        image = indicators.GetOutputForLabel(label)
        sizing.SetInput(n, image)
        mesher.SetInput(n, image)
    sizing.SetExteriorIndex(0)
    sizing.Update()
    mesher.SetSizingImage(sizing.GetOutput())
    mesher.SetLabels(labels)
    mesher.SetExteriorIndex(0)
    mesher.Update()
    assert mesher.GetOutput().GetNumberOfCells() == pytest.approx(meshed.GetOutput().GetNumberOfCells(), rel=0.1)


def test_island_is_merged_and_recorded(spheres):
    labels = itk.array_from_image(spheres)
    labels[1, 1, 1] = 2
    merger = itk.MergeLabelIslandsImageFilter.New(itk.image_from_array(labels))
    merger.Update()
    assert itk.array_view_from_image(merger.GetOutput())[1, 1, 1] == 0
    record = merger.GetRecords()[2]
    assert (record.components, record.voxels) == (1, 1)
    assert record.destinations == {0: 1}


def test_quality(meshed):
    mesh = meshed.GetOutput()
    calculator = itk.TetrahedralMeshQualityCalculator[type(mesh)].New(Mesh=mesh)
    calculator.Compute()
    assert calculator.GetNumberOfTetrahedra() == mesh.GetNumberOfCells()
    assert 0.0 < calculator.GetMinimumDihedralAngle() < calculator.GetMaximumDihedralAngle() < 180.0
    report = calculator.GetReport()
    assert [label.label for label in report.labels] == [1, 2]
    assert report.tetrahedra.non_positive == 0
    assert report.labels[1].components == 1
    assert "radius ratio" in report.table


def test_progress(spheres):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres)
    seen = []
    mesher.AddObserver(
        itk.ProgressEvent(),
        lambda: seen.append((mesher.GetProgress(), mesher.GetCurrentStage(), mesher.GetStageProgress())),
    )
    mesher.Update()
    progress = [event[0] for event in seen]
    assert progress == sorted(progress)
    assert progress[-1] == pytest.approx(1.0, abs=0.01)
    assert len({event[1] for event in seen}) > 3
    assert all(0.0 <= event[2] <= 1.0 for event in seen)


def test_after_a_stock_filter(spheres, meshed):
    """Filters of ITK's own packages and of this one share their threads."""

    def cast(pixel_type):
        return itk.cast_image_filter(spheres, ttype=(type(spheres), itk.Image[pixel_type, 3]))

    mesh = itk.label_image_to_tetrahedral_mesh_filter(cast(itk.SS))[0]
    assert itk.array_view_from_image(cast(itk.F)).max() == 2.0
    np.testing.assert_array_equal(points_of(mesh), points_of(meshed.GetOutput()))


def test_sizes_of_labels_and_regions(spheres, meshed):
    count = meshed.GetOutput().GetNumberOfCells()
    finer = itk.LabelImageToTetrahedralMeshFilter.New(spheres, label_sizes="1:max=1")
    finer.Update()
    assert finer.GetOutput().GetNumberOfCells() > count
    assert finer.GetLabelSizes()[1].maximum_size == 1.0
    mask = itk.image_from_array(np.ones_like(itk.array_view_from_image(spheres), dtype=np.uint8))
    mask.CopyInformation(spheres)
    inside = itk.LabelImageToTetrahedralMeshFilter.New(spheres, region_of_interest=mask, region_maximum_size=1.0)
    inside.Update()
    assert inside.GetOutput().GetNumberOfCells() > count


@pytest.mark.xfail(strict=True, reason="too low for labels of few voxels, which are sampled finely, see docs/sizing.md")
def test_expected_size(meshed):
    expected = meshed.GetReport().estimate.tetrahedra
    assert expected == pytest.approx(meshed.GetOutput().GetNumberOfCells(), rel=0.5)


def test_expected_size_is_limited(spheres):
    with pytest.raises(RuntimeError, match="more than the limit of 10 tetrahedra"):
        itk.label_image_to_tetrahedral_mesh_filter(spheres, maximum_number_of_tetrahedra=10)


def test_exterior_is_filled(spheres):
    mesh, *_ = itk.label_image_to_tetrahedral_mesh_filter(spheres, fill_exterior=True)
    assert volumes_of(mesh).sum() == pytest.approx(itk.array_view_from_image(spheres).size * 8.0)
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres, air_margin=3.0)
    mesher.Update()
    assert 0 in set(labels_of(mesher.GetOutput()))
    size = mesher.GetMeshedRegion().GetSize()
    assert volumes_of(mesher.GetOutput()).sum() == pytest.approx(np.prod([int(n) for n in size]) * 8.0)


def test_largest_volume(spheres, meshed):
    largest = volumes_of(meshed.GetOutput()).max()
    mesh, *_ = itk.label_image_to_tetrahedral_mesh_filter(spheres, maximum_volume=0.5 * largest)
    assert volumes_of(mesh).max() <= 0.5 * largest


def test_sizing_image_replaces(spheres, meshed):
    sizes = itk.image_from_array(np.full((24, 22, 20), 5.0, np.float32))
    sizes.CopyInformation(spheres)
    coarse, *_ = itk.label_image_to_tetrahedral_mesh_filter(spheres, sizing_image=sizes, sizing_image_replaces=True)
    assert 0 < coarse.GetNumberOfCells() < meshed.GetOutput().GetNumberOfCells()


SETTINGS = {
    "air_margin": 2.0,
    "allow_vanished_labels": True,
    "chord_tolerance": 0.3,
    "epsilon": 2.0,
    "exterior_labels": (0, 2),
    "fill_exterior": True,
    "gradient_limit": 0.4,
    "keep_intermediates": True,
    "keep_slices": True,
    "maximum_memory": 4.0,
    "maximum_number_of_tetrahedra": 1000,
    "maximum_size": 9.0,
    "maximum_volume": 30.0,
    "minimum_island_size": 5,
    "minimum_size": 3.0,
    "radius": 0.7,
    "region_maximum_size": 6.0,
    "region_minimum_size": 4.0,
    "seed": 7,
    "sizing_image_replaces": True,
    "surface_only": True,
}


@pytest.mark.parametrize("name", SETTINGS)
def test_every_setting_is_kept(spheres, name):
    value = SETTINGS[name]
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres, **{name: value})
    assert getattr(mesher, "Get" + name.title().replace("_", ""))() == value


def test_takes_probability_maps():
    z, y, x = np.mgrid[:24, :22, :20]
    distance = np.sqrt((x - 9.3) ** 2 + (y - 10.6) ** 2 + (z - 11.4) ** 2)
    ball = 1 / (1 + np.exp(2 * (distance - 7.0)))
    maps = [itk.image_from_array(values.astype(np.float32)) for values in (ball * (z < 12), ball * (z >= 12))]
    mesh, surface, particles = itk.indicator_images_to_tetrahedral_mesh_filter(*maps, indicator_labels=[4, 9])
    assert set(labels_of(mesh)) == {4, 9}
    assert {tuple(pair) for pair in np.asarray(surface.GetCellData())} == {(0, 4), (0, 9), (4, 9)}
    edges = np.diff(points_of(mesh)[cells_of(mesh, 4)], axis=1)
    volume = np.abs(np.linalg.det(edges)).sum() / 6
    assert abs(volume / (4 / 3 * np.pi * 7.0**3) - 1) < 0.02


def test_probability_maps_on_different_grids_are_an_error():
    maps = [itk.image_from_array(np.random.rand(8, 8, n).astype(np.float32)) for n in (8, 9)]
    with pytest.raises(RuntimeError, match="must be on the same grid"):
        itk.indicator_images_to_tetrahedral_mesh_filter(*maps)


def test_optimizes_meshes(meshed):
    mesh = meshed.GetOutput()
    optimizer = itk.OptimizeTetrahedralMeshFilter[type(mesh)].New(mesh)
    optimizer.SetMaximumNumberOfRounds(2)
    optimizer.Update()
    optimized = optimizer.GetOutput()
    assert set(labels_of(optimized)) == set(labels_of(mesh))
    assert optimizer.GetLargestTolerance() > 0.0
    worst = []
    for each in (mesh, optimized):
        calculator = itk.TetrahedralMeshQualityCalculator[type(each)].New(Mesh=each)
        calculator.Compute()
        worst.append(calculator.GetMinimumDihedralAngle())
    assert worst[1] >= worst[0] - 1e-9


def test_optimizes_meshes_by_a_function(meshed):
    mesh = meshed.GetOutput()
    optimized = itk.optimize_tetrahedral_mesh_filter(
        mesh, tolerance=0.2, feature_angle=50.0, maximum_number_of_rounds=1
    )
    assert volumes_of(optimized).sum() == pytest.approx(volumes_of(mesh).sum(), rel=0.01)
    with pytest.raises(RuntimeError, match="Tolerance is -1; it has to be positive"):
        itk.optimize_tetrahedral_mesh_filter(mesh, tolerance=-1.0)


def test_exterior_of_probability_maps_is_filled():
    z, y, x = np.mgrid[:16, :16, :16]
    ball = 1 / (1 + np.exp(2 * (np.sqrt((x - 7.5) ** 2 + (y - 7.5) ** 2 + (z - 7.5) ** 2) - 5.0)))
    mesh, *_ = itk.indicator_images_to_tetrahedral_mesh_filter(
        itk.image_from_array(ball.astype(np.float32)), fill_exterior=True, maximum_size=3.0
    )
    assert set(labels_of(mesh)) == {0, 1}
    assert volumes_of(mesh).sum() == pytest.approx(16.0**3)
