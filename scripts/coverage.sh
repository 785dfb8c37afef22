#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Builds with counters, runs all tests, and prints how many lines and branches of src, include and applications they
# reach. A page per file is in the folder "coverage" of BUILD_DIR, which is "build-coverage" by default. It needs GCC.
set -euo pipefail

project=$(cd "$(dirname "$0")/.." && pwd)
export BUILD_DIR=${BUILD_DIR:-$project/build-coverage}
"$project/scripts/apt-install.sh" gcovr libgtest-dev
"$project/scripts/build.sh" -DCMAKE_BUILD_TYPE=Coverage -DCMAKE_CXX_FLAGS_COVERAGE="-O1 --coverage" -DBUILD_TESTING=ON
find "$BUILD_DIR" -name '*.gcda' -delete
# where the program must not write much, it cannot write the counts either
ctest --test-dir "$BUILD_DIR" --output-on-failure --parallel "$(nproc)" --timeout 3600 --exclude-regex FullDisk

mkdir -p "$BUILD_DIR/coverage"
cd "$project"
gcovr --root . --filter src/ --filter include/ --filter applications/ --exclude '.*/test/' --exclude-throw-branches \
  --gcov-ignore-parse-errors \
  --print-summary --txt "$BUILD_DIR/coverage/files.txt" --html-details "$BUILD_DIR/coverage/index.html" "$BUILD_DIR"
