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
"""Runs an example on the head phantom at 4 mm, or on spheres at 4 mm, and checks what it says and leaves.

usage: run-example.py {surfaces,shells,head,lead_field,spheres,tdcs,cohort} FOLDER_OF_PROGRAMS
"""

import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np

examples = pathlib.Path(__file__).resolve().parents[1]


def run(*command):
    """What a command prints, which has to succeed."""
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(done.stdout)
    done.check_returncode()
    return done.stdout


def make_phantom():
    run("make-head-phantom", "head.nrrd", "4")
    return "head.nrrd"


def check_pictures(*names):
    for name in names:
        assert pathlib.Path(name).read_bytes().startswith(b"\x89PNG"), name


def surfaces():
    """Each of the six tissues has a closed surface without pinches."""
    text = run(sys.executable, examples / "bem/surfaces.py", make_phantom())
    rows = re.findall(r"^label (\d): .* volume ([\d.]+) ml, 0 open edges, 0 pinched edges$", text, re.M)
    assert [label for label, _ in rows] == list("123456"), rows
    assert 3300 < sum(float(volume) for _, volume in rows) < 3900, rows
    check_pictures("out/tissues.png")


def shells():
    """MNE-Python takes the hulls, and the potential by its boundary elements is that of the series."""
    spheres = ["--radii", "46", "55", "64", "--spacing", "4", "--size", "8"]
    text = run(sys.executable, examples / "bem/shells.py", *spheres)
    rows = re.findall(r"^ +\d+ +(?:radial|tangential) +\S+% +(\S+) +(\S+)$", text, re.M)
    assert len(rows) == 6, rows
    for topography, magnitude in rows:
        assert float(topography) < 0.08 and 0.85 < float(magnitude) < 1.15, rows
    check_pictures("out/shells.png")


def head():
    """A dipole gives microvolts of both signs on the skin."""
    text = run(sys.executable, examples / "eeg/head.py", make_phantom())
    least, largest = map(float, re.search(r"potential on the skin: (\S+) to (\S+)", text).groups())
    assert -20 < least < -0.1 and 0.1 < largest < 20, (least, largest)
    check_pictures("out/head-eeg.png")


def lead_field():
    """MNE-Python reads what it leaves, and the lead field is that of a solution for a dipole, as far as 4 mm allow."""
    text = run(sys.executable, examples / "eeg/lead_field.py", make_phantom(), "--distance", "12")
    electrodes, sources = map(int, re.search(r"^(\d+) electrodes, (\d+) sources", text, re.M).groups())
    assert electrodes == 64 and 300 < sources < 3000, (electrodes, sources)
    error = float(re.search(r"mm: (\S+) % from a solution for it alone", text)[1])
    assert error < 25, error
    check_pictures("out/lead-field.png")


def spheres():
    """The potential is that of the series, as far as voxels of twice the fluid's thickness allow."""
    text = run(sys.executable, examples / "eeg/sphere.py", "--spacing", "4", "--depths", "40", "--indicators")
    rows = re.findall(r"^ +40 +(\S+) +\S+% +(\S+) +(\S+)$", text, re.M)
    assert [name for name, _, _ in rows] == ["radial", "tangential"], rows
    for _, topography, magnitude in rows:
        assert float(topography) < 0.05 and 0.8 < float(magnitude) < 1.25, rows
    check_pictures("out/spheres-potential.png")


def tdcs():
    """The brain's field is that of stimulation, and GetDP has the same potential at each node of the same mesh."""
    text = run(sys.executable, examples / "tdcs/tdcs.py", "--spacing", "4")
    fields = [float(field) for field in re.findall(r"^label [45]: field (\S+) V/m", text, re.M)]
    assert len(fields) == 2 and all(0.05 < field < 2 for field in fields), fields
    check_pictures("out/tdcs.png")
    if not shutil.which("getdp"):
        print("GetDP: left out, as there is no getdp")
        assert os.environ.get("CI") != "true"
        return
    problem = pathlib.Path(shutil.copy(examples / "tdcs/stimulation.pro", "out"))
    numbers = re.search(r"^getdp options: (.*)$", text, re.M)[1].split()
    run("getdp", problem, "-msh", "out/tdcs.msh", *numbers, "-solve", "Stimulation", "-pos", "Potential")
    ours = np.loadtxt("out/tdcs-potential.txt")
    theirs = read_node_table("out/potential.txt", len(ours))
    print(f"GetDP: potentials of 0 to 1 V differ by at most {np.abs(theirs - ours).max():.1e} V")
    assert np.abs(theirs - ours).max() < 1e-6


def read_node_table(name, count):
    """Values by the numbers of nodes, which begin with 1; the first line has their count."""
    table = np.loadtxt(name, skiprows=1)
    assert set(table[:, 0]) == set(range(1, count + 1))
    values = np.empty(count)
    values[table[:, 0].astype(int) - 1] = table[:, -1]
    return values


def cohort():
    """Each image has a row in the table, and a second run finds nothing to do."""
    command = [sys.executable, "-m", "snakemake", "--snakefile", examples / "cohort/Snakefile", "--cores", "2"] + [
        "--config",
        "phantoms=[5.0,6.0]",
    ]
    run(*command)
    with open("out/cohort/quality.tsv") as table:
        rows = list(csv.DictReader(table, delimiter="\t"))
    assert sorted(row["subject"] for row in rows) == ["phantom-5.0mm", "phantom-6.0mm"], rows
    for row in rows:
        assert row["open_edges"] == "0" and row["labels_vanished"] == "0" and float(row["smallest_angle_deg"]) > 5, row
    page = pathlib.Path("out/cohort/quality.html").read_text()
    for row in rows:
        link = f'<a href="meshes/{row["subject"]}.html">{row["subject"]}</a>'
        assert link in page, page
        assert "<!DOCTYPE html>" in pathlib.Path(f"out/cohort/meshes/{row['subject']}.html").read_text()
    check_pictures("out/cohort/quality.png")
    assert "Nothing to be done" in run(*command)


def main():
    example, programs = sys.argv[1:]
    os.environ["PATH"] = programs + os.pathsep + os.environ["PATH"]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        checks = (surfaces, shells, head, lead_field, spheres, tdcs, cohort)
        {check.__name__: check for check in checks}[example]()
        os.chdir("/")


main()
