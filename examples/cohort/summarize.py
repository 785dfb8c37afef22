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
"""Sums up the reports of multimaterial-mesh in a table and a picture. Snakemake runs it, see Snakefile."""

import json
import pathlib

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  it asks for a screen otherwise

COLUMNS = (
    "subject",
    "labels",
    "voxels_merged",
    "labels_vanished",
    "points",
    "tetrahedra",
    "smallest_angle_deg",
    "largest_angle_deg",
    "tetrahedra_below_10_deg",
    "mean_radius_ratio",
    "open_edges",
    "volume_ml",
    "seconds",
    "memory_mb",
)


def summarize(file):
    report = json.loads(pathlib.Path(file).read_text())
    quality = report["quality"]["overall"]
    return (
        pathlib.Path(file).stem,
        len(report["quality"]["labels"]),
        sum(island["voxels"] for island in report["islands_merged"]),
        len(report["vanished_labels"]),
        report["counts"]["points"],
        report["counts"]["tetrahedra"],
        round(quality["smallest_dihedral_angle_deg"]["minimum"], 2),
        round(quality["largest_dihedral_angle_deg"], 2),
        quality["tetrahedra_below_deg"]["10"],
        round(quality["radius_ratio"]["average"], 4),
        report["quality"]["open_edges"],
        round(quality["volume_mm3"] / 1000.0, 1),
        round(sum(stage["seconds"] for stage in report["stages"]), 1),
        round(max(stage["peak_memory_mb"] or 0.0 for stage in report["stages"])),
    )


def draw(files, picture):
    """The dihedral angles of each mesh: how many degrees, in percent of all angles."""
    figure, axes = pyplot.subplots(figsize=(7, 4))
    for file in files:
        counts = np.array(json.loads(pathlib.Path(file).read_text())["quality"]["overall"]["dihedral_angle_histogram"])
        width = 180.0 / len(counts)
        axes.step(
            np.arange(len(counts)) * width, 100.0 * counts / counts.sum(), where="post", label=pathlib.Path(file).stem
        )
    axes.set_xlabel("dihedral angle (degrees)")
    axes.set_ylabel("percent of all")
    axes.set_xlim(0, 180)
    axes.legend(frameon=False)
    figure.tight_layout()
    figure.savefig(picture, dpi=120)


def main():
    rows = [COLUMNS] + [summarize(file) for file in snakemake.input]  # noqa: F821  snakemake defines it
    pathlib.Path(snakemake.output.table).write_text(  # noqa: F821
        "".join("\t".join(str(value) for value in row) + "\n" for row in rows)
    )
    draw(snakemake.input, snakemake.output.picture)  # noqa: F821


main()
