#!/usr/bin/env python3
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
"""Reads what multimaterial-mesh writes of an oblique, anisotropic image by other people's readers.

These are VTK by pyvista, Gmsh and meshio. All have to find the same points, cells and labels, and the labels have to be
where the image has them. Usage: read-with-others.py PROGRAM
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import gmsh
import meshio
import numpy as np
import pyvista

SIZE = (18, 16, 12)
SPACING = np.array([0.8, 1.1, 1.7])
ORIGIN = np.array([-31.0, 12.5, 7.25])
ROTATION = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
RAS = np.array([-1.0, -1.0, 1.0])
FORMATS = {"vtu": [], "4.1": [], "4.1-ascii": [], "2.2": [], "2.2-ascii": [], "mesh": [], "ras": ["--ras"]}


def write_label_image(name):
    """A ball of label 5 in a block of label 2, as NRRD. Returns the voxels, x first."""
    x, y, z = np.meshgrid(*(np.arange(n) for n in SIZE), indexing="ij")
    labels = np.zeros(SIZE, np.uint8)
    labels[2:-3, 3:-2, 2:-2] = 2
    place = np.stack([x - 8, y - 8, z - 6], axis=-1) * SPACING
    labels[np.linalg.norm(place, axis=-1) < 3.5] = 5
    axes = " ".join("(" + ",".join(repr(float(c)) for c in ROTATION[:, a] * SPACING[a]) + ")" for a in range(3))
    header = (
        "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {' '.join(map(str, SIZE))}\nspace directions: {axes}\n"
        f"space origin: ({','.join(map(str, ORIGIN))})\nencoding: raw\n\n"
    )
    pathlib.Path(name).write_bytes(header.encode() + labels.tobytes(order="F"))
    return labels


class Mesh:
    """Points, and cells with their labels: tetrahedra, and triangles with the numbers of their groups."""

    def __init__(self, points, tetrahedra, labels, triangles=None, groups=None):
        self.points = np.asarray(points, float)
        self.tetrahedra = np.asarray(tetrahedra).astype(int)
        self.labels = np.asarray(labels).astype(int)
        self.triangles = None if triangles is None else np.asarray(triangles).astype(int)
        self.groups = None if groups is None else np.asarray(groups).astype(int)

    def sorted_cells(self, cells, numbers):
        """The cells by their points' places, in an order that does not depend on that of the file."""
        rows = np.column_stack([np.sort(cells, axis=1), numbers])
        return rows[np.lexsort(rows.T)]

    def expect_same(self, other):
        np.testing.assert_array_equal(self.points, other.points)
        np.testing.assert_array_equal(
            self.sorted_cells(self.tetrahedra, self.labels), other.sorted_cells(other.tetrahedra, other.labels)
        )


def read_with_pyvista(name):
    grid = pyvista.read(name)
    return Mesh(grid.points, grid.cells_dict[pyvista.CellType.TETRA], grid["label"])


def read_with_meshio(name):
    mesh = meshio.read(name)
    numbers = mesh.cell_data_dict["medit:ref" if str(name).endswith(".mesh") else "gmsh:physical"]
    return Mesh(
        mesh.points, mesh.cells_dict["tetra"], numbers["tetra"], mesh.cells_dict["triangle"], numbers["triangle"]
    )


def read_with_gmsh(name):
    gmsh.open(str(name))
    tags, points, _ = gmsh.model.mesh.getNodes()
    order = np.argsort(tags)
    place = np.full(int(tags.max()) + 1, -1)
    place[tags[order].astype(int)] = np.arange(len(tags))
    found = {}
    for dimension, corners, kind in ((3, 4, 4), (2, 3, 2)):
        cells, numbers = [], []
        # a .mesh file has entities in place of groups
        groups = gmsh.model.getPhysicalGroups(dimension) or gmsh.model.getEntities(dimension)
        is_grouped = bool(gmsh.model.getPhysicalGroups(dimension))
        for _, group in groups:
            entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, group) if is_grouped else [group]
            for entity in entities:
                types, _, nodes = gmsh.model.mesh.getElements(dimension, entity)
                assert list(types) == [kind], types
                cells.append(place[nodes[0].astype(int)].reshape(-1, corners))
                numbers += [group] * len(cells[-1])
        found[dimension] = np.concatenate(cells), numbers
    gmsh.clear()
    return Mesh(np.reshape(points, (-1, 3))[order], *found[3], *found[2])


def check_places(mesh, labels):
    """Voxels and tetrahedra agree but for what the smooth interfaces cut."""
    indices = ((mesh.points[mesh.tetrahedra].mean(axis=1) - ORIGIN) @ ROTATION) / SPACING
    i, j, k = np.rint(indices).astype(int).T
    share = (labels[i, j, k] == mesh.labels).mean()
    assert share > 0.9, share
    edges = mesh.points[mesh.tetrahedra[:, 1:]] - mesh.points[mesh.tetrahedra[:, :1]]
    volumes = np.linalg.det(edges) / 6.0
    assert volumes.min() > 0.0
    for label in (2, 5):
        expected = (labels == label).sum() * SPACING.prod()
        assert abs(volumes[mesh.labels == label].sum() / expected - 1.0) < 0.1, label


def check_surface(name, mesh, points):
    """The triangles of a surface's file lie on the mesh's points, and there is one for each of its triangles."""
    surface = meshio.read(name)
    assert len(surface.cells_dict["triangle"]) == len(mesh.triangles)
    distances = np.linalg.norm(surface.points[:, None] - points[np.unique(mesh.triangles)], axis=-1).min(axis=1)
    # .stl holds floats
    assert distances.max() < 1e-5, distances.max()


def check_fields(program, image, folder):
    """Names and conductivities, with triangles that have none."""
    conductivity = {2: 0.25, 5: 1.5}
    (folder / "names.txt").write_text("0 outside\n2 gray & white 255 0 51\n5 core\n")
    (folder / "sigma.txt").write_text("gray & white 0.25\n5 1.5\n")
    options = ["--quiet", "--names", folder / "names.txt", "--conductivity", folder / "sigma.txt"]
    names = {"gray & white": (2, 3), "core": (5, 3)}
    for name, extra in (("fields.vtu", []), ("fields.msh", []), ("fields-2.2.msh", ["--msh-format", "2.2"])):
        file = folder / name
        subprocess.run([program, image, file, *options, *extra], check=True)
        # meshio 5.3 splits the data of a file of version 2.2 with several shapes in the wrong places
        if name != "fields-2.2.msh":
            mesh = meshio.read(file)
            assert (
                names.items()
                <= {key: tuple(value) for key, value in mesh.field_data.items() if len(value) == 2}.items()
            )
            labels = mesh.cell_data_dict["label" if name.endswith("vtu") else "gmsh:physical"]["tetra"]
            values = mesh.cell_data_dict["conductivity"]["tetra"].ravel()
            np.testing.assert_array_equal(values, np.vectorize(conductivity.get)(labels))
        if name.endswith("vtu"):
            grid = pyvista.read(file)
            np.testing.assert_array_equal(grid["conductivity"], np.vectorize(conductivity.get)(grid["label"]))
            np.testing.assert_array_equal(grid.field_data["core"], [5, 3])
            np.testing.assert_allclose(np.reshape(grid.field_data["label_colors"], -1), [2, 1, 0, 0.2])
            continue
        gmsh.open(str(file))
        _, tags, values, _, _ = gmsh.view.getModelData(gmsh.view.getTags()[0], 0)
        values = dict(zip(tags.tolist(), np.ravel(values).tolist()))
        for label, value in conductivity.items():
            for entity in gmsh.model.getEntitiesForPhysicalGroup(3, label):
                cells = gmsh.model.mesh.getElements(3, entity)[1][0]
                assert {values[int(cell)] for cell in cells} == {value}, (name, label)
        assert {gmsh.model.getPhysicalName(3, label) for label in conductivity} == set(names)
        gmsh.clear()
    print("names and conductivities are read")


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        labels = write_label_image(folder / "labels.nrrd")
        files = {}
        for key, options in FORMATS.items():
            files[key] = folder / (f"{key}.{key}" if key in ("vtu", "mesh") else f"{key}.msh")
            if key[0].isdigit():
                options = ["--msh-format", key]
            command = [program, folder / "labels.nrrd", files[key], "--quiet", "--report", folder / "report.json"]
            command += ["--surface", folder / "surface.obj"] if key == "mesh" else []
            command += ["--surface", folder / "surface.stl"] if key == "2.2" else []
            subprocess.run(command + options, check=True)
        counts = json.loads((folder / "report.json").read_text())["counts"]

        expected = read_with_pyvista(files["vtu"])
        check_places(expected, labels)
        assert (len(expected.points), len(expected.tetrahedra)) == (counts["points"], counts["tetrahedra"])
        gmsh.initialize()
        gmsh.option.setNumber("General.Verbosity", 2)
        names = {}
        for key in ("4.1", "4.1-ascii", "2.2", "2.2-ascii", "mesh", "ras"):
            for read in (read_with_meshio, read_with_gmsh):
                mesh = read(files[key])
                if key == "ras":
                    mesh.points *= RAS
                mesh.expect_same(expected)
                assert len(mesh.triangles) == counts["triangles"], (key, read.__name__)
                assert len(set(mesh.groups)) == 2, (key, read.__name__, set(mesh.groups))
                print(f"{files[key].name}, {read.__name__}: {len(mesh.tetrahedra)} tetrahedra")
            if key == "4.1":
                gmsh.open(str(files[key]))
                names = {gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups()}
                gmsh.clear()
            if key == "mesh":
                check_surface(folder / "surface.obj", mesh, expected.points)
        check_surface(folder / "surface.stl", read_with_meshio(files["2.2"]), expected.points)
        check_fields(program, folder / "labels.nrrd", folder)
        gmsh.finalize()
        print(f"names in Gmsh: {sorted(names)}")


if __name__ == "__main__":
    main(sys.argv[1])
