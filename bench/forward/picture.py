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
"""Error against unknowns of the rows that compare.py keeps.

usage: picture.py ROWS.json PICTURE.svg
"""

import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PANELS = (
    ("dipoles at 0.5 of the radius: RDM, %", lambda row: row["venant"]["rdm"]["0.5"]),
    ("dipoles at 0.9 of the radius: RDM, %", lambda row: row["venant"]["rdm"]["0.9"]),
    ("field between electrodes, recovered: error, %", lambda row: row["smooth field"]),
)
FAMILIES = (
    ("ours,", "o"),
    ("ours of second order", "P"),
    ("voxels: hexahedra", "s"),
    ("voxels: shifted", "D"),
    ("voxels: tetrahedra", "^"),
    ("CGAL", "x"),
)


def draw(rows, picture):
    """rows: as read from JSON, by names such as "2 mm ours, defaults"."""
    figure, axes = plt.subplots(1, len(PANELS), figsize=(4.2 * len(PANELS), 4), layout="constrained")
    spacings = sorted({name.split()[0] for name in rows})
    for axis, (title, error_of) in zip(axes, PANELS):
        for spacing, line in zip(spacings, ("-", "--", ":", "-.")):
            for number, (family, marker) in enumerate(FAMILIES):
                members = [row for name, row in rows.items() if name.startswith(f"{spacing} mm {family}")]
                points = sorted((row["nodes"], error_of(row)) for row in members)
                if points:
                    axis.loglog(
                        *zip(*points), marker + line, color=f"C{number}", label=f"{family.rstrip(',')}, {spacing} mm"
                    )
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("nodes")
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=7)
    # text stays text, and the same rows give the same file
    with plt.rc_context({"svg.fonttype": "none", "svg.hashsalt": "forward"}):
        figure.savefig(picture, format="svg", metadata={"Date": None})
    lines = pathlib.Path(picture).read_text().splitlines()
    pathlib.Path(picture).write_text("".join(line.rstrip() + "\n" for line in lines))
    plt.close(figure)


if __name__ == "__main__":
    draw(json.loads(pathlib.Path(sys.argv[1]).read_text()), sys.argv[2])
