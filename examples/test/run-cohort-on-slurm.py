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
"""Meshes six phantoms on a Slurm of one node. One job is cancelled half-way and one image is damaged.

The other meshes have to be made, a second call has to make the one that was cancelled, and the table to say what failed.
Usage: run-cohort-on-slurm.py FOLDER_OF_PROGRAMS
"""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import time

cohort = pathlib.Path(__file__).resolve().parents[1] / "cohort"
SPACINGS = {"a": "9", "b": "9.5", "c": "10", "d": "10.5", "slow": "6", "damaged": "9"}
CANCELLED, DAMAGED = "slow", "damaged"


def make_images():
    for name, spacing in SPACINGS.items():
        pathlib.Path("images").mkdir(exist_ok=True)
        subprocess.run(["make-head-phantom", f"images/{name}.nrrd", spacing], check=True, stdout=subprocess.DEVNULL)
    damaged = pathlib.Path(f"images/{DAMAGED}.nrrd")
    damaged.write_bytes(damaged.read_bytes()[:-1000])


def start():
    command = [sys.executable, "-m", "snakemake", "--snakefile", cohort / "Snakefile", "--profile", cohort / "slurm"]
    # there are no accounts here, and jobs are short
    command += ["--slurm-no-account", "--slurm-status-command", "squeue", "--seconds-between-status-checks", "2"]
    command += ["--slurm-init-seconds-before-status-checks", "2", "--config", "images=images", "mem_mb=1000"]
    return subprocess.Popen([str(part) for part in command])


def cancel_half_way(snakemake):
    """Cancels the job of the slow image when its program has written its first line."""
    while snakemake.poll() is None:
        log = pathlib.Path(f"out/cohort/logs/{CANCELLED}.log")
        if log.exists() and log.stat().st_size:
            listed = subprocess.run(["squeue", "--noheader", "--format", "%i %k"], stdout=subprocess.PIPE, text=True)
            jobs = [line.split()[0] for line in listed.stdout.splitlines() if CANCELLED in line]
            assert len(jobs) == 1, listed.stdout
            subprocess.run(["scancel", jobs[0]], check=True)
            return
        time.sleep(0.1)
    raise AssertionError("snakemake ended before the job could be cancelled")


def rows_of_table():
    with open("out/cohort/quality.tsv") as table:
        rows = {row["subject"]: row for row in csv.DictReader(table, delimiter="\t")}
    for row in rows.values():
        print(" ".join(f"{key}={row[key]}" for key in ("subject", "tetrahedra", "seconds", "memory_mb", "failure")))
    assert rows.keys() == SPACINGS.keys(), rows
    return rows


def check_failures(rows, failed):
    assert {name for name, row in rows.items() if row["failure"]} == failed, rows
    for name, row in rows.items():
        assert (row["tetrahedra"] == "") == (name in failed), row
        assert pathlib.Path(f"out/cohort/meshes/{name}.vtu").exists() == (name not in failed), name
    assert "error: " in rows[DAMAGED]["failure"] and f"{DAMAGED}.nrrd" in rows[DAMAGED]["failure"], rows[DAMAGED]


def runs():
    make_images()
    first = start()
    cancel_half_way(first)
    assert first.wait() != 0
    rows = rows_of_table()
    check_failures(rows, {CANCELLED, DAMAGED})
    assert "ended from outside" in rows[CANCELLED]["failure"], rows[CANCELLED]
    made = {
        name: os.stat(f"out/cohort/meshes/{name}.vtu").st_mtime_ns for name in SPACINGS.keys() - {CANCELLED, DAMAGED}
    }

    assert start().wait() != 0
    check_failures(rows_of_table(), {DAMAGED})
    for name, when in made.items():
        assert os.stat(f"out/cohort/meshes/{name}.vtu").st_mtime_ns == when, f"{name} was made again"

    # without the damaged image, all is there
    os.remove(f"images/{DAMAGED}.nrrd")
    del SPACINGS[DAMAGED]
    assert start().wait() == 0
    assert not any(row["failure"] for row in rows_of_table().values())
    assert pathlib.Path("out/cohort/quality.png").exists()


def main():
    if sys.argv[1:] == ["--within-slurm"]:
        runs()
        return
    if os.geteuid() != 0:
        print("Slurm starts jobs as root only")
        sys.exit(77)
    os.environ["PATH"] = sys.argv[1] + os.pathsep + os.environ["PATH"]
    with tempfile.TemporaryDirectory() as folder:
        node = ["bash", cohort / "slurm/single-node.sh", f"{folder}/slurm", sys.executable, __file__, "--within-slurm"]
        subprocess.run([str(part) for part in node], cwd=folder, check=True)


main()
