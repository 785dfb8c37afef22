#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Time and memory of particles and surface by the number of particles, on head phantoms of growing resolution. The
# processor time is that of the whole run, and of use where other work disturbs the clock.
#   bench/particles.sh [SPACING-MM...]      BUILD_DIR is where make-head-phantom and multimaterial-mesh were built
set -euo pipefail
[ $# -ge 1 ] || set -- 6 4 3 2 1.5 1
project=$(cd "$(dirname "$0")/.." && pwd)
bin=${BUILD_DIR:-$project/build}/bin
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
TIMEFORMAT='%U %S'
printf '%7s %10s %9s %10s %9s %8s %9s %13s\n' spacing voxels particles relaxation surface 'peak MB' us/particle 'processor'
for spacing in "$@"; do
  "$bin/make-head-phantom" "$scratch/head.nrrd" "$spacing" >/dev/null
  processor=$({ time "$bin/multimaterial-mesh" "$scratch/head.nrrd" "$scratch/surface.vtu" --surface-only \
    --report "$scratch/report.json" --quiet 2>/dev/null; } 2>&1)
  python3 - "$scratch/report.json" "$spacing" $processor <<'PYTHON'
import json, math, sys

report = json.load(open(sys.argv[1]))
stages = {stage["name"]: stage for stage in report["stages"]}
relaxation = sum(stages[name]["seconds"] for name in
                 ("seeding of particles", "relaxation of 1-cells", "relaxation of 2-cells"))
surface = stages["surface"]
particles = sum(report["counts"][f"particles_on_{n}_cells"] for n in range(3))
print(f"{sys.argv[2]:>7s} {math.prod(report['input']['size']):10d} {particles:9d} {relaxation:8.1f} s "
      f"{surface['seconds']:7.1f} s {surface['peak_memory_mb']:8.0f} "
      f"{1e6 * (relaxation + surface['seconds']) / particles:11.0f} {float(sys.argv[3]) + float(sys.argv[4]):11.1f} s")
PYTHON
done
