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
"""itk.multimaterial_mesh(): all that it takes, all that it gives, and what it says about all else."""

import copy
import json
import pathlib
import pickle
import re
import subprocess
import sys

import itk
import numpy as np
import pytest
from conftest import ORIGIN, SPACING, cells_of, labels_of, make_image, make_spheres, points_of

INTEGERS = [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64]


@pytest.fixture(scope="module")
def array():
    return itk.array_from_image(make_spheres())


@pytest.fixture(scope="module")
def mesh(spheres):
    return itk.multimaterial_mesh(spheres)


def assert_same(mesh, other):
    np.testing.assert_allclose(mesh.points, other.points, atol=1e-9)
    for name in ("tetrahedra", "labels", "triangles", "triangle_labels"):
        np.testing.assert_array_equal(getattr(mesh, name), getattr(other, name))


def volumes_of(mesh):
    corners = mesh.points[mesh.tetrahedra]
    return np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6.0


def test_is_there_after_import_itk_alone():
    code = "import itk; assert 'multimaterial_mesh' in dir(itk); print(itk.multimaterial_mesh.__doc__)"
    answer = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert "Lengths are in mm" in answer and "Default: 2.5" in answer


def test_is_what_the_filter_makes(mesh, meshed):
    np.testing.assert_array_equal(mesh.points, points_of(meshed.GetOutput()))
    np.testing.assert_array_equal(mesh.tetrahedra, cells_of(meshed.GetOutput(), 4))
    np.testing.assert_array_equal(mesh.labels, labels_of(meshed.GetOutput()))
    np.testing.assert_array_equal(mesh.triangles, cells_of(meshed.GetSurface(), 3))
    np.testing.assert_array_equal(mesh.triangle_labels, labels_of(meshed.GetSurface()))
    assert mesh.report.particles == meshed.GetReport().particles
    assert mesh.report.vanished_labels == {}
    assert [stage.name for stage in mesh.report.stages] == [stage.name for stage in meshed.GetStageRecords()]


def test_triangles_are_all_faces_that_the_tetrahedra_of_one_label_have_once(mesh):
    triangles = {tuple(triangle) for triangle in np.sort(mesh.triangles, axis=1).tolist()}
    found = set()
    for label in (1, 2):
        corners = np.sort(mesh.tetrahedra[mesh.labels == label], axis=1)
        faces, count = np.unique(
            np.concatenate([np.delete(corners, n, axis=1) for n in range(4)]), axis=0, return_counts=True
        )
        found |= {tuple(face) for face in faces[count == 1].tolist()}
    assert triangles == found


@pytest.mark.parametrize("dtype", INTEGERS + [np.float16, np.float32, np.float64, ">i2", ">f8"])
def test_takes_arrays_of_any_type(array, mesh, dtype):
    moved = itk.multimaterial_mesh(array.astype(dtype), SPACING)
    np.testing.assert_allclose(moved.points + ORIGIN, mesh.points, atol=1e-9)
    np.testing.assert_array_equal(moved.tetrahedra, mesh.tetrahedra)
    np.testing.assert_array_equal(moved.labels, mesh.labels)


def test_takes_masks(array):
    mask = array > 0
    whole = itk.multimaterial_mesh(mask, 2.0)
    assert set(whole.labels) == {1}
    assert volumes_of(whole).sum() == pytest.approx(8.0 * mask.sum(), rel=0.15)


def test_takes_what_is_off_whole_numbers_by_rounding(array, mesh):
    scaled = itk.multimaterial_mesh(array * np.float32(0.1) / np.float32(0.1) + 1e-5, SPACING)
    np.testing.assert_array_equal(scaled.labels, mesh.labels)


@pytest.mark.parametrize("layout", [np.asfortranarray, lambda labels: np.flip(np.flip(labels, 0).copy(), 0)])
def test_layout_in_memory_does_not_matter(array, mesh, layout):
    np.testing.assert_array_equal(itk.multimaterial_mesh(layout(array), SPACING).labels, mesh.labels)


def test_does_not_change_the_array(array):
    before = array.copy()
    array.setflags(write=False)
    itk.multimaterial_mesh(array, surface_only=True)
    array.setflags(write=True)
    np.testing.assert_array_equal(array, before)


@pytest.mark.parametrize("spacing", [(1.0, 1.5, 2.0), [1, np.float32(1.5), 2], np.array([1.0, 1.5, 2.0])])
def test_spacing_is_along_x_y_z(array, spacing):
    size = np.ptp(itk.multimaterial_mesh(array, spacing).points, axis=0)
    assert size[1] / size[0] == pytest.approx(1.5, rel=0.1)
    assert size[2] / size[0] == pytest.approx(2.0, rel=0.1)


@pytest.mark.parametrize("dtype", [np.int16, np.int32, np.uint32, np.float32, np.float64])
def test_takes_images_of_any_type(mesh, dtype):
    assert_same(itk.multimaterial_mesh(make_spheres(dtype)), mesh)


def test_takes_filters(spheres, mesh):
    caster = itk.CastImageFilter[type(spheres), itk.Image[itk.F, 3]].New(spheres)
    assert_same(itk.multimaterial_mesh(caster), mesh)


@pytest.mark.parametrize("extension", ["nrrd", "nii.gz", "mha"])
@pytest.mark.parametrize("kind", [str, pathlib.Path])
def test_takes_files(spheres, mesh, tmp_path, extension, kind):
    file = tmp_path / f"läbels.{extension}"
    itk.imwrite(spheres, file)
    assert_same(itk.multimaterial_mesh(kind(file)), mesh)


SHEARED = [[-1.9, 0.3, 0.1, 4.0], [0.2, 2.1, 0.4, -7.0], [0.0, 0.3, 2.4, 9.0], [0.0, 0.0, 0.0, 1.0]]
OBLIQUE = [[-1.2, 1.6, 0.0, 4.0], [1.6, 1.2, 0.0, -7.0], [0.0, 0.0, 2.0, 9.0], [0.0, 0.0, 0.0, 1.0]]


@pytest.mark.parametrize("unit", ["mm", "meter", "micron", "unknown"])
@pytest.mark.parametrize("affine", [OBLIQUE, SHEARED], ids=["oblique", "sheared"])
def test_takes_images_of_nibabel(array, tmp_path, affine, unit):
    """They have the place of the same file, which is that of the voxels in RAS."""
    nibabel = pytest.importorskip("nibabel")
    scale = {"meter": 1e-3, "micron": 1e3}.get(unit, 1.0)
    matrix = np.diag([scale, scale, scale, 1.0]) @ affine
    image = nibabel.Nifti1Image(array.T, matrix)
    image.header.set_xyzt_units(unit)
    image.set_sform(matrix, 1)
    nibabel.save(image, tmp_path / "labels.nii.gz")
    mesh = itk.multimaterial_mesh(nibabel.load(tmp_path / "labels.nii.gz"))
    again = itk.multimaterial_mesh(tmp_path / "labels.nii.gz")
    np.testing.assert_array_equal(again.labels, mesh.labels)
    np.testing.assert_allclose(again.points, mesh.points, atol=1e-4)
    assert volumes_of(mesh).min() > 0.0

    ras = mesh.points * [-1.0, -1.0, 1.0]
    center = (np.asarray(affine) @ [9.5, 10.5, 11.5, 1.0])[:3]
    np.testing.assert_allclose(ras[np.unique(mesh.tetrahedra[mesh.labels == 2])].mean(axis=0), center, atol=1.0)


def test_takes_images_of_nibabel_with_a_fourth_dimension_and_a_scale(array, mesh, tmp_path):
    nibabel = pytest.importorskip("nibabel")
    image = nibabel.Nifti1Image((10 * array.T)[..., None].astype(np.int16), np.diag([*SPACING, 1.0]))
    image.header.set_slope_inter(0.1, 0.0)
    nibabel.save(image, tmp_path / "labels.nii")
    loaded = nibabel.load(tmp_path / "labels.nii")
    assert loaded.dataobj.slope != 1.0
    np.testing.assert_array_equal(itk.multimaterial_mesh(loaded).labels, mesh.labels)


def test_does_not_import_nibabel(tmp_path):
    code = "import itk, numpy, sys; itk.multimaterial_mesh(numpy.eye(8, dtype=int)[None] + numpy.zeros((8, 8, 8)))"
    subprocess.run([sys.executable, "-c", f"{code}; assert 'nibabel' not in sys.modules"], check=True)


@pytest.mark.parametrize(
    "options, same",
    [
        ({"exterior_labels": np.uint8(0)}, {"exterior_labels": [0]}),
        ({"exterior_labels": 2}, {"exterior_labels": (2,)}),
        ({"exterior_labels": np.array([0, 2])}, {"exterior_labels": {0, 2}}),
        ({"exterior_labels": None}, {"exterior_labels": []}),
        ({"chord_tolerance": np.float32(0.0625)}, {"chord_tolerance": 0.0625}),
        ({"seed": np.int64(3)}, {"seed": 3}),
        ({"surface_only": np.True_}, {"surface_only": True}),
        ({"minimum_size": np.int16(4)}, {"minimum_size": 4.0}),
        (
            {"label_sizes": {2: {"factor": 0.5, "max": 2}, np.int64(1): np.float32(3)}},
            {"label_sizes": "2:factor=0.5:max=2,1:max=3"},
        ),
        ({"air_margin": None, "maximum_size": None}, {}),
    ],
)
def test_options_in_several_ways(spheres, mesh, options, same):
    one = itk.multimaterial_mesh(spheres, **options)
    assert_same(one, itk.multimaterial_mesh(spheres, **same))
    assert (len(one.points) == len(mesh.points)) == (not same or same == {"exterior_labels": [0]})


def test_other_options_go_to_the_setters(spheres):
    mesh = itk.multimaterial_mesh(spheres, compare_topology=True)
    with pytest.raises(RuntimeError, match="more than the limit of 10 tetrahedra"):
        itk.multimaterial_mesh(spheres, maximum_number_of_tetrahedra=10)
    sizes = make_image(np.full((24, 22, 20), 1.5, np.float32))
    assert len(itk.multimaterial_mesh(spheres, sizing_image=sizes).labels) > len(mesh.labels)


def test_surface_only(spheres):
    surface = itk.multimaterial_mesh(spheres, surface_only=True)
    assert surface.tetrahedra.shape == (0, 4) and surface.labels.shape == (0,)
    assert surface.triangles.max() + 1 == len(surface.points)
    assert {tuple(pair) for pair in surface.triangle_labels} == {(0, 1), (1, 2)}


def test_types(mesh):
    types = {"points": np.float64, "tetrahedra": np.int64, "labels": np.int32}
    types |= {"triangles": np.int64, "triangle_labels": np.int32}
    for name, dtype in types.items():
        assert getattr(mesh, name).dtype == dtype
    assert re.fullmatch(
        r"<MultiMaterialMesh: \d+ points, \d+ tetrahedra, \d+ triangles between the labels 0, 1, 2>", repr(mesh)
    )


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda mesh: pickle.loads(pickle.dumps(mesh))])
def test_can_be_copied_and_pickled(mesh, again):
    other = again(mesh)
    assert_same(other, mesh)
    assert other.report == mesh.report


def test_is_unpickled_by_another_process(mesh, tmp_path):
    (tmp_path / "mesh").write_bytes(pickle.dumps(mesh))
    code = f"import pickle; print(pickle.load(open({str(tmp_path / 'mesh')!r}, 'rb')))"
    answer = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert answer.strip() == repr(mesh)


def test_to_pyvista(mesh):
    pyvista = pytest.importorskip("pyvista")
    grid, surface = mesh.to_pyvista(), mesh.to_pyvista(surface=True)
    np.testing.assert_array_equal(grid.points, mesh.points)
    np.testing.assert_array_equal(grid.cells_dict[pyvista.CellType.TETRA], mesh.tetrahedra)
    np.testing.assert_array_equal(grid["label"], mesh.labels)
    assert grid.volume == pytest.approx(volumes_of(mesh).sum())
    np.testing.assert_array_equal(surface.regular_faces, mesh.triangles)
    np.testing.assert_array_equal(np.column_stack([surface["label_a"], surface["label_b"]]), mesh.triangle_labels)
    only = copy.copy(mesh)
    only.tetrahedra = only.tetrahedra[:0]
    assert isinstance(only.to_pyvista(), pyvista.PolyData)


def test_to_meshio(mesh, tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh.to_meshio().write(tmp_path / "mesh.vtk")
    again = meshio.read(tmp_path / "mesh.vtk")
    np.testing.assert_array_equal(again.cells_dict["tetra"], mesh.tetrahedra)
    np.testing.assert_array_equal(again.cells_dict["triangle"], mesh.triangles)
    sides = [again.cell_data_dict[name]["triangle"] for name in ("label_a", "label_b")]
    np.testing.assert_array_equal(np.column_stack(sides), mesh.triangle_labels)
    np.testing.assert_array_equal(again.cell_data_dict["label_b"]["tetra"], mesh.labels)


def test_to_meshio_without_tetrahedra(spheres):
    pytest.importorskip("meshio")
    assert set(itk.multimaterial_mesh(spheres, surface_only=True).to_meshio().cells_dict) == {"triangle"}


def test_save_writes_tetrahedra(mesh, meshed, tmp_path):
    mesh.save(tmp_path / "mesh.vtu")
    reader = itk.MeshFileReader[type(meshed.GetOutput())].New(FileName=str(tmp_path / "mesh.vtu"))
    reader.Update()
    np.testing.assert_array_equal(points_of(reader.GetOutput()), mesh.points)
    np.testing.assert_array_equal(cells_of(reader.GetOutput(), 4), mesh.tetrahedra)
    np.testing.assert_array_equal(labels_of(reader.GetOutput()), mesh.labels)


def test_save_writes_triangles(mesh, meshed, tmp_path):
    mesh.save(str(tmp_path / "surface.vtu"), surface=True)
    reader = itk.MeshFileReader[type(meshed.GetSurface())].New(FileName=str(tmp_path / "surface.vtu"))
    reader.Update()
    np.testing.assert_array_equal(cells_of(reader.GetOutput(), 3), mesh.triangles)
    np.testing.assert_array_equal(labels_of(reader.GetOutput()), mesh.triangle_labels)
    only = copy.copy(mesh)
    only.tetrahedra, only.labels = only.tetrahedra[:0], only.labels[:0]
    only.save(tmp_path / "again.vtu")
    assert (tmp_path / "again.vtu").read_bytes() == (tmp_path / "surface.vtu").read_bytes()


@pytest.mark.parametrize("extension", ["vtu", "msh", "mesh", "stl", "obj", "off"])
def test_save_writes_what_the_program_writes(spheres, tmp_path, extension):
    """Byte for byte."""
    program = pathlib.Path(sys.executable).with_name("multimaterial-mesh")
    itk.imwrite(spheres, tmp_path / "labels.nrrd")
    output = (
        ["mesh.vtu", "--surface", f"theirs.{extension}"]
        if extension in ("stl", "obj", "off")
        else [f"theirs.{extension}"]
    )
    subprocess.run([program, "labels.nrrd", *output, "--quiet"], cwd=tmp_path, check=True)
    itk.multimaterial_mesh(tmp_path / "labels.nrrd").save(tmp_path / f"ours.{extension}")
    assert (tmp_path / f"ours.{extension}").read_bytes() == (tmp_path / f"theirs.{extension}").read_bytes()


def test_save_for_simnibs(mesh, tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh.save(tmp_path / "mesh.msh", msh_format="simnibs")
    again = meshio.read(tmp_path / "mesh.msh")
    np.testing.assert_allclose(again.points, mesh.points * [-1.0, -1.0, 1.0])
    assert set(again.cell_data_dict["gmsh:physical"]["tetra"]) == {1, 2}


@pytest.mark.parametrize("name", ["mesh.txt", "missing/mesh.vtu", "mesh"])
def test_save_says_why_not(mesh, tmp_path, name):
    with pytest.raises(RuntimeError, match=name) as error:
        mesh.save(tmp_path / name)
    assert "\n" not in str(error.value) and "ITK ERROR" not in str(error.value)
    assert not list(tmp_path.iterdir())


def test_first_lines_of_the_page(spheres, tmp_path, monkeypatch):
    page = pathlib.Path(__file__).parents[2] / "docs" / "python.md"
    code = re.search(r"```python\n(.*?)```", page.read_text(), re.DOTALL)[1]
    assert code.count("\n") == 3
    itk.imwrite(spheres, tmp_path / "labels.nii.gz")
    monkeypatch.chdir(tmp_path)
    exec(code, {})
    assert (tmp_path / "head.vtu").stat().st_size > 0


def test_report_is_a_page_or_json_by_its_name(spheres, mesh, tmp_path):
    page, numbers = tmp_path / "mesh.html", tmp_path / "mesh.json"
    assert_same(itk.multimaterial_mesh(spheres, report=page), mesh)
    text = page.read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    embedded = json.loads(re.search(r'<script type="application/json" id="report">(.*?)</script>', text, re.S)[1])
    itk.multimaterial_mesh(spheres, report=str(numbers))
    report = json.loads(numbers.read_text())
    assert embedded["counts"] == report["counts"] and embedded["quality"] == report["quality"]
    assert report["counts"]["tetrahedra"] == len(mesh.tetrahedra)
    # the labels' topology is compared
    assert [label["label"] for label in report["topology"]["betti_numbers"]]


def test_report_that_cannot_be_written_says_why(spheres, tmp_path):
    with pytest.raises(RuntimeError, match="cannot write"):
        itk.multimaterial_mesh(spheres, report=tmp_path / "missing/mesh.html")
