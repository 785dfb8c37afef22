#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# The paper's table: triangles, tetrahedra, and their radius ratios, average (least), for epsilon = 2.5 and 1.0.
#   bench/paper-table.sh LABELS...          BUILD_DIR is where multimaterial-mesh was built
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: $0 LABELS..." >&2; exit 2; }
project=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '%-28s %7s %10s %12s %20s %20s\n' image epsilon triangles tetrahedra 'triangles RR' 'tetrahedra RR'
for image in "$@"; do
  for epsilon in 2.5 1.0; do
    "${BUILD_DIR:-$project/build}/bin/multimaterial-mesh" "$image" "$scratch/mesh.vtu" --epsilon "$epsilon" \
      --report "$scratch/report.json" --quiet
    python3 - "$scratch/report.json" "$(basename "$image")" "$epsilon" <<'PYTHON'
import json, sys

report = json.load(open(sys.argv[1]))
counts, quality = report["counts"], report["quality"]
ratio = lambda r: f"{r['average']:.3f} ({r['minimum']:.1e})"
print(f"{sys.argv[2]:28s} {sys.argv[3]:>7s} {counts['triangles']:10d} {counts['tetrahedra']:12d} "
      f"{ratio(quality['triangle_radius_ratio']):>20s} {ratio(quality['overall']['radius_ratio']):>20s}")
PYTHON
  done
done
