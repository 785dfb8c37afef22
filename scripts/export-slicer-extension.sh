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
# usage: export-slicer-extension.sh FOLDER [ADDRESS]
# Makes of slicer/ and the module's source what Slicer's extension index wants: in FOLDER, a repository of its own, and
# MultiMaterialMeshing.json, its entry in the index. ADDRESS is where the repository is going to be, at GitHub.
set -euo pipefail

fail() {
  echo "export-slicer-extension.sh: $1" >&2
  exit 1
}
[ $# -eq 1 ] || [ $# -eq 2 ] || fail "usage: export-slicer-extension.sh FOLDER [ADDRESS]"
parent=$1
default=https://github.com/InsightSoftwareConsortium/SlicerMultiMaterialMeshing
address=${2:-$default}
project=$(cd "$(dirname "$0")/.." && pwd)
[[ $address =~ ^https://github\.com/[^/]+/Slicer[^/]*$ ]] ||
  fail "$address is not https://github.com/OWNER/Slicer...; the index wants names of repositories that begin with Slicer"
[ ! -e "$parent" ] || [ -z "$(ls -A "$parent")" ] || fail "$parent is not empty; give another folder, or empty it"
folder=$parent/${address##*/}

mkdir -p "$folder/MultiMaterialMeshing" "$folder/docs"
cp -R "$project/slicer/." "$folder"
cp "$project/LICENSE" "$folder/LICENSE.txt"
cp "$project/NOTICE" "$folder"
cp "$project/docs/head.png" "$folder/docs"
for part in applications cmake include itk-module.cmake LICENSE NOTICE src; do
  cp -R "$project/$part" "$folder/MultiMaterialMeshing"
done
rm -r "$folder/MultiMaterialMeshing/applications/"*/test
python3 "$project/scripts/draw-slicer-icon.py" "$folder/MultiMaterialMeshing.png"

sed -i.old 's|](../|](|g' "$folder/README.md"
sed -i.old -e "s|$default|$address|g" \
  -e "s|https://raw.githubusercontent.com/InsightSoftwareConsortium/SlicerMultiMaterialMeshing|${address/github.com/raw.githubusercontent.com}|g" \
  "$folder/CMakeLists.txt"
rm "$folder"/*.old
# Tier 1, as 3 wants a permissive license of the main functions, and TetGen has none
cat > "$parent/MultiMaterialMeshing.json" << EOF
{
  "\$schema": "https://raw.githubusercontent.com/Slicer/Slicer/main/Schemas/slicer-extension-catalog-entry-schema-v1.0.1.json#",
  "build_dependencies": [],
  "build_subdirectory": "inner-build",
  "category": "Segmentation",
  "scm_revision": "main",
  "scm_url": "$address.git",
  "tier": 1
}
EOF
