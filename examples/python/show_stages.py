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
"""Draws what happens on the way from labels to tetrahedra: indicators, sizing, particles, the mesh and its angles.

usage: show_stages.py LABELS [--folder out] [--slice N] [--program multimaterial-mesh]

Runs multimaterial-mesh with all its intermediate results, unless they are in the folder already, and leaves five
pictures there. The slice is one of the second axis, coronal in an image of a head.

    pip install itk matplotlib numpy pyvista scipy
"""

import argparse
import json
import pathlib
import shutil
import subprocess

import itk
import matplotlib
import numpy as np
import pyvista
from scipy.ndimage import map_coordinates

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  it asks for a screen otherwise
from matplotlib.colors import ListedColormap  # noqa: E402

COLORS = ["#303030", "#e8b594", "#f5e6a8", "#408cde", "#8c8c94", "#ededf2", "#cc4545", "#66b266", "#9966b3", "#e68c26"]
DIMENSIONS = {0: "corners: 4 labels and more", 1: "junctions: 3 labels", 2: "interfaces: 2 labels"}


def find_program(name, program=None):
    """The path that was given, or the program on the PATH, or the one that was built in this checkout."""
    built = pathlib.Path(__file__).resolve().parents[2] / "build" / "bin" / name
    return program or shutil.which(name) or str(built)


def run(program, labels, folder):
    files = {name: folder / f"{name}.vtu" for name in ("mesh", "surface", "particles", "junctions")}
    if all(file.exists() for file in files.values()):
        return
    command = [program, str(labels), str(files["mesh"]), "--surface", str(files["surface"])]
    command += ["--particles", str(files["particles"]), "--junctions", str(files["junctions"])]
    command += ["--save-indicators", str(folder / "indicator-")]
    command += ["--save-sizing", str(folder / "sizing.nrrd"), "--report", str(folder / "report.json")]
    subprocess.run(command, check=True)


class Slice:
    """A slice of the label image, and of others on the same voxels."""

    def __init__(self, labels, number):
        self.image = labels
        self.number = number
        self.labels = itk.array_view_from_image(labels)[:, number, :]
        spacing = labels.GetSpacing()
        self.extent = (0, self.labels.shape[1] * spacing[0], 0, self.labels.shape[0] * spacing[2])

    def of(self, image, fill):
        """An image that may cover a part of the voxels only."""
        start = self.image.TransformPhysicalPointToIndex(image.GetOrigin())
        values = np.full(self.labels.shape, fill, np.float32)
        number = self.number - start[1]
        array = itk.array_view_from_image(image)
        if 0 <= number < array.shape[1]:
            depth, _, width = array.shape
            values[start[2] : start[2] + depth, start[0] : start[0] + width] = array[:, number, :]
        return values


def show(axes, title):
    axes.set_title(title, fontsize=10)
    axes.set_xticks([])
    axes.set_yticks([])


def draw_indicators(part, indicators, picture):
    """The labels with the zero levels between them, and one of the indicators around its zero level."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 4.6), layout="constrained")
    known = sorted(indicators)
    values = np.stack([part.of(indicators[label], -3.0) for label in known])
    place = dict(extent=part.extent, origin="lower")
    left.imshow(
        np.searchsorted(known, part.labels),
        cmap=ListedColormap(COLORS[: len(known)]),
        vmin=-0.5,
        vmax=len(known) - 0.5,
        interpolation="nearest",
        **place,
    )
    for n in range(len(known)):
        others = np.delete(values, n, axis=0).max(axis=0)
        left.contour(values[n] - others, [0.0], colors="black", linewidths=0.7, **place)
    show(left, "labels, and where two indicators are equal")
    shown = np.argmax(np.abs(np.diff(np.sign(values), axis=2)).sum(axis=(1, 2)))
    limit = 3.0
    image = right.imshow(values[shown], cmap="RdBu", vmin=-limit, vmax=limit, **place)
    right.contour(values[shown], [0.0], colors="black", linewidths=0.7, **place)
    show(right, f"indicator of label {known[shown]}")
    figure.colorbar(image, ax=right, shrink=0.8, label="mm")
    figure.savefig(picture, dpi=100)


def draw_sizing(part, sizing, picture):
    figure, axes = pyplot.subplots(figsize=(5.6, 4.6), layout="constrained")
    values = part.of(sizing, np.nan)
    place = dict(extent=part.extent, origin="lower")
    image = axes.imshow(values, cmap="viridis", vmax=np.nanpercentile(values, 98), **place)
    for label in np.unique(part.labels):
        axes.contour((part.labels == label).astype(float), [0.5], colors="white", linewidths=0.4, **place)
    show(axes, "edge length that is asked for")
    figure.colorbar(image, ax=axes, shrink=0.8, label="mm")
    figure.savefig(picture, dpi=100)


def spacing_per_size(surface, sizing):
    """The mean length of the edges around each point of the interfaces, per edge length that is asked for there."""
    corners = surface.cells_dict[pyvista.CellType.TRIANGLE]
    edges = np.unique(np.sort(corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0)
    lengths = np.linalg.norm(np.diff(surface.points[edges], axis=1)[:, 0], axis=1)
    ends = edges.T.ravel()
    mean = np.bincount(ends, np.tile(lengths, 2)) / np.bincount(ends)
    to_index = np.linalg.inv(itk.array_from_matrix(sizing.GetDirection()) @ np.diag(sizing.GetSpacing()))
    index = (surface.points - np.array(sizing.GetOrigin())) @ to_index.T
    return mean / map_coordinates(itk.array_view_from_image(sizing), index.T[::-1], order=1, mode="nearest")


def labels_of(mesh):
    return np.stack([mesh[f"label_{letter}"] for letter in "abcd"], axis=1)


def draw_particles(particles, junctions, surface, sizing, picture):
    """Those around the label with the most junctions, by the dimension of their cell and by their spacing."""
    sides = np.stack([surface["label_a"], surface["label_b"]], axis=1)
    near_junctions = labels_of(particles)[particles["dimension"] < 2]
    around = max(np.unique(sides)[1:], key=lambda label: (near_junctions == label).any(axis=1).sum())
    is_curve = (labels_of(junctions) == around).any(axis=1) & (junctions["curve"] >= 0)
    ratio = spacing_per_size(surface, sizing)
    surface["spacing"] = ratio
    surface["dimension"] = np.full(surface.n_points, 2)
    surface["dimension"][: particles.n_points] = particles["dimension"]
    shown = surface.extract_cells((sides == around).any(axis=1))
    center = np.array(shown.center)
    plotter = pyvista.Plotter(off_screen=True, window_size=(1300, 620), shape=(1, 2), border=False)
    plotter.add_mesh(shown.copy(), color="#e8e8e8", lighting=True)
    if is_curve.any():
        plotter.add_mesh(junctions.extract_cells(is_curve), color="#1858d0", line_width=2)
    for n, color in ((2, "#607890"), (1, "#1858d0"), (0, "#d02020")):
        points = shown.points[shown["dimension"] == n]
        if len(points):
            size = 3 if n == 2 else 7
            plotter.add_points(
                points, color=color, point_size=size, render_points_as_spheres=True, label=f" {DIMENSIONS[n]}"
            )
    plotter.add_legend(bcolor="white", face="circle", size=(0.5, 0.14), loc="lower left")
    plotter.subplot(0, 1)
    plotter.add_mesh(
        shown.copy(),
        scalars="spacing",
        cmap="coolwarm",
        clim=(0.5, 1.5),
        scalar_bar_args={"title": "mean edge length / edge length asked for", "fmt": "%.1f"},
    )
    plotter.link_views()
    plotter.camera_position = [center + shown.length * np.array([0.6, -0.8, 0.9]), center, (0, 0, 1)]
    plotter.camera.zoom(1.05)
    plotter.screenshot(picture)
    low, middle, high = np.percentile(ratio, [5, 50, 95])
    print(f"mean edge length per edge length asked for: median {middle:.2f}, 90 % within {low:.2f} to {high:.2f}")


def draw_mesh(mesh, picture):
    center = np.array(mesh.center)
    half = mesh.extract_cells(mesh.cell_centers().points[:, 1] > center[1])
    labels = np.unique(mesh["label"])
    half["place"] = np.searchsorted(labels, half["label"])
    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 800))
    plotter.add_mesh(
        half,
        scalars="place",
        cmap=COLORS[1 : len(labels) + 1],
        clim=(-0.5, len(labels) - 0.5),
        show_edges=True,
        line_width=0.4,
        ambient=0.4,
        diffuse=0.65,
        show_scalar_bar=False,
    )
    plotter.camera_position = [center + mesh.length * np.array([0.25, -1.2, 0.3]), center, (0, 0, 1)]
    plotter.camera.zoom(1.4)
    plotter.screenshot(picture)


def draw_angles(report, picture):
    """All six dihedral angles of all tetrahedra; a regular one has 70.5 degrees."""
    quality = json.loads(report.read_text())["quality"]["overall"]
    counts = np.array(quality["dihedral_angle_histogram"])
    width = 180.0 / len(counts)
    figure, axes = pyplot.subplots(figsize=(5.6, 3.2), layout="constrained")
    axes.bar(
        np.arange(len(counts)) * width, 100.0 * counts / counts.sum(), width=width, align="edge", edgecolor="white"
    )
    axes.set_xlim(0, 180)
    axes.set_xlabel("dihedral angle (degrees)")
    axes.set_ylabel("percent of all")
    smallest = quality["smallest_dihedral_angle_deg"]["minimum"]
    axes.set_title(f"{smallest:.1f} to {quality['largest_dihedral_angle_deg']:.1f} degrees", fontsize=10)
    figure.savefig(picture, dpi=100)


def main():
    parser = argparse.ArgumentParser(description="Draws what happens on the way from labels to tetrahedra.")
    parser.add_argument("labels", help="label image")
    parser.add_argument("--folder", type=pathlib.Path, default="out", help="for the files (default: %(default)s)")
    parser.add_argument("--slice", type=int, metavar="N", help="of the second axis (default: the middle one)")
    parser.add_argument("--program", help="path of multimaterial-mesh, if it is not found")
    arguments = parser.parse_args()

    folder = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    run(find_program("multimaterial-mesh", arguments.program), arguments.labels, folder)

    labels = itk.imread(arguments.labels)
    number = labels.GetLargestPossibleRegion().GetSize()[1] // 2 if arguments.slice is None else arguments.slice
    part = Slice(labels, number)
    sizing = itk.imread(folder / "sizing.nrrd", itk.F)
    known = np.unique(itk.array_view_from_image(labels))
    indicators = {int(label): itk.imread(folder / f"indicator-{label}.nrrd", itk.F) for label in known}
    draw_indicators(part, indicators, folder / "indicators.png")
    draw_sizing(part, sizing, folder / "sizing.png")
    particles, junctions, surface = (
        pyvista.read(folder / f"{name}.vtu") for name in ("particles", "junctions", "surface")
    )
    draw_particles(particles, junctions, surface, sizing, folder / "particles.png")
    draw_mesh(pyvista.read(folder / "mesh.vtu"), folder / "cut.png")
    draw_angles(folder / "report.json", folder / "angles.png")


if __name__ == "__main__":
    main()
