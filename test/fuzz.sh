#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Random label images through the whole pipeline, each seed in a process of its own; prints the seeds that fail, and how.
#   test/fuzz.sh FIRST LAST          BUILD_DIR is where the tests were built
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: $0 FIRST LAST" >&2; exit 2; }
project=$(cd "$(dirname "$0")/.." && pwd)
driver=${BUILD_DIR:-$project/build}/bin/MultiMaterialMeshingGTestDriver
log=$(mktemp)
trap 'rm -f "$log"' EXIT
failures=0
exceptions=0
for ((seed = $1; seed <= $2; ++seed)); do
  if ! MMM_TEST_SEEDS="$seed $seed" "$driver" --gtest_filter='*RandomImages*' >"$log" 2>&1; then
    failures=$((failures + 1))
    echo "seed $seed:"
    grep -v '^\[' "$log" | head -n 20
  elif grep -q '^exception:' "$log"; then
    exceptions=$((exceptions + 1))
    echo "seed $seed, $(grep '^exception:' "$log" | tr '\n' ' ' | cut -c 1-300)"
  fi
done
echo "seeds: $(($2 - $1 + 1)), failures: $failures, exceptions: $exceptions"
[ "$failures" -eq 0 ]
