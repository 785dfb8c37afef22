# =========================================================================
#
#  Copyright NumFOCUS
#
#  Licensed under the Apache License, Version 2.0 (the "License");
#  you may not use this file except in compliance with the License.
#  You may obtain a copy of the License at
#
#         https://www.apache.org/licenses/LICENSE-2.0.txt
#
#  Unless required by applicable law or agreed to in writing, software
#  distributed under the License is distributed on an "AS IS" BASIS,
#  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
#  See the License for the specific language governing permissions and
#  limitations under the License.
#
"""Pads on the skin as labels of an image."""

import gzip
import pathlib

import numpy as np
import scipy.ndimage

SKIN, ANODE, CATHODE = 1, 7, 8
RADIUS, THICKNESS = 25.0, 5.0  # mm
LEAST_VOXELS = 1.5  # of thickness, that pads have no holes
# from the middle of the head, in LPS: above the left motor cortex, and above the right eyebrow
PLACES = {ANODE: (0.6, 0.1, 0.8), CATHODE: (-0.45, -0.85, 0.3)}


def fields_of(lines):
    """The fields of an NRRD header."""
    return dict(line.split(": ", 1) for line in lines if ": " in line and line[0] != "#")


def steps_of(fields):
    """From voxel to voxel, a row for each axis, in mm."""
    return np.array([vector.strip("()").split(",") for vector in fields["space directions"].split()], float)


def read_image(name):
    """The array of [z, y, x], and the NRRD header without its encoding."""
    header, data = pathlib.Path(name).read_bytes().split(b"\n\n", 1)
    lines = header.decode().splitlines()
    fields = fields_of(lines)
    if fields["type"] not in ("uchar", "unsigned char", "uint8"):
        raise SystemExit(f"{name}: labels have to be of the type unsigned char, but are {fields['type']}.")
    data = gzip.decompress(data) if fields["encoding"] in ("gzip", "gz") else data
    shape = [int(size) for size in fields["sizes"].split()][::-1]
    kept = [line for line in lines if not line.startswith("encoding:")]
    return np.frombuffer(data, np.uint8).reshape(shape), kept, np.linalg.norm(steps_of(fields), axis=1)


def write_image(name, labels, header):
    pathlib.Path(name).write_bytes("\n".join([*header, "encoding: raw", "", ""]).encode() + labels.tobytes())


def paint_pads(labels, header, spacing):
    """Discs of a thickness on the skin around where a ray from the middle of the head leaves it."""
    labels = np.pad(labels, pad := int(np.ceil(1 + LEAST_VOXELS + THICKNESS / spacing.min())))
    head = scipy.ndimage.binary_fill_holes(labels > 0)
    distance = scipy.ndimage.distance_transform_edt(~head, spacing[::-1])
    thickness = max(THICKNESS, LEAST_VOXELS * spacing.max())
    # the axes of arrays are z, y, x
    middle = np.argwhere(head).mean(axis=0)
    places = np.indices(labels.shape).reshape(3, -1).T * spacing[::-1]
    pads = labels.copy()
    for label, direction in PLACES.items():
        way = np.array(direction[::-1]) / np.linalg.norm(direction)
        ray = middle + np.arange(0, 200, 0.5)[:, None] * way / spacing[::-1]
        ray = ray[np.all((ray >= 0) & (ray <= np.array(labels.shape) - 1), axis=1)]
        inside = head[tuple(np.rint(ray).astype(int).T)]
        place = ray[np.flatnonzero(inside)[-1]] * spacing[::-1]
        near = (np.linalg.norm(places - place, axis=1) < RADIUS).reshape(labels.shape)
        pads[near & ~head & (distance <= thickness)] = label
    return pads, resize(header, labels.shape, pad)


def resize(header, shape, pad):
    """The header of an image that has `pad` more voxels on each side."""
    fields = fields_of(header)
    origin = np.array(fields["space origin"].strip("()").split(","), float) - pad * steps_of(fields).sum(axis=0)
    fields["sizes"] = " ".join(map(str, shape[::-1]))
    fields["space origin"] = "(" + ",".join(map(str, origin)) + ")"
    return [header[0], *(f"{name}: {value}" for name, value in fields.items())]
