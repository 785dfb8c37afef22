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
"""Sums up the reports of multimaterial-mesh in a table and a picture. Snakemake runs it, see Snakefile."""
"""Exports the extension for 3D Slicer and checks what Slicer's index asks of it; CMake has to take it.

usage: check-extension.py TETGEN_SOURCE [OPTION_OF_CMAKE...]
"""

import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

project = pathlib.Path(__file__).resolve().parents[2]
script = project / "scripts/export-slicer-extension.sh"
ADDRESS = "https://github.com/someone/SlicerMeshes"
# slicer-extension-catalog-entry-schema-v1.0.1.json, which takes no others
REQUIRED = {"$schema", "category", "scm_url"}
TYPES = {
    "$schema": str,
    "build_dependencies": list,
    "build_subdirectory": str,
    "category": str,
    "enabled": bool,
    "scm_revision": str,
    "scm_type": str,
    "scm_url": str,
    "tier": int,
}


def export(*arguments):
    return subprocess.run(["bash", str(script), *map(str, arguments)], capture_output=True, text=True)


def check_entry(entry, settings):
    assert REQUIRED <= entry.keys() <= TYPES.keys(), entry
    for key, value in entry.items():
        assert type(value) is TYPES[key], (key, value)
    assert entry["$schema"].endswith("/slicer-extension-catalog-entry-schema-v1.0.1.json#")
    assert entry["scm_url"] == ADDRESS + ".git"
    assert 1 <= entry["tier"] <= 5
    assert entry["build_subdirectory"] == settings["BUILD_SUBDIRECTORY"]
    assert (entry["build_dependencies"] or "NA") == settings["DEPENDS"]


def check_settings(settings, repository):
    assert settings["HOMEPAGE"] == ADDRESS
    assert "AGPL" in settings["DESCRIPTION"] and "TetGen" in settings["DESCRIPTION"]
    raw = "https://raw.githubusercontent.com/someone/SlicerMeshes/main/"
    for key in ("ICONURL", "SCREENSHOTURLS"):
        assert settings[key].startswith(raw), settings[key]
        picture = (repository / settings[key][len(raw) :]).read_bytes()
        assert picture.startswith(b"\x89PNG")
    width, height = struct.unpack(">II", (repository / "MultiMaterialMeshing.png").read_bytes()[16:24])
    assert width == height == 128


def check_readme(repository):
    text = (repository / "README.md").read_text()
    for target in re.findall(r"\]\(([^)]+)\)", text):
        assert target.startswith("https://") or (repository / target).exists(), target
    for word in ("Multimaterial Mesh", "Apache License 2.0", "AGPL", "## Publication"):
        assert word in text, word
    assert "Apache License" in (repository / "LICENSE.txt").read_text()


def configure(repository, tetgen, options):
    command = ["cmake", "-S", repository, "-B", repository.parent / "build", "-DCMAKE_BUILD_TYPE=Release"]
    command += ["-DMultiMaterialMeshing_SUPERBUILD=OFF", f"-DSlicer_DIR={project}/test/slicer/stand-in"]
    command += [f"-DMultiMaterialMeshing_TETGEN_SOURCE={tetgen}", *options]
    return subprocess.run([str(part) for part in command], capture_output=True, text=True)


def main():
    tetgen, *options = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        done = export(folder, "https://github.com/someone/Meshes")
        assert done.returncode == 1 and len(done.stderr.splitlines()) == 1 and "begin with Slicer" in done.stderr
        done = export(folder, ADDRESS)
        assert done.returncode == 0, done.stderr
        again = export(folder, ADDRESS)
        assert again.returncode == 1 and "is not empty" in again.stderr, again.stderr

        repository = pathlib.Path(folder, "SlicerMeshes")
        cmake = (repository / "CMakeLists.txt").read_text()
        # as the index reads it
        assert re.search(r"project\s*\(\s*([^\s\)]+)", cmake)[1] == "MultiMaterialMeshing"
        settings = {key: value.strip('"') for key, value in re.findall(r'set\(EXTENSION_(\w+) ("[^"]+"|\S+)\)', cmake)}
        check_settings(settings, repository)
        check_entry(json.loads(pathlib.Path(folder, "MultiMaterialMeshing.json").read_text()), settings)
        check_readme(repository)

        done = configure(repository, "", options)
        assert done.returncode != 0 and "TETGEN_SOURCE is empty" in done.stderr, done.stderr
        done = configure(repository, tetgen, options)
        assert done.returncode == 0, done.stderr


if __name__ == "__main__":
    main()
