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
# usage: itk-tree.sh VERSION CACHE
# Prints the folder of a build tree of ITK, which it makes in the folder CACHE unless it is there. This module, its tests
# and its Python wrapping can be built against it. It holds what they need and no more: static libraries, and the
# interfaces of the wrapped modules. ITK's own wrapping is not compiled, it comes with ITK's Python package. The tools of
# python-tools.sh are on the PATH. Another version, option or compiler makes another tree.
set -euo pipefail

version=$1
cache=$2
scripts=$(cd "$(dirname "$0")" && pwd)
source=$cache/itk-$version-source

# where the system has none, ITK gets it
castxml=()
if command -v castxml > /dev/null; then
  castxml=(-DITK_USE_SYSTEM_CASTXML=ON "-DCASTXML_EXECUTABLE=$(command -v castxml)")
fi
options=(
  -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON
  -DBUILD_TESTING=OFF -DBUILD_EXAMPLES=OFF
  -DITK_WRAP_PYTHON=ON -DITK_WRAP_DOC=OFF
  "-DPython3_EXECUTABLE=$(command -v python)" "-DPython3_ROOT_DIR=$(python -c 'import sys; print(sys.prefix)')"
  "${castxml[@]}"
  -DITK_USE_SYSTEM_SWIG=ON "-DSWIG_EXECUTABLE=$(command -v swig)"
  # the types of label images, and the float of indicators
  -DITK_WRAP_IMAGE_DIMS=3 -DITK_WRAP_unsigned_char=ON -DITK_WRAP_unsigned_short=ON -DITK_WRAP_signed_short=ON
  -DITK_WRAP_float=ON -DITK_WRAP_double=OFF
  -DITK_WRAP_rgb_unsigned_char=OFF -DITK_WRAP_rgba_unsigned_char=OFF -DITK_WRAP_complex_float=OFF
  -DITK_BUILD_DEFAULT_MODULES=OFF -DITKGroup_Core=OFF
  # ITK's Python package uses TBB but on macOS, and there is one thread pool for all
  "-DModule_ITKTBB=$([ "$(uname)" = Darwin ] && echo OFF || echo ON)"
)
# what the module and its tests depend on, as itk-module.cmake has it
modules=$(sed -n '/^  DEPENDS/,/^  FACTORY_NAMES/p' "$scripts/../itk-module.cmake" | grep -oE '^    ITK[A-Za-z0-9]+')
for module in $modules; do
  options+=("-DModule_$module=ON")
done
interfaces=(ITKMeshSwig ITKImageFilterBaseSwig ITKIOImageBaseSwig ITKIOMeshBaseSwig)

key=$({ printf '%s\n' "${options[@]}" "${interfaces[@]}"; "${CXX:-c++}" -dumpfullversion; } |
  python -c 'import hashlib, sys; print(hashlib.sha256(sys.stdin.buffer.read()).hexdigest()[:12])')
tree=$cache/itk-$version-$key
mkdir -p "$cache"
if command -v flock > /dev/null; then
  exec 9> "$cache/lock"
  flock 9
fi

if [ -e "$tree/complete" ]; then
  # Modules that are built against a tree leave their files there.
  find "$tree" -newer "$tree/complete" ! -type d -delete
else
  {
    [ -d "$source" ] || "$scripts/debian-source.sh" insighttoolkit5 "$version" "$source" sid
    cmake -G Ninja -S "$source" -B "$tree" "${options[@]}"
    libraries=$(ninja -C "$tree" -t targets all | grep -oE '^lib/[^ ]*\.(a|lib):' | tr -d :)
    # shellcheck disable=SC2086
    cmake --build "$tree" --target $libraries "${interfaces[@]}"

    # Forget the modules whose interfaces were not made; ITK would look for them.
    for module in "$tree"/Wrapping/Typedefs/ITK*.mdx; do
      while read -r interface; do
        if [ ! -e "$tree/Wrapping/Typedefs/$interface" ]; then
          rm "$module"
          break
        fi
      done < <(grep '\.idx$' "$module")
    done
    # by now, all is older
    sleep 1
    touch "$tree/complete"
  } >&2
fi
echo "$tree"
