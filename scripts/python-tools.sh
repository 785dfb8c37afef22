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
# Makes FOLDER, a virtual environment with the tools that build ITK's wrapping, or does nothing if it is there.
set -euo pipefail

folder=$1
[ -e "$folder/complete" ] && exit
"${PYTHON:-python3}" -m venv --clear "$folder"
"$folder/bin/pip" install --quiet --upgrade pip
# SWIG has to be the one that ITK's Python package was made with: others do not share types with it.
"$folder/bin/pip" install --quiet 'cmake<4' ninja numpy scikit-build-core swig==4.3.0
touch "$folder/complete"
