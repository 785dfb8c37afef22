#!/usr/bin/env python3
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
# =========================================================================
"""Runs multimaterial-mesh as a client of the Slicer Execution Model does.

The client is ctk-cli, a Python package. It reads the description that the program prints, which has to be to its
liking, and the command line is made from nothing but that. Usage: run-with-ctk-cli.py PROGRAM
"""

import logging
import pathlib
import re
import subprocess
import sys
import tempfile

import ctk_cli


class Complaints(logging.Handler):
    """What the client finds wrong with a description."""

    def __init__(self):
        super().__init__(logging.WARNING)
        self.texts = []

    def emit(self, record):
        self.texts.append(record.getMessage())


def write_label_image(name):
    """Two boxes, one around the other, as NRRD."""
    size = 16

    def label(x, y, z):
        distance = max(abs(c - 7.5) for c in (x, y, z))
        return 5 if distance < 3 else 2 if distance < 6 else 0

    voxels = bytes(label(x, y, z) for z in range(size) for y in range(size) for x in range(size))
    header = (
        "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {size} {size} {size}\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
        "space origin: (0,0,0)\nencoding: raw\n\n"
    )
    pathlib.Path(name).write_bytes(header.encode() + voxels)


def command_line(program, module, files):
    """The arguments as 3D Slicer builds them: all values that are not empty, flags that are true, then the files."""
    flags, indexed = [], {}
    for parameter in module.parameters():
        if parameter.index is not None:
            indexed[parameter.index] = files[parameter.name]
        elif parameter.name in files:
            flags += [parameter.longflag, files[parameter.name]]
        elif parameter.typ == "boolean":
            flags += [parameter.longflag] if parameter.default else []
        elif parameter.default not in (None, ""):
            flags += [parameter.longflag, str(parameter.default)]
    return [program] + flags + [indexed[i] for i in sorted(indexed)]


def main(program):
    complaints = Complaints()
    logging.getLogger("ctk_cli").addHandler(complaints)
    module = ctk_cli.CLIModule(program)
    # Slicer's own parser knows this attribute of images and models
    texts = [text for text in complaints.texts if not re.match("'reference' attribute of '(geometry|image)' ", text)]
    assert not texts, texts
    assert [group.label for group in module] == ["Input", "Output", "Smoothing", "Sizing", "Quality", "Advanced"]
    assert [group.advanced for group in module] == [False, False, False, False, False, True]

    with tempfile.TemporaryDirectory() as folder:
        files = {
            "LABELS": f"{folder}/labels.nrrd",
            "OUTPUT": f"{folder}/mesh.vtu",
            "surface": f"{folder}/surface.vtu",
            "save_sizing": f"{folder}/sizing.nrrd",
        }
        write_label_image(files["LABELS"])
        command = command_line(program, module, files)
        print(" ".join(command))
        process = ctk_cli.popenCLIExecutable(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True
        )
        output, errors = process.communicate()
        assert process.returncode == 0, errors
        for name in files.values():
            assert pathlib.Path(name).stat().st_size > 0, name
        progress = [float(value) for value in re.findall("<filter-progress>(.*)</filter-progress>", output)]
        assert progress == sorted(progress) and progress[0] == 0 and progress[-1] == 1, progress
    print(f"{len(list(module.parameters()))} parameters, {len(progress)} steps of progress")


if __name__ == "__main__":
    main(sys.argv[1])
