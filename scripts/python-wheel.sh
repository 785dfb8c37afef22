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
# Builds the Python package of the module and tests it in a new virtual environment, on Debian 12. Installs what it needs,
# gets and builds ITK once, and leaves the wheel in BUILD_DIR/dist.
#
#   BUILD_DIR       where the wheel is built and tested; default: build/python
#   BUILD_TESTING   ON also builds the C++ tests, with the same ITK, and leaves them for ctest in BUILD_DIR/cmake; default: OFF
#   CMAKE_BUILD_PARALLEL_LEVEL   compilers at a time; default: as many as there are cores
#   ITK_DIR         a build tree of ITK to use, as itk-tree.sh makes it; default: one in the user's cache folder
#   MULTIMATERIAL_MESH   another command line program, whose meshes the tests compare, too
#   PYTHON          default: python3, at least 3.11
set -euo pipefail

version=5.4.7
project=$(cd "$(dirname "$0")/.." && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/multimaterial-meshing
build=${BUILD_DIR:-$project/build/python}
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export PIP_DISABLE_PIP_VERSION_CHECK=1

"$project/scripts/apt-install.sh" \
  castxml g++ libcli11-dev libgtest-dev libtbb-dev nlohmann-json3-dev python3-dev python3-venv xz-utils
tools=$("$project/scripts/python-tools.sh" "$cache/python-tools")
export PATH=$tools:$PATH
ITK_DIR=${ITK_DIR:-$("$project/scripts/itk-tree.sh" "$version" "$cache")}
tetgen=$("$project/scripts/tetgen-source.sh" "$cache")

options=(
  -DITK_DIR="$ITK_DIR" -DBUILD_TESTING="${BUILD_TESTING:-OFF}"
  # with tests, ITK would get programs that check style
  -DITK_USE_CLANG_FORMAT=OFF -DITK_USE_KWSTYLE=OFF
  -DMultiMaterialMeshing_TETGEN_SOURCE="$tetgen"
  -DPython3_EXECUTABLE="$(command -v python)"
  -DITK_USE_SYSTEM_SWIG=ON -DSWIG_EXECUTABLE="$(command -v swig)"
  -DWRAP_ITK_INSTALL_COMPONENT_IDENTIFIER=PythonWheel
  # a path of another type would be made absolute, and the wheel be empty
  -DPY_SITE_PACKAGES_PATH:PATH=.
)
if command -v castxml > /dev/null; then
  options+=(-DITK_USE_SYSTEM_CASTXML=ON -DCASTXML_EXECUTABLE="$(command -v castxml)")
fi
settings=()
for option in "${options[@]}"; do
  settings+=("-Ccmake.define.${option#-D}")
done
rm -rf "$build/dist" "$build/venv"
python -m pip wheel "$project" --no-build-isolation --no-deps \
  --wheel-dir "$build/plain" -Cbuild-dir="$build/cmake" "${settings[@]}"
# with the libraries that it needs, under the name of the oldest systems that it runs on
case $(uname) in
  Linux) auditwheel repair --wheel-dir "$build/dist" "$build"/plain/*.whl ;;
  Darwin) delocate-wheel --wheel-dir "$build/dist" "$build"/plain/*.whl ;;
  *) delvewheel repair --wheel-dir "$build/dist" "$build"/plain/*.whl ;;
esac
rm -r "$build/plain"

python -m venv "$build/venv"
for python in "$build"/venv/bin/python "$build"/venv/Scripts/python.exe; do
  [ -e "$python" ] || continue
  "$python" -m pip install --quiet --requirement "$project/wrapping/test/requirements.txt" "$build"/dist/*.whl
  (cd "$build" && "$python" -m pytest -p no:cacheprovider "$project/wrapping/test")
done
ls "$build"/dist/*.whl
