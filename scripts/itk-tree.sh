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
# usage: itk-tree.sh VERSION FOLDER
# Makes FOLDER/build, a build tree of ITK that this module's Python wrapping can be built against, from FOLDER/source. It
# holds what that needs and no more: static libraries, and the interfaces of the wrapped modules. ITK's own wrapping is
# not compiled, it comes with ITK's Python package. FOLDER/tools has the build tools, see python-tools.sh.
# The tree is complete when FOLDER/build/complete exists.
set -euo pipefail

version=$1
folder=$2
scripts=$(cd "$(dirname "$0")" && pwd)
source=$folder/source
build=$folder/build
tools=$folder/tools
[ -e "$build/complete" ] && exit

[ -d "$source" ] || "$scripts/itk-source.sh" "$version" "$source"

options=(
  -DCMAKE_BUILD_TYPE=MinSizeRel -DBUILD_SHARED_LIBS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON
  -DBUILD_TESTING=OFF -DBUILD_EXAMPLES=OFF
  -DITK_WRAP_PYTHON=ON -DITK_WRAP_DOC=OFF
  "-DPython3_EXECUTABLE=$tools/bin/python" "-DPython3_ROOT_DIR=$tools"
  -DITK_USE_SYSTEM_CASTXML=ON "-DCASTXML_EXECUTABLE=$(command -v castxml)"
  -DITK_USE_SYSTEM_SWIG=ON "-DSWIG_EXECUTABLE=$tools/bin/swig"
  # the types of label images, and the float of indicators
  -DITK_WRAP_IMAGE_DIMS=3 -DITK_WRAP_unsigned_char=ON -DITK_WRAP_unsigned_short=ON -DITK_WRAP_signed_short=ON
  -DITK_WRAP_float=ON -DITK_WRAP_double=OFF
  -DITK_WRAP_rgb_unsigned_char=OFF -DITK_WRAP_rgba_unsigned_char=OFF -DITK_WRAP_complex_float=OFF
  -DITK_BUILD_DEFAULT_MODULES=OFF -DITKGroup_Core=OFF
  # ITK's Python package uses TBB, and there is one thread pool for all
  -DModule_ITKTBB=ON
)
# the module's dependencies, as itk-module.cmake has them
modules=$(sed -n '/^  DEPENDS/,/^  TEST_DEPENDS/p' "$scripts/../itk-module.cmake" | grep -oE '^    ITK[A-Za-z0-9]+')
for module in $modules; do
  options+=("-DModule_$module=ON")
done

export PATH=$tools/bin:$PATH
cmake -G Ninja -S "$source" -B "$build" "${options[@]}"
libraries=$(ninja -C "$build" -t targets all | grep -oE '^lib/[^ ]*\.a:' | tr -d :)
# shellcheck disable=SC2086
cmake --build "$build" --target $libraries ITKMeshSwig ITKImageFilterBaseSwig ITKIOImageBaseSwig ITKIOMeshBaseSwig

# Forget the modules whose interfaces were not made; ITK would look for them.
for module in "$build"/Wrapping/Typedefs/ITK*.mdx; do
  while read -r interface; do
    if [ ! -e "$build/Wrapping/Typedefs/$interface" ]; then
      rm "$module"
      break
    fi
  done < <(grep '\.idx$' "$module")
done
touch "$build/complete"
