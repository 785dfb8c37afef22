#!/usr/bin/env python3
# ==========================================================================
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
"""Draws the extension's icon, three labels in each other, as PNG. It needs nothing but Python.

usage: draw-slicer-icon.py FILE
"""

import math
import pathlib
import struct
import sys
import zlib

SIZE = 128
SAMPLES = 4  # per pixel and axis
# from the outside in: the radius of each label, in parts of the icon, and its color
LABELS = ((0.48, (224, 172, 130)), (0.38, (240, 232, 212)), (0.29, (130, 90, 160)))
CLEAR = (0, 0, 0, 0)


def color_at(x, y):
    """Of a place, from (-0.5, -0.5) to (0.5, 0.5). The innermost label has folds."""
    radius, angle = math.hypot(x, y), math.atan2(y, x)
    color = CLEAR
    for outside, rgb in LABELS:
        if radius < outside + (0.025 * math.sin(9 * angle) if outside < 0.3 else 0):
            color = (*rgb, 255)
    return color


def pixel(row, column):
    """The mean of the samples; colors count by how opaque they are."""
    places = [(n + 0.5) / SAMPLES for n in range(SAMPLES)]
    samples = [color_at((column + u) / SIZE - 0.5, (row + v) / SIZE - 0.5) for v in places for u in places]
    opaque = [sample[:3] for sample in samples if sample[3]] or [(0, 0, 0)]
    return [sum(parts) // len(opaque) for parts in zip(*opaque)] + [sum(s[3] for s in samples) // len(samples)]


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main():
    rows = b"".join(b"\0" + bytes(sum((pixel(row, column) for column in range(SIZE)), [])) for row in range(SIZE))
    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 6, 0, 0, 0)
    png = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    pathlib.Path(sys.argv[1]).write_bytes(b"\x89PNG\r\n\x1a\n" + png)


if __name__ == "__main__":
    main()
