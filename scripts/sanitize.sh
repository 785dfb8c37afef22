#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Builds with the sanitizers for addresses and undefined behavior, runs all tests, and meshes random label images.
#   scripts/sanitize.sh [FIRST LAST]     seeds of the random images, 50 by default
# BUILD_DIR is where, "build-sanitize" by default; CXX chooses the compiler.
set -euo pipefail

[ $# -eq 0 ] || [ $# -eq 2 ] || { echo "usage: $0 [FIRST LAST]" >&2; exit 2; }
project=$(cd "$(dirname "$0")/.." && pwd)
export BUILD_DIR=${BUILD_DIR:-$project/build-sanitize}
"$project/scripts/apt-install.sh" libgtest-dev
"$project/scripts/build.sh" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DBUILD_TESTING=ON \
  -DMultiMaterialMeshing_SANITIZE=address,undefined

# the first error ends the test; what libraries of the system keep until the end is not ours
export ASAN_OPTIONS=detect_leaks=0:max_allocation_size_mb=4096:allocator_may_return_null=0
export UBSAN_OPTIONS=print_stacktrace=1
# What is not built with the sanitizers does not load what is; and iterators of ITK 5.2, which count the phantom's parts
# in two tests, move null pointers.
ctest --test-dir "$BUILD_DIR" --output-on-failure --parallel "$(nproc)" --timeout 3600 \
  --exclude-regex 'InstallationServesAnotherProject|EachTissueButAirIsOnePiece|AirComesInSeveralPockets'
"$project/test/fuzz.sh" "${1:-1}" "${2:-50}"
