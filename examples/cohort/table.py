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
"""The table of a cohort: a row for each image, with what its mesh is like or why there is none."""

import html
import json
import pathlib
import urllib.parse

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
    "failure",
)


def summarize(report):
    """What there is in all columns but the first and the last."""
    quality = report["quality"]["overall"]
    return (
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


def failure(log):
    """Why there is no mesh: the program's own line, if it has ended by itself."""
    if not log.exists():
        return "not begun"
    errors = [line for line in log.read_text(errors="replace").splitlines() if "error: " in line]
    if errors:
        return errors[-1].replace("\t", " ")
    return "ended from outside: cancelled, or beyond its time or memory"


def make_rows(folder, subjects):
    """Of the reports in meshes/ and the logs in logs/."""
    folder, rows = pathlib.Path(folder), []
    for subject in subjects:
        report = folder / f"meshes/{subject}.json"
        if report.exists():
            rows.append((subject, *summarize(json.loads(report.read_text())), ""))
        else:
            empty = [""] * (len(COLUMNS) - 2)
            rows.append((subject, *empty, failure(folder / f"logs/{subject}.log")))
    return rows


def write_table(file, folder, subjects):
    rows = [COLUMNS, *make_rows(folder, subjects)]
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(file).write_text("".join("\t".join(str(value) for value in row) + "\n" for row in rows))


def write_page(file, folder, subjects):
    """The table with links to the pages of the meshes, which are in meshes/ beside it."""
    head = "".join(f'<th scope="col">{column.replace("_", " ")}</th>' for column in COLUMNS)
    lines = []
    for subject, *values in make_rows(folder, subjects):
        name, page = html.escape(subject), f"meshes/{subject}.html"
        if (pathlib.Path(folder) / page).exists():
            name = f'<a href="{urllib.parse.quote(page)}">{name}</a>'
        cells = "".join(f"<td>{html.escape(str(value))}</td>" for value in values)
        lines.append(f'<tr><th scope="row">{name}</th>{cells}</tr>\n')
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(file).write_text(
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta name="color-scheme" content="light dark">'
        "<title>Meshes</title><style>body { font: 15px system-ui, sans-serif } th, td { padding: .2rem .7rem; "
        "border-bottom: 1px solid; text-align: right } table { border-collapse: collapse }</style></head>\n<body>"
        f"<h1>Meshes</h1>\n<table><thead><tr>{head}</tr></thead>\n<tbody>\n{''.join(lines)}</tbody></table>\n"
        "</body></html>\n",
        encoding="utf-8",
    )
