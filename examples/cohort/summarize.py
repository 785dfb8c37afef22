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
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  it asks for a screen otherwise

sys.path.insert(0, snakemake.scriptdir)  # noqa: F821  snakemake defines it
from table import write_page, write_table  # noqa: E402


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
    subjects = [pathlib.Path(file).stem for file in snakemake.input]  # noqa: F821
    write_table(snakemake.output.table, snakemake.params.folder, subjects)  # noqa: F821
    write_page(snakemake.output.page, snakemake.params.folder, subjects)  # noqa: F821
    draw(snakemake.input, snakemake.output.picture)  # noqa: F821


main()
