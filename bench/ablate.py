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
"""What each mechanism alone buys: meshes of a program in which one of them is left out.

usage: ablate.py FOLDER IMAGE... [-- OPTION...]
       ablate.py --check

Copies the sources to FOLDER, puts a switch before each mechanism there, builds the program once, and prints a line for each
image and mechanism, from the report: what the mesh is without it. "none" leaves out nothing, "seed" shows what is noise.
With --check it only says whether the sources still call each mechanism as the table here has it.
"""

import json
import os
import pathlib
import re
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parent.parent

# name of the mechanism: where it is called, and the call
MECHANISMS = {
    "missing-samples": ("src/surface/SurfaceStage.cxx", "this->AddMissing();"),
    "cell-update": ("src/surface/SurfaceStage.cxx", "UpdateCells(m_Indicators"),
    "particle-merging": ("src/surface/SurfaceStage.cxx", "MergeCloseParticles(m_Indicators"),
    "lost-nodes": ("src/surface/SurfaceStage.cxx", "missed.push_back(this->FindLost())"),
    "other-topology": ("src/surface/SurfaceStage.cxx", "missed.push_back(this->FindOtherTopology())"),
    "link-repair": ("src/surface/SurfaceStage.cxx", "m_Repair = RepairLinks("),
    "flat-tetrahedra": ("src/surface/SurfaceStage.cxx", "TurnFlatTetrahedra("),
    "consistency": ("src/surface/SurfaceStage.cxx", "samples.push_back(m_Topology.GetLattice()"),
    "passage-widening": ("src/itk/LabelSmoothing.cxx", "WidenPassages(materials"),
    "volume-correction": ("src/itk/LabelSmoothing.cxx", "CorrectVolumes(materials"),
    "interface-fit": ("src/pipeline/Mesher.cxx", "FitInterfaces(indicators"),
}
SWITCH = 'if (const char * off = std::getenv("ABLATE"); off == nullptr || std::string(off) != "{name}") '


def add_switches(source):
    for name, (file, call) in MECHANISMS.items():
        path = source / file
        text = path.read_text()
        if call not in text:
            sys.exit(f"{file} has no '{call}' any more: the table of mechanisms is out of date")
        text = text.replace(call, SWITCH.format(name=name) + call)
        yield path, text if "<cstdlib>" in text else "#include <cstdlib>\n#include <string>\n" + text


def build(folder):
    source = folder / "source"
    source.mkdir(parents=True)
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=PROJECT, check=True, capture_output=True).stdout
    subprocess.run(["tar", "x", "-C", source], input=archive, check=True)
    for path, text in add_switches(source):
        path.write_text(text)
    environment = {**os.environ, "BUILD_DIR": str(folder / "build")}
    subprocess.run([source / "scripts/build.sh", "-DBUILD_TESTING=OFF"], env=environment, check=True, stdout=sys.stderr)
    return folder / "build/bin/multimaterial-mesh"


def describe(report, summary):
    radius_ratio = report["quality"]["overall"]["radius_ratio"]
    triangles = report["quality"]["triangle_radius_ratio"]
    topology = report["topology"]
    errors = [abs(float(error)) for error in re.findall(r"mm\^3, ([-+.0-9]+) %", summary)]
    return "  ".join(
        (
            f"{report['counts']['tetrahedra']:9d} tetrahedra {radius_ratio['average']:.4f} ({radius_ratio['minimum']:.3f})",
            f"triangles {triangles['average']:.4f}, {triangles['first_percentile']:.4f} ({triangles['minimum']:.2f})",
            f"volume {max(errors):.1f} %",
            f"topology differs at {topology['differences']['number']}",
            f"inconsistent {topology['inconsistent_triangles']}",
            f"links left {topology['link_defects_left']}",
            f"{report['seconds']:.0f} s",
        )
    )


def main():
    arguments = sys.argv[1:]
    options = []
    if "--" in arguments:
        place = arguments.index("--")
        arguments, options = arguments[:place], arguments[place + 1 :]
    if arguments == ["--check"]:
        for _ in add_switches(PROJECT):
            pass
        return
    if len(arguments) < 2:
        sys.exit(__doc__)
    folder = pathlib.Path(arguments[0]).resolve()
    program = build(folder)
    for image in arguments[1:]:
        for name in ("none", "seed", *MECHANISMS):
            report = folder / "report.json"
            command = [program, image, folder / "mesh.vtu", "--report", report, *options]
            command += ["--seed", "2"] if name == "seed" else []
            environment = {**os.environ, "ABLATE": name}
            run = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, text=True)
            line = describe(json.loads(report.read_text()), run.stdout)
            print(f"{pathlib.Path(image).name}  {name:18}  {line}", flush=True)


if __name__ == "__main__":
    main()
