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
# Installs what is needed (Debian, Ubuntu), builds and runs all tests, those by other people's programs included.
# BUILD_DIR is where, "build" by default. Where CI is "true", no such program may be missing.
set -euo pipefail

project=$(cd "$(dirname "$0")/.." && pwd)
export BUILD_DIR=${BUILD_DIR:-$project/build}
# the libraries are for the packages of Gmsh and VTK; CalculiX, FreeFEM and GetDP read meshes; Slurm runs a cohort
"$project/scripts/apt-install.sh" \
  calculix-ccx freefem++ getdp libglu1-mesa libgomp1 libgtest-dev libxcursor1 libxft2 libxinerama1 munge python3-venv \
  slurm-wlm
clients=$BUILD_DIR/clients
python3 -m venv "$clients"
if ! "$clients/bin/pip" install --quiet --disable-pip-version-check --requirement "$project/test/clients.txt"; then
  [ "${CI:-}" != true ] || exit 1
  echo "There is no package index: the tests with other people's packages are left out." >&2
fi
"$project/scripts/build.sh" -DBUILD_TESTING=ON -DMultiMaterialMeshing_BUILD_BENCHMARKS=ON \
  -DPython3_EXECUTABLE="$clients/bin/python"
cd "$BUILD_DIR"
ctest --output-on-failure --parallel "$(nproc)"
