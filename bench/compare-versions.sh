#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Time and peak memory per stage of two versions of the program on an image, and whether they make the same mesh.
#   bench/compare-versions.sh OLD NEW LABELS [OPTION...]      two programs; options go to both; RUNS of each, default 3
# They run in turns, and the least of the runs counts: where other programs run as well, look at the processor time.
set -euo pipefail
[ $# -ge 3 ] || { echo "usage: $0 OLD NEW LABELS [OPTION...]" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python3 - "$scratch" "${RUNS:-3}" "$@" <<'PYTHON'
import hashlib, json, os, subprocess, sys

scratch, runs, *programs = sys.argv[1:5]
arguments = sys.argv[5:]
versions = [{}, {}]  # per stage, and for all, the least seconds and megabytes
meshes = [set(), set()]


def note(version, name, values):
    version[name] = [min(pair) for pair in zip(values, version.get(name, values))]


for turn in range(int(runs)):
    for n, program in enumerate(programs):
        mesh, report = f"{scratch}/mesh.vtu", f"{scratch}/report.json"
        process = subprocess.Popen([program, *arguments, mesh, "--report", report, "--quiet"])
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit(f"{program} failed.")
        stages = json.load(open(report))["stages"]
        for stage in stages:
            note(versions[n], stage["name"], [stage["seconds"], stage["peak_memory_mb"]])
        note(versions[n], "total", [sum(stage["seconds"] for stage in stages), usage.ru_maxrss / 1024])
        note(versions[n], "processor time", [usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024])
        meshes[n].add(hashlib.sha256(open(mesh, "rb").read()).hexdigest())

ratio = lambda pair: f"{pair[1] / pair[0]:6.2f}" if pair[0] > 0.0 else "     -"
print(f"{'stage':34s} {'old s':>8s} {'new s':>8s} {'ratio':>6s} {'old MB':>8s} {'new MB':>8s} {'ratio':>6s}")
for name in versions[0]:
    if name in versions[1]:
        seconds, memory = zip(versions[0][name], versions[1][name])
        print(f"{name:34s} {seconds[0]:8.2f} {seconds[1]:8.2f} {ratio(seconds)} "
              f"{memory[0]:8.0f} {memory[1]:8.0f} {ratio(memory)}")  # fmt: skip
print("The meshes are", "the same." if meshes[0] == meshes[1] and len(meshes[0]) == 1 else "different.")
PYTHON
