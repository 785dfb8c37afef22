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
# usage: tetgen-source.sh CACHE
# Prints the folder of TetGen's source, which it gets from Debian into the folder CACHE unless it is there.
set -euo pipefail

version=1.5.0 # another version makes other meshes
source=$1/tetgen-$version-source
mkdir -p "$1"
[ -d "$source" ] || "$(dirname "$0")/debian-source.sh" tetgen "$version" "$source" >&2
echo "$source"
