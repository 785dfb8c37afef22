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
"""Renders a labelled tetrahedral mesh, cut open, to a PNG file. Needs no screen.

usage: RenderMesh.py MESH.vtu OUT.png [--axis x|y|z] [--position MM] [--exterior-labels [LABEL ...]]

Whole tetrahedra on one side of the cut plane are shown with their edges, colored by label. Of a head in LPS
coordinates, x shows the right half from the left, y the back half from the front and z the lower half from above.

Debian 12: apt-get install --no-install-recommends python3-vtk9 xvfb, then /usr/bin/python3 RenderMesh.py ...
Elsewhere: pip install vtk (9.4 or later needs no X server; earlier ones start Xvfb if there is no DISPLAY).
"""
import argparse
import colorsys
import contextlib
import os
import shutil
import subprocess
import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401  text needs it registered
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  so do renderers
from vtkmodules.vtkCommonCore import vtkLogger, vtkLookupTable, vtkVersion
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkDataObject, vtkPlane
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

ARRAY = "label"
IMAGE_SIZE = (1600, 1200)

# Per axis: where the camera is, seen from the mesh, and what is up. The half on the camera's side is cut away.
VIEWS = {
    "x": ((1.0, -0.35, 0.25), (0, 0, 1)),
    "y": ((0.3, -1.0, 0.25), (0, 0, 1)),
    "z": ((0.25, 0.35, 1.0), (0, -1, 0)),
}

# Distinct also to color-blind eyes as far as possible.
COLORS = (
    (0.91, 0.71, 0.57),
    (0.96, 0.90, 0.66),
    (0.25, 0.55, 0.87),
    (0.55, 0.55, 0.58),
    (0.93, 0.93, 0.95),
    (0.80, 0.27, 0.27),
    (0.40, 0.70, 0.40),
    (0.60, 0.40, 0.70),
    (0.90, 0.55, 0.15),
    (0.35, 0.75, 0.75),
)


@contextlib.contextmanager
def virtual_display():
    """An X server without a screen, for VTK versions that cannot render without one."""
    if os.environ.get("DISPLAY") or not sys.platform.startswith("linux"):
        yield
        return
    version = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
    if version >= (9, 4):
        # It tries EGL and OSMesa by itself, but not without a warning that there is no X server.
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
        yield
        return
    xvfb = shutil.which("Xvfb")
    if not xvfb:
        sys.exit("RenderMesh.py: no DISPLAY, and Xvfb was not found. Debian, Ubuntu: apt-get install xvfb")
    read_end, write_end = os.pipe()
    # Xvfb chooses a free display and tells which once it accepts connections.
    server = subprocess.Popen(
        [xvfb, "-displayfd", str(write_end), "-screen", "0", "64x64x24", "-nolisten", "tcp"],
        pass_fds=(write_end,),
        stderr=subprocess.DEVNULL,
    )
    os.close(write_end)
    try:
        with os.fdopen(read_end) as pipe:
            display = pipe.readline().strip()
        if not display:
            sys.exit("RenderMesh.py: Xvfb did not start")
        os.environ["DISPLAY"] = ":" + display
        yield
    finally:
        server.terminate()
        server.wait()


def read_mesh(path):
    if not os.path.isfile(path):
        sys.exit(f"RenderMesh.py: no such file: {path}")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfCells() == 0:
        sys.exit(f"RenderMesh.py: no cells in {path}")
    if mesh.GetCellType(0) != VTK_TETRA or not mesh.IsHomogeneous():
        sys.exit(f"RenderMesh.py: {path} is not a mesh of tetrahedra only")
    if not mesh.GetCellData().HasArray(ARRAY):
        sys.exit(f"RenderMesh.py: no cell array '{ARRAY}' in {path}")
    mesh.GetCellData().SetActiveScalars(ARRAY)
    return mesh


def without_label(mesh, label):
    threshold = vtkThreshold()
    threshold.SetInputData(mesh)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, ARRAY)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    threshold.SetLowerThreshold(label)
    threshold.SetUpperThreshold(label)
    threshold.InvertOn()
    threshold.Update()
    return threshold.GetOutput()


def cut_surface(mesh, axis, position):
    """The surface of the tetrahedra that lie behind the plane, seen from the camera, or cross it."""
    component = "xyz".index(axis)
    bounds = mesh.GetBounds()
    origin = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    if position is not None:
        origin[component] = position
    normal = [0.0, 0.0, 0.0]
    normal[component] = 1.0 if VIEWS[axis][0][component] > 0 else -1.0
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)

    half = vtkExtractGeometry()
    half.SetInputData(mesh)
    half.SetImplicitFunction(plane)
    half.ExtractInsideOn()
    half.ExtractBoundaryCellsOn()
    surface = vtkGeometryFilter()
    surface.SetInputConnection(half.GetOutputPort())
    surface.Update()
    if surface.GetOutput().GetNumberOfCells() == 0:
        low, high = bounds[2 * component : 2 * component + 2]
        sys.exit(f"RenderMesh.py: nothing is left; the mesh reaches from {axis} = {low:g} to {high:g}")
    return surface.GetOutput()


def color_of(labels, index):
    # The labels of common six-tissue heads keep their color whichever of them are visible.
    if all(0 < label <= len(COLORS) for label in labels):
        return COLORS[labels[index] - 1]
    if len(labels) <= len(COLORS):
        return COLORS[index]
    # Steps of the golden ratio keep neighbors in the legend apart.
    return colorsys.hsv_to_rgb(0.618 * index % 1.0, (0.85, 0.5)[index % 2], (0.95, 0.8, 0.6)[index % 3])


def color_table(labels):
    table = vtkLookupTable()
    table.IndexedLookupOn()
    table.SetNumberOfTableValues(len(labels))
    for index, label in enumerate(labels):
        table.SetAnnotation(label, str(label))
        table.SetTableValue(index, *color_of(labels, index), 1.0)
    return table


def make_legend(labels, table):
    legend = vtkScalarBarActor()
    legend.SetLookupTable(table)
    legend.SetNumberOfLabels(0)
    legend.SetTitle(ARRAY)
    legend.UnconstrainedFontSizeOn()
    height = min(0.06 * (len(labels) + 1), 0.96)
    line = height * IMAGE_SIZE[1] / (len(labels) + 1)
    for text in (legend.GetTitleTextProperty(), legend.GetAnnotationTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(int(min(30, 0.7 * line)))
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    legend.SetPosition(0.91, 0.98 - height)
    legend.SetWidth(0.07)
    legend.SetHeight(height)
    legend.SetBarRatio(0.35)
    return legend


def make_actor(surface, table):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(table)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(ARRAY)
    mapper.SetColorModeToMapScalars()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.15, 0.15, 0.15)
    look.SetInterpolationToFlat()
    look.SetAmbient(0.4)
    look.SetDiffuse(0.65)
    return actor


def place_camera(renderer, axis):
    direction, up = VIEWS[axis]
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(direction)
    camera.SetViewUp(up)
    camera.SetViewAngle(20)
    # Unlike ResetCamera(), which fits the bounding sphere, this leaves no wide margins.
    renderer.ResetCameraScreenSpace()
    camera.Zoom(1.08)
    renderer.ResetCameraClippingRange()


def save_picture(actor, legend, axis, path):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.AddActor(legend)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(4)
    window.SetSize(*IMAGE_SIZE)
    window.AddRenderer(renderer)
    place_camera(renderer, axis)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()
    if writer.GetErrorCode():
        sys.exit(f"RenderMesh.py: could not write {path}")
    # Before the display goes away.
    window.Finalize()


def main():
    parser = argparse.ArgumentParser(description="Renders a labelled tetrahedral mesh, cut open, to a PNG file.")
    parser.add_argument("mesh", metavar="MESH.vtu")
    parser.add_argument("picture", metavar="OUT.png")
    parser.add_argument("--axis", choices="xyz", default="x", help="normal of the cut plane (default: x)")
    parser.add_argument("--position", type=float, metavar="MM", help="of the plane (default: middle of the mesh)")
    parser.add_argument(
        "--exterior-labels",
        type=int,
        nargs="*",
        default=[0],
        metavar="LABEL",
        help="labels to leave out (default: 0); the bare option leaves out none",
    )
    arguments = parser.parse_args()

    mesh = read_mesh(arguments.mesh)
    for label in arguments.exterior_labels:
        mesh = without_label(mesh, label)
    surface = cut_surface(mesh, arguments.axis, arguments.position)
    array = surface.GetCellData().GetArray(ARRAY)
    labels = sorted({int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())})
    table = color_table(labels)
    with virtual_display():
        save_picture(make_actor(surface, table), make_legend(labels, table), arguments.axis, arguments.picture)


if __name__ == "__main__":
    main()
