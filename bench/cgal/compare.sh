#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Time per tetrahedron of multimaterial-mesh and of CGAL's Mesh_3, for as many tetrahedra (within 5 %) in one run.
#   bench/cgal/compare.sh LABELS [SIZE]   BUILD_DIR is where both were built; the search for CGAL's begins at SIZE mm
set -euo pipefail
[ $# -eq 1 ] || [ $# -eq 2 ] || { echo "usage: $0 LABELS [SIZE]" >&2; exit 2; }
project=$(cd "$(dirname "$0")/../.." && pwd)
bin=${BUILD_DIR:-$project/build}/bin
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
TIMEFORMAT='%R %U %S'

# timed NAME COMMAND...: what it prints goes to NAME.log, wall and processor seconds to NAME.time
timed() {
  local name=$1
  shift
  { time "$@" >"$scratch/$name.log" 2>&1; } 2>"$scratch/$name.time"
}
row() {
  awk -v name="$1" -v count="$2" '{ printf "%-22s %10d tetrahedra %8.1f s %8.1f s of processors %7.1f us a tetrahedron\n",
    name, count, $1, $2 + $3, 1e6 * $1 / count }' "$scratch/$1.time"
}
cgal() {
  local name=$1 size=$2
  shift 2
  timed "$name" "$bin/cgal-mesh3" "$labels" "$scratch/cgal.vtu" --facet-size "$size" \
    --cell-size "$(awk -v s="$size" 'BEGIN { print 1.6 * s }')" "$@"
  count=$(awk '/^tetrahedra:/ { n = $2 } END { print n }' "$scratch/$name.log")
}

labels=$1
timed multimaterial-mesh "$bin/multimaterial-mesh" "$labels" "$scratch/ours.vtu"
wanted=$(sed -n 's/^mesh: .* \([0-9]*\) tetrahedra.*/\1/p' "$scratch/multimaterial-mesh.log")
size=${2:-2.5}
for ((attempt = 0; attempt < 6; ++attempt)); do
  cgal search "$size"
  awk -v n="$count" -v w="$wanted" 'BEGIN { exit !(n > 0.95 * w && n < 1.05 * w) }' && break
  size=$(awk -v s="$size" -v n="$count" -v w="$wanted" 'BEGIN { print s * (n / w) ^ 0.37 }')
done
cgal cgal-refinement "$size"
refined=$count
cgal cgal-with-exudation "$size" --perturb 30 --exude 30
row multimaterial-mesh "$wanted"
row cgal-refinement "$refined"
row cgal-with-exudation "$count"
