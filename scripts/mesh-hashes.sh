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
# usage: mesh-hashes.sh [IMAGE...]
# Prints a line for each image: the hashes of mesh and surface and the report's counts. Two versions of the program that
# print the same lines make the same meshes, to the last bit. Images are the head phantom at 3 mm, two random ones, AAL if
# Debian's mricron-data is there, and those that are given; the label 0 is the exterior, as by default.
#
#   BUILD_DIR   where the programs multimaterial-mesh and make-head-phantom are; default: build
set -euo pipefail

project=$(cd "$(dirname "$0")/.." && pwd)
bin=$(cd "${BUILD_DIR:-$project/build}/bin" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$bin/make-head-phantom" "$work/phantom.nrrd" 3
# cells around random centres with noise on them, and noise alone, by a generator of its own
python3 - "$work" <<'PYTHON'
import sys

state = 1


def draw(n):
    global state
    state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
    return (state >> 33) % n


def write(name, size, label):
    labels = bytes(label(i, j, k) for k in range(size) for j in range(size) for i in range(size))
    header = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {size} {size} {size}\nencoding: raw\n\n"
    open(f"{sys.argv[1]}/{name}.nrrd", "wb").write(header.encode() + labels)


centres = [[draw(24) for _ in range(3)] for _ in range(12)]
distance = lambda n, x: sum((a - b) ** 2 for a, b in zip(centres[n], x))
write("cells", 24, lambda *x: draw(5) if draw(20) == 0 else min(range(12), key=lambda n: distance(n, x)) % 5)
write("noise", 12, lambda *x: draw(3))
PYTHON

images=("$work/phantom.nrrd" "$work/cells.nrrd" "$work/noise.nrrd")
aal=/usr/share/mricron/templates/aal.nii.gz
[ ! -e "$aal" ] || images+=("$aal")
images+=("$@")
for image in "${images[@]}"; do
  "$bin/multimaterial-mesh" --quiet "$image" "$work/mesh.mesh" --surface "$work/surface.mesh" --report "$work/report.json"
  python3 - "$(basename "$image")" "$work" <<'PYTHON'
import hashlib
import json
import sys

name, work = sys.argv[1:]
digest = lambda file: hashlib.sha256(open(f"{work}/{file}", "rb").read()).hexdigest()[:16]
report = json.load(open(f"{work}/report.json"))


def counts(node):
    """The whole numbers in a part of the report, and how long its lists are."""
    children = node.values() if isinstance(node, dict) else node if isinstance(node, list) else []
    if isinstance(node, list):
        yield len(node)
    for child in children:
        yield from counts(child)
    if isinstance(node, int):
        yield node


parts = ("islands_merged", "vanished_labels", "counts", "relaxation", "topology", "optimization", "quality")
numbers = ",".join(str(number) for part in parts for number in counts(report[part]))
print(
    name,
    "mesh", digest("mesh.mesh"),
    "surface", digest("surface.mesh"),
    "counts", hashlib.sha256(numbers.encode()).hexdigest()[:16],
    f"({report['counts']['tetrahedra']} tetrahedra)",
)  # fmt: skip
PYTHON
done
