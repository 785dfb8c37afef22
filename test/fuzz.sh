#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# For each seed a random label image and a damaged file of one through the whole pipeline, in a process of its own, one
# for each core at a time; prints the seeds that fail, those whose random image ends in an exception, how many of the
# damaged files were refused, and how long the slowest ones took. What has not ended after ten minutes fails.
#   test/fuzz.sh FIRST LAST [LARGEST]   LARGEST side of the random images in voxels, 20; BUILD_DIR is where the tests
#                                       were built
set -euo pipefail
[ $# -eq 2 ] || [ $# -eq 3 ] || { echo "usage: $0 FIRST LAST [LARGEST]" >&2; exit 2; }
export MMM_TEST_LARGEST_SIDE=${3:-20}
project=$(cd "$(dirname "$0")/.." && pwd)
export driver=${BUILD_DIR:-$project/build}/bin/MultiMaterialMeshingGTestDriver
[ -x "$driver" ] || { echo "$0: no $driver: build the tests first" >&2; exit 2; }
results=$(mktemp -d)
export results
trap 'rm -rf "$results"' EXIT

run_seed() {
  local seed=$1 log=$results/$1.log status=0 begin=$EPOCHREALTIME
  ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS=1 MMM_TEST_SEEDS="$seed $seed" \
    timeout 600 "$driver" --gtest_filter='*RandomImages*:*DamagedImages*' >"$log" 2>&1 || status=$?
  awk -v begin="$begin" -v end="$EPOCHREALTIME" -v seed="$seed" \
    'BEGIN { printf "%.1f s: seed %d\n", end - begin, seed }' >>"$results/times"
  if [ "$status" -ne 0 ]; then
    echo "$seed" >>"$results/failures"
    printf '%s\n' "seed $seed:" "$(grep -v '^\[' "$log" | head -n 20)"
  elif grep -q '^exception:' "$log"; then
    echo "$seed" >>"$results/exceptions"
    echo "seed $seed, $(grep '^exception:' "$log" | tr '\n' ' ' | cut -c 1-300)"
  fi
  if grep -q '^refused:' "$log"; then
    echo "$seed" >>"$results/refused"
  fi
  rm "$log"
}
export -f run_seed

touch "$results"/{times,failures,exceptions,refused}
seq "$1" "$2" | xargs -P "$(nproc)" -I SEED bash -c 'run_seed SEED'
failures=$(wc -l <"$results/failures")
echo "slowest:"
sort -rn "$results/times" | sed -n '1,5p' # head would end the pipe, and with it this script
echo "seeds: $(($2 - $1 + 1)), failures: $failures, exceptions: $(wc -l <"$results/exceptions")," \
  "damaged files refused: $(wc -l <"$results/refused")"
[ "$failures" -eq 0 ]
