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
"""The field of a current between two pads on a head: transcranial direct current stimulation (tDCS).

usage: tdcs.py [LABELS --fiducials FIDUCIALS] [--spacing MM] [--folder out] [--program multimaterial-mesh]

Without LABELS, a synthetic head is meshed, which the program make-head-phantom writes. Labels are those of the common
six-tissue head models: 1 scalp, 2 skull, 3 cerebrospinal fluid, 4 gray matter, 5 white matter, 6 air. Air is not meshed.
Puts two pads, 7 and 8, onto the skin at C3 and Fp2, by the places in mm, LPS, of "nasion", "inion", "left" and "right" in
the JSON file FIDUCIALS; meshes; solves for the potential by finite elements of first order, the outsides
of the pads at the potentials 1 and 0; scales that to the current; and draws the field on the cortex. The same mesh is
solved by GetDP with stimulation.pro (see the page of examples).
"""

import argparse
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "eeg"))

import numpy as np
import pyvista
import skfem
from forward import find_program, labels_or_phantom, write_electrodes
from scipy.sparse.linalg import LinearOperator, cg
from skfem.helpers import dot, grad

ANODE, CATHODE = 7, 8
SITES = {ANODE: "C3", CATHODE: "Fp2"}  # they also give the names of groups
PADS = [
    {"site": site, "label": label, "shape": "rectangle", "size": [50, 35], "thickness": 6}
    for label, site in SITES.items()
]
# S/m; the pads are sponges with saline
CONDUCTIVITIES = {1: 0.43, 2: 0.01, 3: 1.79, 4: 0.33, 5: 0.14, ANODE: 1.4, CATHODE: 1.4}
BRAIN = (4, 5)
CURRENT = 1e-3  # A


def solve(mesh):
    """The potential in V at the points of a mesh in mm, and V/m of the field in each tetrahedron, for the current."""
    sigma = np.zeros(mesh.nelements)
    for label, value in CONDUCTIVITIES.items():
        sigma[mesh.subdomains[SITES.get(label, f"label {label}")]] = value

    @skfem.BilinearForm
    def stiffness(u, v, w):
        return w.sigma * dot(grad(u), grad(v))

    basis = skfem.Basis(mesh, skfem.ElementTetP1(), intorder=1)
    constant = basis.with_element(skfem.ElementTetP0())
    matrix = stiffness.assemble(basis, sigma=constant.interpolate(sigma))
    anode, cathode = (basis.get_dofs(f"label 0|{site}").all() for site in SITES.values())
    potential = basis.zeros()
    potential[anode] = 1.0
    inner, load, _, free = skfem.condense(matrix, x=potential, D=np.union1d(anode, cathode))
    diagonal = inner.diagonal()
    preconditioner = LinearOperator(inner.shape, lambda r: r / diagonal)
    potential[free], failed = cg(inner, load, rtol=1e-10, maxiter=20000, M=preconditioner)
    if failed:
        raise RuntimeError("The conjugate gradients did not converge.")
    current = 1e-3 * potential @ (matrix @ potential)  # edges are mm: S/m mm
    field = basis.interpolate(potential).grad[:, :, 0]
    scale = CURRENT / current
    return potential, scale, 1e3 * scale * np.linalg.norm(field, axis=0)


def number_of_group(mesh, name):
    """That of a physical group of triangles in a file of Gmsh's version 2.2."""
    return int(re.search(rf'^2 (\d+) "{re.escape(name)}"\r?$'.encode(), mesh.read_bytes(), re.M)[1])


def draw(grid, picture):
    brain = grid.extract_cells(np.isin(grid["label"], BRAIN))
    cortex = brain.cell_data_to_point_data().extract_surface(algorithm="dataset_surface")
    rest = grid.extract_cells(grid["label"] == 1)
    center, length = np.array(grid.center), grid.length
    limit = np.percentile(cortex["field"], 99)
    plotter = pyvista.Plotter(off_screen=True, window_size=(1000, 500), shape=(1, 2))
    for column, side in enumerate((1.0, -1.0)):
        plotter.subplot(0, column)
        plotter.add_mesh(
            cortex.copy(),
            scalars="field",
            cmap="turbo",
            clim=(0, limit),
            scalar_bar_args={"title": "field, V/m", "fmt": "%.2f"},
        )
        for label, color in ((ANODE, "firebrick"), (CATHODE, "steelblue")):
            plotter.add_mesh(grid.extract_cells(grid["label"] == label), color=color)
        plotter.add_mesh(rest, color="peachpuff", opacity=0.1)
        plotter.camera_position = [center + length * np.array([0.9 * side, -0.8, 0.8]), center, (0, 0, 1)]
        plotter.camera.zoom(1.2)
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description="The field of a current between two pads on a head.")
    parser.add_argument("labels", nargs="?", help="label image; default: a synthetic head")
    parser.add_argument("--fiducials", help="JSON file; default: those of the synthetic head")
    parser.add_argument("--spacing", default="2", metavar="MM", help="of the synthetic head (default: %(default)s)")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    labels = labels_or_phantom(arguments.labels, folder, arguments.spacing)
    write_electrodes(folder / "pads.json", PADS, arguments.fiducials)
    program = find_program("multimaterial-mesh", arguments.program)
    options = ["--electrodes", str(folder / "pads.json"), "--exterior", "0,6", "--quiet", "--msh-format", "2.2"]
    subprocess.run([program, str(labels), str(folder / "tdcs.msh"), *options], check=True)

    mesh = skfem.MeshTet.load(folder / "tdcs.msh")
    potential, scale, field = solve(mesh)
    # at the nodes in the order of the file, to compare with what GetDP gives
    np.savetxt(folder / "tdcs-potential.txt", potential, fmt="%.17g")
    cells = {pyvista.CellType.TETRA: mesh.t.T}
    grid = pyvista.UnstructuredGrid(cells, np.ascontiguousarray(mesh.p.T))
    grid["label"] = np.zeros(mesh.nelements, int)
    for label in CONDUCTIVITIES:
        grid["label"][mesh.subdomains[SITES.get(label, f"label {label}")]] = label
    grid["field"] = field
    grid.point_data["potential"] = scale * potential
    print(f"{mesh.nvertices} points, {mesh.nelements} tetrahedra")
    print(f"{scale:.3g} V drive {1e3 * CURRENT:g} mA")
    for label in BRAIN:
        print(f"label {label}: field {np.percentile(field[grid['label'] == label], 99):.3g} V/m (99 % are below)")
    numbers = [number_of_group(folder / "tdcs.msh", f"label 0|{site}") for site in SITES.values()]
    print("getdp options: -setnumber AnodeGroup {} -setnumber CathodeGroup {}".format(*numbers))
    grid.save(folder / "tdcs.vtu")
    draw(grid, folder / "tdcs.png")


if __name__ == "__main__":
    main()
