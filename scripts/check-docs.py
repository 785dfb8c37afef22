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
"""Checks the Markdown pages: links lead to files and headings that are there, and the messages that the page on
troubleshooting explains are those of the sources.

What stands for names and numbers in a message is an ellipsis; the texts between them have to be in a source as they are.
"""
import re
import subprocess
import sys
from pathlib import Path

project = Path(__file__).resolve().parent.parent
LEAST_TEXT = 8  # characters of a message that are looked for


def tracked(*patterns):
    """Files of the project; those in folders of builds are not."""
    names = (file.relative_to(project) for pattern in patterns for file in sorted(project.rglob(pattern)))
    return [project / name for name in names if not re.match(r"build|out|\.", name.parts[0])]


def headings(page):
    """The anchors of a page, as code hosts make them."""
    titles = re.findall(r"^#+ (.*)", page.read_text(), re.M)
    plain = (re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title).strip().lower() for title in titles)
    return {re.sub(r"[^\w\- ]", "", title).replace(" ", "-") for title in plain}


def broken_links(page):
    text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.S | re.M)
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        name, _, anchor = link.partition("#")
        target = page.parent / name if name else page
        if not re.match(r"https?:|mailto:", link):
            if not target.exists():
                yield f"{page.relative_to(project)}: {link} is not there"
            elif anchor and anchor not in headings(target):
                yield f"{page.relative_to(project)}: {link} has no such heading"


def unknown_messages(page):
    """Texts in the first columns that no source has. Texts that a source puts together from parts are looked for in
    parts."""
    sources = "\n".join(
        file.read_text() for file in tracked("*.cxx", "*.h", "*.hxx", "*.i", "CMakeLists.txt", "*.cmake")
    )
    joined = re.sub(r'"\s*"', "", sources).replace('\\"', '"')
    for row in re.findall(r"^\| (.*?) \|", page.read_text(), re.M):
        for message in re.findall(r"`([^`]+)`", row):
            for text in message.split("…"):
                if len(text.strip()) >= LEAST_TEXT and text.strip(" .") not in joined:
                    yield f"{page.relative_to(project)}: no source says '{text.strip()}'"


pages = tracked("*.md")
errors = [error for page in pages for error in broken_links(page)]
errors += unknown_messages(project / "docs/troubleshooting.md")
print("\n".join(errors) or f"{len(pages)} pages in order")
sys.exit(bool(errors))
