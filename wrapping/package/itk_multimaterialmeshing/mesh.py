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
"""itk.multimaterial_mesh(): from labels, however one has them, to a mesh of NumPy arrays."""

import contextlib
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from itk_multimaterialmeshing import _inputs


# in VTK's order of mid-nodes; the first three are those of a triangle
EDGES = np.array([[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]])


class MultiMaterialMesh:
    """Labelled tetrahedra and the triangles between labels, as NumPy arrays. It can be pickled and copied.

    Attributes
    ----------
    points : (n, 3) float64
        In mm, in ITK's physical space (LPS). Those of the triangles come first.
    tetrahedra : (m, 4) int64
        The corners, as rows of points. The volume is positive.
    labels : (m,) int32
        The label of each tetrahedron.
    triangles : (k, 3) int64
        The corners, as rows of points. The normal points from the first to the second label.
    triangle_labels : (k, 2) int32
        The labels on both sides, the lower one first. The outside counts as one, report.outside_label.
    mid_nodes : (e, 3) float64, or None
        With element_order=2, the mid-nodes of the curved edges, which are edges of triangles. All other edges are
        straight. quadratic() has the elements.
    mid_node_edges : (e, 2) int64, or None
        The ends of these edges, as rows of points, the lower one first.
    report : types.SimpleNamespace
        What was expected (estimate), counts (particles, points_left_out, steiner_points), labels without tetrahedra and
        their voxels (vanished_labels), what was merged (islands, by label), the seconds and memory of the stages; with
        element_order=2 volumes of the curved tetrahedra by label, and edges that had to stay straight (curving).
    names : dict[int, str]
        What labels are called, for those that have a name. Files get them.
    cell_data : dict[str, ndarray]
        Numbers of the tetrahedra, by name: (m,), (m, 3) or (m, 3, 3), such as those of sample(). Files get them.
    """

    def __init__(
        self,
        points: NDArray[np.float64],
        tetrahedra: NDArray[np.int64],
        labels: NDArray[np.int32],
        triangles: NDArray[np.int64],
        triangle_labels: NDArray[np.int32],
        report: SimpleNamespace,
        names: Mapping[int, str] | None = None,
        mid_nodes: NDArray[np.float64] | None = None,
        mid_node_edges: NDArray[np.int64] | None = None,
    ) -> None:
        self.points = points
        self.tetrahedra = tetrahedra
        self.labels = labels
        self.triangles = triangles
        self.triangle_labels = triangle_labels
        self.report = report
        self.names = dict(names or {})
        self.cell_data: dict[str, NDArray[np.float64]] = {}
        self.mid_nodes = mid_nodes
        self.mid_node_edges = mid_node_edges

    def __repr__(self) -> str:
        labels = ", ".join(str(label) for label in np.unique(self.triangle_labels))
        return (
            f"<MultiMaterialMesh: {len(self.points)} points, {len(self.tetrahedra)} tetrahedra, "
            f"{len(self.triangles)} triangles between the labels {labels}>"
        )

    def quadratic(self) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
        """Points, tetrahedra (m, 10) and triangles (k, 6) of second order, in VTK's order of nodes.

        The points are those of the mesh, followed by a mid-node for each edge: where mid_nodes have it, else halfway.
        """
        in_cells = [self.tetrahedra[:, EDGES].reshape(-1, 2), self.triangles[:, EDGES[:3]].reshape(-1, 2)]
        edges, numbers = np.unique(np.sort(np.concatenate(in_cells), axis=1), axis=0, return_inverse=True)
        middles = self.points[edges].mean(axis=1)
        if self.mid_node_edges is not None and len(self.mid_node_edges):
            keys = edges @ [len(self.points), 1]
            middles[np.searchsorted(keys, self.mid_node_edges @ [len(self.points), 1])] = self.mid_nodes
        nodes = len(self.points) + numbers.reshape(-1)
        split = len(in_cells[0])
        return (
            np.concatenate([self.points, middles]),
            np.hstack([self.tetrahedra, nodes[:split].reshape(-1, 6)]),
            np.hstack([self.triangles, nodes[split:].reshape(-1, 3)]),
        )

    def to_pyvista(self, surface: bool = False) -> Any:
        """The tetrahedra as pyvista.UnstructuredGrid with the cell data "label"; or the triangles, with surface=True or
        if there are no tetrahedra, as pyvista.PolyData with "label_a" and "label_b", the lower one first. With
        element_order=2, tetrahedra have ten nodes; the triangles of PolyData are flat.
        """
        import pyvista

        if surface or len(self.tetrahedra) == 0:
            mesh = pyvista.PolyData.from_regular_faces(self._surface_points(), self.triangles)
            mesh.cell_data["label_a"], mesh.cell_data["label_b"] = self.triangle_labels.T
        else:
            cells = {pyvista.CellType.TETRA: self.tetrahedra}
            points = self.points
            if self.mid_nodes is not None:
                points, tetrahedra, _ = self.quadratic()
                cells = {pyvista.CellType.QUADRATIC_TETRA: tetrahedra}
            mesh = pyvista.UnstructuredGrid(cells, points)
            mesh.cell_data["label"] = self.labels
            for name, values in self.cell_data.items():
                mesh.cell_data[name] = values if np.ndim(values) == 1 else np.reshape(values, (len(self.labels), -1))
        return mesh

    def sample(self, image: Any, mode: str = "mean") -> NDArray[np.float64]:
        """What another image is in each tetrahedron; NaN where that is outside of the image.

        Parameters
        ----------
        image : the name of a file, or an itk.Image, of numbers or of symmetric tensors in LPS.
        mode : "mean" over the tetrahedron, or at its center, "nearest" or "linear".

        Returns
        -------
        (m,) numbers, or (m, 3, 3) of tensors.
        """
        import itk

        sampler = itk.TetrahedronImageSampler.New(Mesh=_to_itk(self.points, self.tetrahedra, self.labels), Mode=mode)
        with _errors_in_one_line():
            scalars, tensors = _inputs.as_sampled_image(image)
            if tensors is not None:
                return np.array(sampler.SampleTensors(tensors)).reshape(-1, 3, 3)
            return np.array(sampler.Sample(scalars))

    def to_meshio(self) -> Any:
        """The tetrahedra, if there are any, and the triangles as meshio.Mesh. The cell data "label_a" and "label_b" of
        a triangle are its labels, the lower one first; both are the label of a tetrahedron. With element_order=2, the
        cells are "tetra10" and "triangle6"."""
        import meshio

        names, nodes = ("tetra", "triangle"), (self.points, self.tetrahedra, self.triangles)
        if self.mid_nodes is not None:
            names, nodes = ("tetra10", "triangle6"), self.quadratic()
        blocks = [(names[0], nodes[1], self.labels, self.labels), (names[1], nodes[2], *self.triangle_labels.T)]
        blocks = [block for block in blocks if len(block[1])]
        return meshio.Mesh(
            nodes[0],
            [block[:2] for block in blocks],
            cell_data={"label_a": [block[2] for block in blocks], "label_b": [block[3] for block in blocks]},
        )

    def save(
        self, path: str | os.PathLike[str], *, surface: bool = False, msh_format: str = "4.1", ras: bool = False
    ) -> None:
        """Write a file, as the command line does; it appears when it is complete.

        Parameters
        ----------
        path : ends with .vtu (the tetrahedra), .msh or .mesh (these and the triangles), or .stl, .obj or .off (the
            triangles, without labels). With element_order=2, .vtu and .msh have elements of second order; .mesh cannot.
        surface : write the triangles alone. They are written if there are no tetrahedra.
        msh_format : of .msh files: "4.1", "4.1-ascii", "2.2", "2.2-ascii" or "simnibs".
        ras : points in RAS, in all files but .vtu, where they are in LPS.

        Raises
        ------
        RuntimeError : if it cannot be written, with the reason.
        """
        import itk

        path = os.fspath(path)
        writer = itk.LabelMeshFileWriter.New(FileName=path, MshFormat=msh_format, RAS=ras)
        writer.SetOutsideLabel(self.report.outside_label)
        writer.SetSurface(_to_itk(self._surface_points(), self.triangles, self.triangle_labels))
        if self.mid_nodes is not None and self.mid_node_edges is not None:
            writer.SetMidNodes(_to_mid_nodes(self.mid_nodes, self.mid_node_edges))
        if not surface and len(self.tetrahedra) and writer.FindExtension(path, writer.GetVolumeExtensions()):
            writer.SetTetrahedra(_to_itk(self.points, self.tetrahedra, self.labels))
            for name, values in self.cell_data.items():
                writer.AddCellData(name, np.asarray(values, float).ravel().tolist())
        for label, name in self.names.items():
            writer.SetLabelName(int(label), name)
        with _errors_in_one_line():
            writer.Write()

    def _surface_points(self) -> NDArray[np.float64]:
        return self.points[: self.triangles.max(initial=-1) + 1]


def multimaterial_mesh(
    labels: Any,
    spacing: float | Iterable[float] | None = None,
    *,
    exterior_labels: int | Iterable[int] | None = 0,
    fill_exterior: bool = False,
    air_margin: float | None = None,
    minimum_island_size: int = 8,
    radius: float | None = None,
    epsilon: float = 2.5,
    chord_tolerance: float | None = None,
    gradient_limit: float = 0.5,
    minimum_size: float | None = None,
    maximum_size: float | None = None,
    maximum_volume: float | None = None,
    label_sizes: str | Mapping[int, float | Mapping[str, float]] | None = None,
    refine_by: str | os.PathLike[str] | tuple["MultiMaterialMesh", Any] | None = None,
    refine_factor: float = 2.0,
    electrodes: str | os.PathLike[str] | Mapping[str, Any] | None = None,
    seed: int = 1,
    surface_only: bool = False,
    names: str | os.PathLike[str] | Mapping[int, str] | None = None,
    report: str | os.PathLike[str] | None = None,
    **options: Any,
) -> MultiMaterialMesh:
    """Mesh a label image: conforming tetrahedra of all labels at once, and the triangles between them.

    Lengths are in mm. None stands for the default, which follows the image; s is its smallest voxel spacing.

    Parameters
    ----------
    labels : three-dimensional labels
        The name of a file, which is read as on the command line; an itk.Image; an image of nibabel, whose affine says
        where it is; or a NumPy array, indexed by z, y, x as in all of itk. Values are integers, bool, or whole numbers.
    spacing : of an array, the distances of voxels along x, y and z, or one number for all. Default: 1.
    exterior_labels : the label or labels that are not meshed; () or None for none. Default: 0.
    fill_exterior : mesh the exterior as well, up to the faces of the image's box. Default: False.
    air_margin : fill the exterior up to a box this far beyond what else is meshed, at least 0. Default: none.
    minimum_island_size : components of a label with fewer voxels go to the label that they touch most. Default: 8.
    radius : of the smoothing of interfaces, at least 0; 0 keeps the voxels' steps. Default: 0.5 s.
    epsilon : edge length per local feature size, positive. Default: 2.5; 1 for a high resolution.
    chord_tolerance : how far an edge may be from the curved interface that it stands for, positive. Default: 0.1 s.
    gradient_limit : how fast the edge length may grow with distance, positive. Default: 0.5.
    minimum_size : the smallest edge length to ask for, positive. Default: s.
    maximum_size : the largest edge length to ask for, positive. Default: a 25th of the cube root of the volume that is
        meshed, at least 3 s; none with a sizing image.
    maximum_volume : that no tetrahedron is to exceed, mm^3, positive. Default: no limit.
    label_sizes : by label, the "max" of the edge length, or a dictionary with some of "factor" (on the edge length at
        the label's interfaces), "min" and "max"; for instance {3: {"factor": 0.5, "max": 2}, 7: 1.5}. Default: none.
    refine_by : shorter edges where a solution has large errors: a mesh of the same labels and the error of each of its
        tetrahedra, at least 0, in any unit; or the name of a .vtu file with the cell data "error". Default: none.
    refine_factor : how many times as many tetrahedra refine_by is to give, above 1 and at most 64. Default: 2.
    electrodes : electrodes and implants as exact shapes: the name of a JSON file, or a dictionary of what is in one, for
        instance {"space": "LPS", "electrodes": [{"label": 101, "shape": "disc", ...}]}. Default: none.
    seed : another one gives another mesh of the same kind, at least 0. Default: 1.
    surface_only : leave out the interior, in about half the time: there are no tetrahedra. Default: False.
    names : what labels are called, by label, or the name of a file as of --names. Default: for the name of a file, what
        is in it or beside it, as on the command line; {} for none.
    report : a file to write on what was meshed and what came out: a page to look at in a browser if the name ends with
        .html, else JSON. It has the labels' topology, too (compare_topology). Default: none.
    options : the other settings of itk.LabelImageToTetrahedralMeshFilter, by the names of its setters in lower case:
        for instance accept_intensities=True, allow_vanished_labels=True, compare_topology=True, element_order=2,
        maximum_memory=8.0 (GB), maximum_number_of_tetrahedra=10**7, sizing_image=image, region_of_interest=mask with
        region_maximum_size=1.0.

    Raises
    ------
    TypeError : if the labels or an option are of a type that is not taken, or an option is not known.
    ValueError : if a value is no label, or there is no place for the voxels.
    RuntimeError : with the filter's words in one line, for instance if there is nothing to mesh or a file is damaged.
    KeyboardInterrupt : after Ctrl-C.

    Examples
    --------
    >>> mesh = itk.multimaterial_mesh("labels.nii.gz")
    >>> mesh.points.shape, mesh.tetrahedra.shape, mesh.labels.shape
    >>> mesh.save("head.vtu")
    """
    import itk

    settings: dict[str, Any] = {
        "exterior_labels": _inputs.as_labels(exterior_labels, "exterior_labels"),
        "fill_exterior": fill_exterior,
        "air_margin": air_margin,
        "minimum_island_size": minimum_island_size,
        "radius": radius,
        "epsilon": epsilon,
        "chord_tolerance": chord_tolerance,
        "gradient_limit": gradient_limit,
        "minimum_size": minimum_size,
        "maximum_size": maximum_size,
        "maximum_volume": maximum_volume,
        "label_sizes": _inputs.as_label_sizes(label_sizes),
        "seed": seed,
        "surface_only": surface_only,
        **({} if report is None else {"compare_topology": True}),
        **options,
    }
    with _errors_in_one_line():
        label_names = _inputs.as_names(names, labels)
        image = _inputs.as_image(labels, spacing)
        if refine_by is not None:
            settings["sizing_image"] = _sizes_by_errors(
                refine_by, refine_factor, options.get("element_order", 1), image
            )
        mesher = itk.LabelImageToTetrahedralMeshFilter.New(image)
        for name, value in settings.items():
            if value is not None:
                _inputs.set_option(mesher, name, value)
        if electrodes is not None:
            _inputs.set_electrodes(mesher, electrodes)
        mesher.Update()
        for electrode in mesher.GetElectrodeReports():
            label_names.setdefault(electrode.label, electrode.name)
        if report is not None:
            mesher.WriteReport(os.fspath(report))
    return _from_filter(mesher, label_names)


def _sizes_by_errors(refine_by: Any, factor: float, order: int, image: Any) -> Any:
    """The edge lengths that errors ask for, on the grid of an image."""
    import itk

    sizing = itk.ErrorDrivenSizing.New(Factor=float(factor), Order=order)
    if isinstance(refine_by, (str, os.PathLike)):
        sizing.ReadErrors(os.fspath(refine_by))
    else:
        mesh, errors = refine_by
        errors = np.asarray(errors, float)
        if errors.ndim != 1:
            raise TypeError(f"errors have to be one number for each tetrahedron, not an array of shape {errors.shape}")
        sizing.SetErrors(_to_itk(mesh.points, mesh.tetrahedra, mesh.labels), errors.tolist())
    return sizing.Compute(image)


@contextlib.contextmanager
def _errors_in_one_line() -> Iterator[None]:
    """ITK also says where in its code something is wrong: up to ITK 5 in two lines, then in three."""
    try:
        yield
    except RuntimeError as error:
        words = re.sub(r"^(\S+:\d+:\s)?(in '[^']*':\s)?(ITK ERROR:? )?([\w<>:, ]+\(\w+\): )?", "", str(error))
        raise RuntimeError(" ".join(words.split())) from None


def _from_filter(mesher: Any, names: dict[int, str]) -> MultiMaterialMesh:
    import itk

    def cells(mesh: Any, corners: int) -> NDArray[np.int64]:
        if mesh.GetNumberOfCells() == 0:
            return np.empty((0, corners), np.int64)
        # the type and the number of corners come before each cell's corners
        array = itk.array_from_vector_container(mesh.GetCellsArray())
        return array.reshape(-1, corners + 2)[:, 2:].astype(np.int64)

    tetrahedra, surface = mesher.GetOutput(), mesher.GetSurface()
    report = mesher.GetReport()
    report.outside_label = mesher.GetOutsideLabel()
    report.vanished_labels = mesher.GetVanishedLabels()
    report.islands = mesher.GetIslandRecords()
    report.stages = mesher.GetStageRecords()
    return MultiMaterialMesh(
        itk.array_from_vector_container((surface if mesher.GetSurfaceOnly() else tetrahedra).GetPoints()),
        cells(tetrahedra, 4),
        np.array(tetrahedra.GetCellData(), np.int32).reshape(-1),
        cells(surface, 3),
        np.array(surface.GetCellData(), np.int32).reshape(-1, 2),
        report,
        names,
        *_mid_nodes_of(mesher),
    )


def _mid_nodes_of(mesher: Any) -> tuple[NDArray[np.float64], NDArray[np.int64]] | tuple[None, None]:
    """Places and edges; none of first order."""
    import itk

    if mesher.GetElementOrder() == 1:
        return None, None
    mid_nodes = mesher.GetMidNodes()
    if mid_nodes.GetNumberOfPoints() == 0:
        return np.empty((0, 3)), np.empty((0, 2), np.int64)
    return (
        itk.array_from_vector_container(mid_nodes.GetPoints()),
        np.array(mid_nodes.GetPointData(), np.int64).reshape(-1, 2),
    )


def _to_mid_nodes(points: NDArray[np.float64], edges: NDArray[np.int64]) -> Any:
    """An itk.Mesh of the type of the filter's mid-nodes."""
    import itk

    pixel = itk.FixedArray[itk.SI, 2]
    mesh = itk.Mesh[pixel, 3, itk.DefaultStaticMeshTraits[pixel, 3, 3, itk.D]].New()
    if len(points):
        mesh.SetPoints(itk.vector_container_from_array(points.ravel()))
        mesh.GetPointData().Reserve(len(edges))
        np.asarray(mesh.GetPointData())[...] = edges
    return mesh


def _to_itk(points: NDArray[np.float64], cells: NDArray[np.int64], labels: NDArray[np.int32]) -> Any:
    """An itk.Mesh of the type of the filter's tetrahedra, or of its surface."""
    import itk

    pixel = itk.SI if labels.ndim == 1 else itk.FixedArray[itk.SI, 2]
    mesh = itk.Mesh[pixel, 3, itk.DefaultStaticMeshTraits[pixel, 3, 3, itk.D]].New()
    geometry = (
        itk.CommonEnums.CellGeometry_TETRAHEDRON_CELL
        if labels.ndim == 1
        else itk.CommonEnums.CellGeometry_TRIANGLE_CELL
    )
    rows = np.insert(cells, 0, [[geometry], [cells.shape[1]]], axis=1)
    mesh.SetPoints(itk.vector_container_from_array(points.ravel()))
    mesh.SetCellsArray(itk.vector_container_from_array(rows.astype(np.uint64).ravel()))
    mesh.GetCellData().Reserve(len(labels))
    np.asarray(mesh.GetCellData())[...] = labels
    return mesh
