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
"""Takes a mesh to solvers by the commands of docs/file-formats.md, and has the volume of each label from the other end.

usage: reach-solvers.py PROGRAM

Labels are not numbered from 1, so that none is right by chance. A solver that is not installed is left out with a
message, or is an error where CI is "true".
"""

import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

import gmsh
import meshio
import numpy as np
import pyvista
import skfem

LABELS = (2, 3, 4, 5)
RADII = (8.5, 6.5, 4.5, 2.5)  # voxels
SIZE = 20
PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "file-formats.md"
# What the program writes, by its options; the commands of ROUTES and the solvers take it from there.
FILES = {"mesh.vtu": [], "mesh.msh": [], "mesh.mesh": [], "mesh-2.2.msh": ["--msh-format", "2.2"]}

CALCULIX = """*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=TISSUE
*ELASTIC
1, 0.3
{sections}
*NSET, NSET=FIXED
1, 2, 3, 4
*BOUNDARY
FIXED, 1, 3
*STEP
*STATIC
{prints}
*END STEP
"""
FREEFEM = """mesh3 Th("mesh.mesh");
cout.precision(17);
{prints}
"""
GETDP = """Group {{ Whole = Region[{{{labels}}}]; }}
Jacobian {{ {{ Name Vol; Case {{ {{ Region Whole; Jacobian Vol; }} }} }} }}
Integration {{ {{ Name One; Case {{ {{ Type Gauss; Case {{
  {{ GeoElement Tetrahedron; NumberOfPoints 1; }} }} }} }} }} }}
FunctionSpace {{ {{ Name V; Type Form0; BasisFunction {{
  {{ Name s; NameOfCoef c; Function BF_Node; Support Whole; Entity NodesOf[All]; }} }} }} }}
Formulation {{ {{ Name F; Type FemEquation; Quantity {{ {{ Name v; Type Local; NameOfSpace V; }} }}
  Equation {{ Galerkin {{ [ Dof{{d v}}, {{d v}} ]; In Whole; Jacobian Vol; Integration One; }} }} }} }}
Resolution {{ {{ Name R; System {{ {{ Name A; NameOfFormulation F; }} }}
  Operation {{ InitSolution[A]; SaveSolution[A]; }} }} }}
PostProcessing {{ {{ Name P; NameOfFormulation F; Quantity {{
  {{ Name volume; Value {{ Integral {{ [1]; In Whole; Jacobian Vol; Integration One; }} }} }} }} }} }}
PostOperation {{ {{ Name O; NameOfPostProcessing P; Operation {{ {prints} }} }} }}
"""


def write_label_image(name):
    """Balls in each other, the innermost one with the lowest label, as NRRD."""
    x = np.arange(SIZE) - 0.5 * (SIZE - 1)
    distance = np.sqrt(x[:, None, None] ** 2 + x[:, None] ** 2 + x**2)
    labels = np.zeros(distance.shape, np.uint8)
    for label, radius in zip(reversed(LABELS), RADII):
        labels[distance < radius] = label
    header = f"NRRD0004\ntype: uchar\ndimension: 3\nsizes: {SIZE} {SIZE} {SIZE}\nencoding: raw\n\n"
    pathlib.Path(name).write_bytes(header.encode() + labels.tobytes())


def run(*command):
    """What a command prints, which has to succeed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"{shlex.join(command)}: {done.stdout}")
    return done.stdout


def for_each_label(text):
    return "\n".join(text.format(label) for label in LABELS)


def sum_volumes(points, tetrahedra, labels):
    edges = points[tetrahedra[:, 1:]] - points[tetrahedra[:, :1]]
    volumes = np.abs(np.linalg.det(edges.astype(float))) / 6.0
    return {int(label): volumes[labels == label].sum() for label in np.unique(labels)}


def read_with_meshio(name, data):
    """data: the array that has the labels; or of MED, whose families are named after groups."""
    mesh = meshio.read(name)
    labels = mesh.cell_data_dict[data]["tetra"]
    if data == "cell_tags":
        labels = np.array([int(mesh.cell_tags[tag][0].split()[-1]) for tag in labels])
    return sum_volumes(mesh.points, mesh.cells_dict["tetra"], labels)


def read_nastran():
    bulk = pathlib.Path("mesh.bdf").read_text()
    pathlib.Path("job.bdf").write_text("BEGIN BULK\n" + bulk)
    return read_with_meshio("job.bdf", "nastran:ref")


def read_unv():
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    gmsh.open("mesh.unv")
    tags, points, _ = gmsh.model.mesh.getNodes()
    places = np.zeros(int(tags.max()) + 1, int)
    places[tags.astype(int)] = np.arange(len(tags))
    found = {}
    for group in gmsh.model.getPhysicalGroups(3):
        for entity in gmsh.model.getEntitiesForPhysicalGroup(*group):
            corners = places[gmsh.model.mesh.getElements(3, entity)[2][0].astype(int)].reshape(-1, 4)
            found.update(sum_volumes(np.reshape(points, (-1, 3)), corners, np.full(len(corners), group[1])))
    gmsh.finalize()
    return found


def read_exodus():
    """Blocks are in the order of the labels."""
    blocks = pyvista.read("mesh.e")["Element Blocks"]
    return {label: block.compute_cell_sizes()["Volume"].sum() for label, block in zip(LABELS, blocks, strict=True)}


def read_skfem():
    mesh = skfem.MeshTet.load("mesh.msh")
    one = skfem.Functional(lambda w: 1.0 + 0.0 * w.x[0])
    return {label: one.assemble(skfem.Basis(mesh, skfem.ElementTetP0(), elements=f"label {label}")) for label in LABELS}


def read_calculix():
    pathlib.Path("job.inp").write_text(
        CALCULIX.format(
            sections=for_each_label("*SOLID SECTION, ELSET=label_{0}, MATERIAL=TISSUE"),
            prints=for_each_label("*EL PRINT, ELSET=label_{0}, TOTALS=ONLY\nEVOL"),
        )
    )
    run("ccx", "-i", "job")
    words = pathlib.Path("job.dat").read_text().split()
    return dict(zip(LABELS, map(float, words[8::9]), strict=True))


def read_freefem():
    pathlib.Path("job.edp").write_text(FREEFEM.format(prints=for_each_label("cout << int3d(Th, {0})(1.) << endl;")))
    lines = run("FreeFem++-nw", "-nw", "-v", "0", "job.edp").split()
    return dict(zip(LABELS, map(float, lines), strict=True))


def read_getdp():
    prints = for_each_label('Print[volume[Region[{0}]], OnGlobal, Format Table, File > "volumes.txt"];')
    pathlib.Path("job.pro").write_text(GETDP.format(labels=",".join(map(str, LABELS)), prints=prints))
    run("getdp", "job.pro", "-msh", "mesh-2.2.msh", "-solve", "R", "-pos", "O")
    return dict(zip(LABELS, np.loadtxt("volumes.txt")[:, 1], strict=True))


EXODUS = """python -c '
import meshio, numpy as np
mesh = meshio.read("mesh.vtu")
cells, labels = mesh.cells_dict["tetra"], mesh.cell_data_dict["label"]["tetra"]
meshio.Mesh(mesh.points, [("tetra", cells[labels == label]) for label in np.unique(labels)]).write("mesh.e")'"""

# Where to, the program that has to be there, the page's command, if it is not for the solver itself to read the file,
# what tells the volumes, and the relative error that the digits of the file, or of what the solver prints, leave.
EXACT = 1e-9
ROUTES = [
    ("Nastran", "gmsh", "gmsh mesh.msh -save -o mesh.bdf -setnumber Mesh.BdfFieldFormat 2", read_nastran, 1e-7),
    ("UNV", "gmsh", "gmsh mesh.msh -save -o mesh.unv", read_unv, EXACT),
    ("MED", "gmsh", "gmsh mesh.msh -save -o mesh.med", lambda: read_with_meshio("mesh.med", "cell_tags"), EXACT),
    ("XDMF", "meshio", "meshio convert mesh.vtu mesh.xdmf", lambda: read_with_meshio("mesh.xdmf", "label"), EXACT),
    ("Exodus", "python", EXODUS, read_exodus, 1e-7),
    ("scikit-fem", "python", "", read_skfem, EXACT),
    (
        "CalculiX",
        "ccx",
        "gmsh mesh.msh -save -o mesh.inp -setnumber Mesh.SaveGroupsOfElements -1000",
        read_calculix,
        1e-6,
    ),
    ("FreeFEM", "FreeFem++-nw", "", read_freefem, EXACT),
    ("GetDP", "getdp", "", read_getdp, EXACT),
]


def main(program):
    page = PAGE.read_text()
    program = str(pathlib.Path(program).resolve())
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        # the packages' programs are beside this Python
        os.environ["PATH"] = os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]
        write_label_image("labels.nrrd")
        for name, options in FILES.items():
            run(program, "labels.nrrd", name, "--quiet", *options)
        expected = read_with_meshio("mesh.vtu", "label")
        assert tuple(expected) == LABELS, expected
        for name, needed, command, read, tolerance in ROUTES:
            if not shutil.which(needed):
                print(f"{name}: left out, as there is no {needed}")
                failed += [name] if os.environ.get("CI") == "true" else []
                continue
            assert command in page, f"{PAGE} has no {command}"
            if command:
                run("sh", "-c", command)
            found = read()
            error = max(abs(found.get(label, 0.0) / volume - 1.0) for label, volume in expected.items())
            is_right = set(found) == set(expected) and error <= tolerance
            print(f"{name}: labels {sorted(found)}, volumes within {error:.1e} ({'ok' if is_right else 'wrong'})")
            failed += [] if is_right else [name]
        os.chdir("/")
    sys.exit(f"not reached: {', '.join(failed)}" if failed else 0)


if __name__ == "__main__":
    main(sys.argv[1])
