#!/usr/bin/env bash
#==========================================================================
#
#   Copyright NumFOCUS
#
#   Licensed under the Apache License, Version 2.0 (the "License");
#   you may not use this file except in compliance with the License.
#   You may obtain a copy of the License at
#
#          https://www.apache.org/licenses/LICENSE-2.0.txt
#
#   Unless required by applicable law or agreed to in writing, software
#   distributed under the License is distributed on an "AS IS" BASIS,
#   WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
#   See the License for the specific language governing permissions and
#   limitations under the License.
#
#==========================================================================
# Installs what the build needs (Debian, Ubuntu) and builds in the folder "build", or in BUILD_DIR.
# Arguments go to CMake, for instance -DBUILD_TESTING=OFF.
set -euo pipefail

project=$(cd "$(dirname "$0")/.." && pwd)
build=${BUILD_DIR:-$project/build}
"$project/scripts/apt-install.sh" \
  cmake g++ libcli11-dev libinsighttoolkit5-dev ninja-build nlohmann-json3-dev xz-utils
tetgen=$("$project/scripts/tetgen-source.sh" "${XDG_CACHE_HOME:-$HOME/.cache}/multimaterial-meshing")
cmake -S "$project" -B "$build" -G Ninja -DMultiMaterialMeshing_TETGEN_SOURCE="$tetgen" "$@"
cmake --build "$build" --parallel "$(nproc)"
