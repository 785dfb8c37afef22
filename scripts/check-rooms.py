#!/usr/bin/env python3
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
"""Checks that the rooms of src/ include each other as their READMEs say.

A README says which rooms its own may include, and which of its headers are for other rooms. This fails where an include
goes another way or reaches for another header, where rooms include each other in a circle, where headers of one room do,
and where a header of include/ includes one of src/.
"""
import re
import sys
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

project = Path(__file__).resolve().parent.parent
source = project / "src"


def readme_list(room, title):
    text = " ".join((source / room / "README.md").read_text().split())
    found = re.search(rf"- {title}: (.*?)\.(?= -|$)", text)
    return [] if found is None or found[1] == "nothing" else found[1].split(", ")


def includes(file):
    return re.findall(r'^\s*#\s*include "([^"]+)"', file.read_text(), re.M)


rooms = {str(readme.parent.relative_to(source)) for readme in source.rglob("README.md")}
allowed = {room: readme_list(room, "Includes") for room in rooms}
offered = {room: readme_list(room, "For other rooms") for room in rooms}
errors = [f"src/{room}/README.md names {other}, which is no room" for room in rooms for other in set(allowed[room]) - rooms]
headers = {}
for file in sorted(source.rglob("*.h")) + sorted(source.rglob("*.cxx")):
    room = str(file.parent.relative_to(source))
    for header in includes(file):
        if not (source / header).exists():
            continue
        other, _, name = header.rpartition("/")
        if file.suffix == ".h":
            headers.setdefault(str(file.relative_to(source)), []).append(header)
        if other != room and other not in allowed[room]:
            errors.append(f"{file.relative_to(project)} includes {header}, but {room} may not include {other}")
        elif other != room and offered[other] != ["all of it"] and name not in offered[other]:
            errors.append(f"{file.relative_to(project)} includes {header}, which is not for other rooms")
for file in sorted((project / "include").iterdir()):
    errors += [f"include/{file.name} includes {header} of src" for header in includes(file) if (source / header).exists()]
for graph in (allowed, headers):
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        errors.append("a circle: " + " -> ".join(error.args[1]))
print("\n".join(errors) or f"{len(rooms)} rooms in order")
sys.exit(bool(errors))
