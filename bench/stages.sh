#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Time and peak memory per stage, and the quality, of the pipeline on a label image.
#   bench/stages.sh LABELS [OPTION...]      options go to multimaterial-mesh; BUILD_DIR is where it was built
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: $0 LABELS [OPTION...]" >&2; exit 2; }
project=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"${BUILD_DIR:-$project/build}/bin/multimaterial-mesh" "$@" "$scratch/mesh.vtu" --report "$scratch/report.json" --quiet
python3 - "$scratch/report.json" <<'PYTHON'
import json, sys

report = json.load(open(sys.argv[1]))
print(f"{'stage':34s} {'seconds':>8s} {'peak MB':>8s}")
for stage in report["stages"]:
    print(f"{stage['name']:34s} {stage['seconds']:8.1f} {stage['peak_memory_mb']:8.0f}")
print(f"{'total':34s} {sum(s['seconds'] for s in report['stages']):8.1f}")
quality, counts = report["quality"], report["counts"]
triangles, overall = quality["triangle_radius_ratio"], quality["overall"]
below = overall["tetrahedra_below_deg"]
print(f"triangles {counts['triangles']}, radius ratio {triangles['average']:.3f}, "
      f"1 %: {triangles['first_percentile']:.3f} (least {triangles['minimum']:.2g})")
print(f"tetrahedra {counts['tetrahedra']}, radius ratio {overall['radius_ratio']['average']:.3f} "
      f"(least {overall['radius_ratio']['minimum']:.2g}); "
      f"below 5, 10, 15 degrees: {below['5']}, {below['10']}, {below['15']}")
PYTHON
