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
"""The EEG lead field of 64 electrodes for sources in the gray matter of a head, as a forward solution of MNE-Python.

usage: lead_field.py [LABELS --fiducials FIDUCIALS] [--distance 7] [--folder out] [--program multimaterial-mesh]

Without LABELS, a synthetic head is meshed. Labels are those of head.py. FIDUCIALS is a JSON file with the places of
"nasion", "inion", "left" and "right" in mm, LPS: electrodes are put onto the skin by them.

By reciprocity, what a dipole gives at an electrode is its moment times the gradient, at the dipole, of the potential of
a current that goes in at that electrode: 64 solutions are enough for all sources.
"""

import argparse
import pathlib

import mne
import numpy as np
import pyvista
import skfem
from forward import find_program, labels_or_phantom, mesh_images, skin_of, solve, write_electrodes
from head import CONDUCTIVITIES, GRAY_MATTER, MOMENT
from scipy.spatial import cKDTree
from skfem.helpers import dot, grad

SITES = (
    "Fp1 Fp2 AF7 AF5 AF3 AFz AF4 AF6 AF8 F7 F5 F3 F1 Fz F2 F4 F6 F8 FT7 FC5 FC3 FC1 FCz FC2 FC4 FC6 FT8 T7 C5 C3 C1 Cz C2 "
    "C4 C6 T8 TP7 CP5 CP3 CP1 CPz CP2 CP4 CP6 TP8 P7 P5 P3 P1 Pz P2 P4 P6 P8 PO7 PO5 PO3 POz PO4 PO6 PO8 O1 Oz O2"
).split()
FIRST_LABEL = 101
METAL = 10.0  # S/m: much more than tissue, and no more than the solver likes


def describe_cap(radius=5.0):
    return [
        {"site": site, "label": FIRST_LABEL + n, "shape": "disc", "radius": radius, "thickness": 6}
        for n, site in enumerate(SITES)
    ]


def choose_sources(grid, distance):
    """Numbers of tetrahedra in gray matter about this far from each other, in mm, those farthest from other tissues first."""
    tetrahedra = grid.cells_dict[pyvista.CellType.TETRA]
    is_gray = grid["label"] == GRAY_MATTER
    others = grid.points[np.intersect1d(tetrahedra[is_gray], tetrahedra[~is_gray])]
    numbers = np.flatnonzero(is_gray)
    places = grid.points[tetrahedra[is_gray]].mean(axis=1)
    depth, _ = cKDTree(others).query(places)
    by_depth = np.argsort(-depth, kind="stable")
    _, first = np.unique(np.floor(places[by_depth] / distance).astype(int), axis=0, return_index=True)
    return numbers[by_depth[np.sort(first)]]


def solve_all(matrix, loads, tolerance=1e-6):
    """Conjugate gradients for all columns of the loads at once, with the diagonal as preconditioner."""
    diagonal = matrix.diagonal()[:, None]
    potentials = np.zeros_like(loads)
    rest = loads.copy()
    way = rest / diagonal
    square = np.einsum("ij,ij->j", rest, way)
    for _ in range(20000):
        image = matrix @ way
        length = square / np.einsum("ij,ij->j", way, image)
        potentials += length * way
        rest -= length * image
        if np.all(np.linalg.norm(rest, axis=0) < tolerance * np.linalg.norm(loads, axis=0)):
            return potentials
        uphill = rest / diagonal
        before, square = square, np.einsum("ij,ij->j", rest, uphill)
        way = uphill + square / before * way
    raise RuntimeError("The conjugate gradients did not converge.")


def lead_field(grid, sources):
    """What a dipole of 1 A m along x, y and z gives at the electrodes, in V, against their average:
    electrodes x sources x 3."""
    tetrahedra = grid.cells_dict[pyvista.CellType.TETRA]
    mesh = skfem.MeshTet(
        np.ascontiguousarray(grid.points.T, float) * 1e-3, np.ascontiguousarray(tetrahedra.T, np.int64)
    )
    sigma = np.array([CONDUCTIVITIES.get(label, METAL) for label in grid["label"]])

    @skfem.BilinearForm
    def stiffness(u, v, w):
        return w.sigma * dot(grad(u), grad(v))

    basis = skfem.Basis(mesh, skfem.ElementTetP1())
    matrix = stiffness.assemble(basis, sigma=basis.with_element(skfem.ElementTetP0()).interpolate(sigma))
    electrodes = np.zeros((len(SITES), matrix.shape[0]))
    for n, weights in enumerate(electrodes):
        points = np.unique(tetrahedra[grid["label"] == FIRST_LABEL + n])
        weights[points] = 1 / len(points)
    potentials = solve_all(matrix, (electrodes - electrodes.mean(axis=0)).T)

    corners = mesh.p.T[tetrahedra[sources]]
    edges = corners[:, 1:] - corners[:, :1]
    values = potentials[tetrahedra[sources]]
    gradients = np.linalg.solve(edges, values[:, 1:] - values[:, :1])
    return gradients.transpose(2, 0, 1), electrodes


def to_ras(points):
    """From mm, LPS to m, RAS."""
    return np.asarray(points) * [-1e-3, -1e-3, 1e-3]


def forward_of(leads, sources, electrodes, fiducials):
    """The lead field as a Forward, in the head coordinates of MNE-Python.

    MNE-Python makes one by its own model, a sphere, of which only the numbers are replaced."""
    montage = mne.channels.make_dig_montage(
        dict(zip(SITES, to_ras(electrodes))),
        nasion=to_ras(fiducials["nasion"]),
        lpa=to_ras(fiducials["left"]),
        rpa=to_ras(fiducials["right"]),
        coord_frame="mri",
    )
    to_head = mne.channels.compute_native_head_t(montage)
    info = mne.create_info(SITES, 1000.0, "eeg").set_montage(montage)
    places = mne.transforms.apply_trans(to_head, to_ras(sources))
    normals = np.tile([0.0, 0.0, 1.0], (len(places), 1))
    sphere = mne.make_sphere_model((0.0, 0.0, 0.04), 0.2, verbose="error")
    space = mne.setup_volume_source_space(pos={"rr": places, "nn": normals}, sphere=sphere, verbose="error")
    forward = mne.make_forward_solution(info, None, space, sphere, meg=False, verbose="error")
    assert forward["nsource"] == len(places), "some sources are lost"
    # the gradients go by LPS
    along_head = (leads * [-1, -1, 1]) @ to_head["trans"][:3, :3].T
    for solution in (forward["sol"], forward["_orig_sol"]):
        values = along_head.reshape(len(leads), -1)
        if isinstance(solution, dict):
            solution["data"] = values
        else:
            solution[:] = values
    return forward


def draw(grid, places, values, picture):
    skin = skin_of(grid.extract_cells(np.isin(grid["label"], list(CONDUCTIVITIES))))
    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 800))
    plotter.add_mesh(skin, color="wheat")
    limit = np.abs(values).max() * 1e6
    discs = pyvista.MultiBlock()
    for n, value in enumerate(values):
        disc = grid.extract_cells(grid["label"] == FIRST_LABEL + n)
        disc["potential"] = np.full(disc.n_cells, 1e6 * value)
        discs.append(disc)
    bar = {"title": "potential, \N{MICRO SIGN}V", "fmt": "%.2g"}
    plotter.add_mesh(discs.combine(), scalars="potential", cmap="RdBu_r", clim=(-limit, limit), scalar_bar_args=bar)
    plotter.camera_position = [(150, -350, 450), tuple(grid.center), (0, 0, 1)]
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description="An EEG lead field for MNE-Python.")
    parser.add_argument("labels", nargs="?", help="label image; default: a synthetic head of 2 mm voxels")
    parser.add_argument("--fiducials", help="JSON file; default: those of the synthetic head")
    parser.add_argument("--distance", type=float, default=7.0, help="of sources, in mm (default: %(default)s)")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    fiducials = write_electrodes(folder / "cap.json", describe_cap(), arguments.fiducials)
    program = find_program("multimaterial-mesh", arguments.program)
    labels = labels_or_phantom(arguments.labels, folder)
    grid = mesh_images(
        program, [labels], folder / "lead-field.vtu", "--exterior", "0,6", "--electrodes", folder / "cap.json"
    )

    sources = choose_sources(grid, arguments.distance)
    places = grid.cell_centers().points[sources]
    leads, electrodes = lead_field(grid, sources)
    centers = electrodes @ grid.points
    forward = forward_of(leads, places, centers, fiducials)
    mne.write_forward_solution(folder / "head-fwd.fif", forward, overwrite=True, verbose="error")
    read = mne.read_forward_solution(folder / "head-fwd.fif", verbose="error")
    print(f"{read['nchan']} electrodes, {read['nsource']} sources: {folder / 'head-fwd.fif'}")

    # the same by a solution for one dipole, the one that is farthest from other tissues
    deepest = 0
    moment = MOMENT * np.array([0.0, 0.0, 1.0])
    potential = electrodes @ solve(
        grid,
        {**dict.fromkeys(range(FIRST_LABEL, FIRST_LABEL + len(SITES)), METAL), **CONDUCTIVITIES},
        places[deepest],
        moment,
    )
    direct = potential - potential.mean()
    by_leads = leads[:, deepest] @ moment
    error = np.linalg.norm(by_leads - direct) / np.linalg.norm(direct)
    print(f"dipole at {places[deepest].round(1)} mm: {100 * error:.1f} % from a solution for it alone")
    draw(grid, places, by_leads, folder / "lead-field.png")


if __name__ == "__main__":
    main()
