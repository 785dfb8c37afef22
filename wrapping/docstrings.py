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
"""Makes a filter's docstring from the comments of its header and those of its superclasses in this module.

usage: docstrings.py CLASS SWIG_NAME...

Prints SWIG code that gives it to the classes of these names, and to itk.CLASS if that is a template.
"""

import pathlib
import re
import sys
import textwrap

WIDTH = 100
INCLUDE = pathlib.Path(__file__).resolve().parent.parent / "include"
# a comment, and the declarations that follow, up to an empty line or another comment
COMMENT = re.compile(r"/\*\*((?s:.*?))\*/\n((?:(?!\s*/\*\*).*\S.*\n)*)")
# by a macro or plainly
SETTER = re.compile(r"^\s+(?:itkSet\w*Macro\((\w+)|Set(\w+)\()", re.MULTILINE)
GETTER = re.compile(r"^\s+(?:itkGet\w*Macro\((\w+)|Get(\w+)\()", re.MULTILINE)


def words_of(comment):
    """The text without the marks of comments and the commands of Doxygen; paragraphs and lists stay."""
    lines = [re.sub(r"^\s*\*? ?", "", line) for line in comment.strip().splitlines()]
    text = "\n".join(line for line in lines if not re.match(r"\\(class|ingroup|sa|tparam)\b", line))
    return re.sub(r"\\brief ", "", text).strip()


def superclasses(name):
    """The class and those that it has from this module."""
    header = INCLUDE / f"itk{name}.h"
    if not header.exists():
        return []
    superclass = re.search(r"using Superclass = (.*?);", header.read_text(), re.DOTALL)[1]
    return [name] + [other for part in re.findall(r"\w+", superclass) for other in superclasses(part)]


def docstring(name):
    settings, results, introduction = [], [], ""
    for each in superclasses(name):
        public = (INCLUDE / f"itk{each}.h").read_text().partition("\nprotected:")[0]
        for comment, declarations in COMMENT.findall(public):
            words = words_of(comment)
            if f"\\class {each}\n" in comment:
                introduction = introduction or words
            for kind, pattern in ((settings, SETTER), (results, GETTER)):
                members = dict.fromkeys(a or b for a, b in pattern.findall(declarations))
                if members:
                    prefix = "Set" if kind is settings else "Get"
                    title = ", ".join(prefix + member for member in members)
                    kind.append(f"{title}\n{textwrap.indent(textwrap.fill(words, WIDTH - 4), '    ')}")
                    break
    parts = [introduction]
    for title, members in (("Settings", settings), ("Results", results)):
        parts += [f"{title}\n{'-' * len(title)}", *members] if members else []
    return "\n\n".join(parts)


def main():
    name, *swig_names = sys.argv[1:]
    text = docstring(name)
    for swig_name in swig_names:
        print(f'%feature("docstring") {swig_name} %{{{text}\n%}}')
    if swig_names != [f"itk{name}"]:
        print("%pythoncode %{\nfrom itk.support.template_class import itkTemplate as _itkTemplate")
        print(f"_itkTemplate('itk::{name}').__doc__ = r'''{text}'''\n%}}")


if __name__ == "__main__":
    main()
