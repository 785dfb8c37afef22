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
# From a bare Debian 12 to the mesh of an atlas: installs what is needed, builds, meshes the 116 regions of the AAL atlas
# (package mricron-data) and renders the mesh. Results are in the folder "out" of where it is called.
set -euo pipefail

project=$(cd "$(dirname "$0")/../.." && pwd)
export BUILD_DIR=${BUILD_DIR:-$project/build}
"$project/scripts/build.sh" -DBUILD_TESTING=OFF
"$project/scripts/apt-install.sh" mricron-data python3-vtk9 xvfb

mkdir -p out
"$BUILD_DIR/bin/multimaterial-mesh" /usr/share/mricron/templates/aal.nii.gz out/aal.vtu \
  --surface out/aal-surface.vtu --report out/aal-report.json
# Debian's own Python has Debian's VTK.
/usr/bin/python3 "$project/examples/RenderMesh.py" out/aal.vtu out/aal.png
ls -l out
