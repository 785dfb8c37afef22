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
"""Meshes a label image in Python, tells how good the mesh is, and writes it.

usage: mesh_labels.py [LABELS] [-o MESH.vtu] [--picture FILE.png]

Without LABELS, a synthetic head of five tissues is meshed. The picture shows the mesh cut open; it needs pyvista.

    pip install itk_multimaterialmeshing-*.whl pyvista
"""

import argparse
import sys

import itk
import numpy as np


def make_head():
    """Scalp, skull, fluid, gray and white matter, as ellipsoids in each other: 0.9 million voxels of 2 mm."""
    z, y, x = np.mgrid[-90:91:2, -108:109:2, -90:91:2]
    radius = np.sqrt(x**2 + (y / 1.2) ** 2 + z**2)
    labels = np.zeros(radius.shape, np.uint8)
    for label, outside in enumerate((86, 78, 72, 68, 60), 1):
        labels[radius < outside] = label
    image = itk.image_from_array(labels)
    image.SetSpacing([2.0, 2.0, 2.0])
    return image


def mesh_image(labels):
    """The filter after its run, which shows the stages as they begin. Ctrl-C ends it."""
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(labels)
    stages = []

    def show_stage():
        stage = mesher.GetCurrentStage()
        if stage and stages[-1:] != [stage]:
            stages.append(stage)
            print(f"{mesher.GetProgress():4.0%}  {stage}", flush=True)

    observer = mesher.AddObserver(itk.ProgressEvent(), show_stage)
    mesher.Update()
    mesher.RemoveObserver(observer)
    return mesher


def print_quality(mesh):
    calculator = itk.TetrahedralMeshQualityCalculator[type(mesh)].New(Mesh=mesh)
    calculator.Compute()
    print(calculator.GetReport().table)


def print_volumes(mesh):
    """The same numbers by NumPy: points, corners of the tetrahedra and their labels are arrays."""
    points = itk.array_from_vector_container(mesh.GetPoints())
    corners = itk.array_from_vector_container(mesh.GetCellsArray()).reshape(-1, 6)[:, 2:]
    labels = np.asarray(mesh.GetCellData())
    edges = points[corners[:, 1:]] - points[corners[:, :1]]
    volumes = np.linalg.det(edges) / 6.0
    for label in np.unique(labels):
        print(f"label {label}: {volumes[labels == label].sum() / 1000.0:.1f} ml")


def draw(file, picture):
    try:
        import pyvista
    except ImportError:
        print("no picture: pyvista is not installed", file=sys.stderr)
        return
    mesh = pyvista.read(file)
    # whole tetrahedra of the half that is farther from the viewer
    center = np.array(mesh.center)
    half = mesh.extract_cells(mesh.cell_centers().points[:, 0] < center[0])
    labels = np.unique(mesh["label"])
    plotter = pyvista.Plotter(off_screen=True, window_size=(1200, 1000))
    plotter.add_mesh(
        half,
        scalars="label",
        categories=True,
        clim=(labels[0] - 0.5, labels[-1] + 0.5),
        cmap="tab10",
        show_edges=True,
        line_width=0.5,
        annotations={label: str(label) for label in labels},
        scalar_bar_args={"n_labels": 0},
    )
    plotter.camera_position = [center + (2.6 * mesh.length * np.array([0.8, -0.35, 0.25])), center, (0, 0, 1)]
    plotter.camera.zoom(1.5)
    plotter.screenshot(picture)


def main():
    parser = argparse.ArgumentParser(description="Meshes a label image.")
    parser.add_argument("labels", nargs="?", help="label image; default: a synthetic head")
    parser.add_argument("-o", "--output", default="mesh.vtu", help="file of the tetrahedra (default: %(default)s)")
    parser.add_argument("--picture", help="PNG file of the mesh cut open")
    arguments = parser.parse_args()

    labels = itk.imread(arguments.labels) if arguments.labels else make_head()
    mesher = mesh_image(labels)
    mesh = mesher.GetOutput()
    print_quality(mesh)
    print_volumes(mesh)
    itk.meshwrite(mesh, arguments.output, compression=True)
    if arguments.picture:
        draw(arguments.output, arguments.picture)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(130)
    except (RuntimeError, TypeError, ValueError) as error:
        # ITK says first where that was
        sys.exit("mesh_labels.py: " + str(error).split("ITK ERROR: ")[-1])
