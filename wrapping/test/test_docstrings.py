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
"""help() has what the headers say: units, ranges and defaults of all settings."""

import inspect
import pydoc
import re

import itk
import pytest

FILTERS = [
    "IndicatorImagesToLabelImageFilter",
    "IndicatorImagesToMeshFilter",
    "IndicatorImagesToSizingImageFilter",
    "IndicatorImagesToTetrahedralMeshFilter",
    "LabelImageToIndicatorImagesFilter",
    "LabelImageToTetrahedralMeshFilter",
    "MergeLabelIslandsImageFilter",
    "OptimizeTetrahedralMeshFilter",
    "TetrahedralMeshQualityCalculator",
    "TriangleSurfaceToDistanceImageFilter",
]


def help_of(thing):
    return pydoc.render_doc(thing, renderer=pydoc.plaintext)


@pytest.mark.parametrize("name", FILTERS)
def test_templates_and_classes_have_docstrings(name):
    template = getattr(itk, name)
    classes = template.values()
    assert re.match(r"[A-Z]\w+ .*\.\n", template.__doc__)
    assert all(inspect.getdoc(each).startswith(template.__doc__) for each in classes)
    # nothing of Doxygen is left
    assert "\\" not in template.__doc__ and "/**" not in template.__doc__


@pytest.mark.parametrize(
    "name",
    [
        "ErrorDrivenSizing",
        "LabelHullMeshFilter",
        "LabelMeshFileWriter",
        "LabelSurfaceMeshFilter",
        "LabelTableReader",
        "SurfaceFileReader",
        "TetrahedronImageSampler",
        "VolumeFileReader",
    ],
)
def test_classes_have_docstrings(name):
    assert re.match(r"[A-Z]\w+ .*\.\n", inspect.getdoc(getattr(itk, name)))


def test_help_has_units_ranges_and_defaults():
    for thing in (itk.LabelImageToTetrahedralMeshFilter, itk.label_image_to_tetrahedral_mesh_filter):
        text = " ".join(help_of(thing).split())
        assert "SetRadius The radius of tightening, which rounds what is smaller, in mm, at least 0;" in text
        assert "SetEpsilon The edge length at the interfaces per local feature size, positive. Default: 2.5;" in text
        assert "SetSeed The particles' order of insertion. Another seed gives another mesh" in text


def test_every_setting_is_documented():
    text = itk.LabelImageToTetrahedralMeshFilter.__doc__
    own = {
        name
        for base in itk.LabelImageToTetrahedralMeshFilter.values()[0].__mro__
        for name in vars(base)
        if re.search("LabelImageToTetra|SizingFilter|MeshingFilter", base.__name__) and re.match("Set[A-Z]", name)
    }
    assert len(own) > 20
    assert [name for name in sorted(own) if not re.search(rf"\b{name}\b", text)] == []
