#!/usr/bin/env bash
# Copyright NumFOCUS. Licensed under the Apache License, Version 2.0 (see LICENSE).
# Checks the library's and the programs' sources with clang-tidy, by .clang-tidy.
#   scripts/lint.sh [FILE...]     all by default, which takes 20 minutes on two cores
# BUILD_DIR is where the project was configured, "build" by default.
set -euo pipefail

project=$(cd "$(dirname "$0")/.." && pwd)
cd "$project"
build=${BUILD_DIR:-build}
[ -e "$build/compile_commands.json" ] || "$project/scripts/build.sh" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
tools=${XDG_CACHE_HOME:-$HOME/.cache}/multimaterial-meshing/clang-tidy
[ -x "$tools/bin/clang-tidy" ] || {
  python3 -m venv "$tools"
  "$tools/bin/pip" install --quiet clang-tidy==19.1.0
}
[ $# -gt 0 ] || set -- $(git ls-files 'src/*.cxx' 'applications/*.cxx' ':!*/test/*')
printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" "$tools/bin/clang-tidy" -p "$build" --quiet
