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
"""The command line programs that come with the package."""

import os
import pathlib
import subprocess
import sys


def _run(program):
    """Runs a program of this folder in place of this one, with the same arguments."""
    path = pathlib.Path(__file__).parent / program
    if os.name == "nt":
        sys.exit(subprocess.run([f"{path}.exe", *sys.argv[1:]]).returncode)
    os.execv(path, [program, *sys.argv[1:]])


def multimaterial_mesh():
    _run("multimaterial-mesh")


def optimize_tetrahedral_mesh():
    _run("optimize-tetrahedral-mesh")
