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
# Builds the Python package of the module and runs its tests, on Debian 12. Installs what it needs, gets and builds ITK
# once, and leaves the wheel in BUILD_DIR/dist.
#
#   ITK_DIR         a build tree of ITK to use instead, as itk-tree.sh makes it
#   ITK_CACHE_DIR   where ITK and the tools are kept; default: build/itk-VERSION
#   BUILD_DIR       where the wheel is built and tested; default: build/python
#   CMAKE_BUILD_PARALLEL_LEVEL   compilers at a time; default: as many as there are cores
#   PYTHON          default: python3, at least 3.11
#   MULTIMATERIAL_MESH   the command line program, whose meshes the tests compare; without it, they leave that out
set -euo pipefail

version=5.4.7
project=$(cd "$(dirname "$0")/.." && pwd)
cache=${ITK_CACHE_DIR:-$project/build/itk-$version}
build=${BUILD_DIR:-$project/build/python}
tools=$cache/tools
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export PIP_DISABLE_PIP_VERSION_CHECK=1

"$project/scripts/apt-install.sh" castxml g++ libtbb-dev libtet1.5-dev python3-dev python3-venv xz-utils
mkdir -p "$cache" "$build"
"$project/scripts/python-tools.sh" "$tools"
if [ -z "${ITK_DIR:-}" ]; then
  "$project/scripts/itk-tree.sh" "$version" "$cache"
  ITK_DIR=$cache/build
fi

options=(
  -DITK_DIR="$ITK_DIR" -DBUILD_TESTING=OFF
  -DPython3_EXECUTABLE="$tools/bin/python"
  -DITK_USE_SYSTEM_CASTXML=ON -DCASTXML_EXECUTABLE="$(command -v castxml)"
  -DITK_USE_SYSTEM_SWIG=ON -DSWIG_EXECUTABLE="$tools/bin/swig"
  -DWRAP_ITK_INSTALL_COMPONENT_IDENTIFIER=PythonWheel
  # a path of another type would be made absolute, and the wheel be empty
  -DPY_SITE_PACKAGES_PATH:PATH=.
)
settings=()
for option in "${options[@]}"; do
  settings+=("-Ccmake.define.${option#-D}")
done
rm -rf "$build/dist"
PATH=$tools/bin:$PATH "$tools/bin/python" -m pip wheel "$project" --no-build-isolation --no-deps \
  --wheel-dir "$build/dist" -Cbuild-dir="$build/cmake" "${settings[@]}"

"$tools/bin/python" -m venv --clear "$build/venv"
"$build/venv/bin/pip" install --quiet "itk==$version" meshio pytest pyvista "$build"/dist/*.whl
cd "$build"
venv/bin/python -m pytest -p no:cacheprovider "$project/wrapping/test"
ls "$build"/dist/*.whl
