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
"""Labels and options, however one has them, as what the wrapped filters take."""

import json
import numbers
import os
import tempfile
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

MILLIMETERS = {"meter": 1e3, "mm": 1.0, "micron": 1e-3}
LABEL_SIZES = ("factor", "min", "max")


def as_image(labels: Any, spacing: Any) -> Any:
    """The labels as itk.Image."""
    import itk

    if isinstance(labels, (str, os.PathLike)):
        image = itk.VolumeFileReader.New(FileName=os.fspath(labels)).ReadLabels()
    elif isinstance(labels, itk.LightObject):
        image = labels
    elif hasattr(labels, "affine") and hasattr(labels, "dataobj"):
        image = _from_nibabel(labels)
    elif hasattr(labels, "__array__"):
        image = _from_array(np.asarray(labels))
        image.SetSpacing(_as_spacing(1.0 if spacing is None else spacing))
        return image
    else:
        raise TypeError(
            f"Labels of type {type(labels).__name__} are not taken; give a NumPy array, an itk.Image, an image of "
            "nibabel or the name of a file."
        )
    if spacing is not None:
        raise TypeError("A spacing is taken with an array only; this image has one of its own.")
    return image


def as_labels(labels: Any, name: str) -> list[int]:
    if labels is None:
        return []
    values = [labels] if isinstance(labels, numbers.Integral) else labels
    if isinstance(values, str) or not isinstance(values, Iterable):
        values = [None]
    values = list(values)
    if not all(isinstance(value, numbers.Integral) for value in values):
        raise TypeError(f"{name} is {labels!r}; a whole number, or some of them, or None is taken.")
    return [int(value) for value in values]


def as_names(names: Any, labels: Any) -> dict[int, str]:
    """The names as a dictionary: those given, of a file, or those found beside the labels' file."""
    import itk

    reader = itk.LabelTableReader.New()
    if isinstance(names, Mapping):
        return {int(label): str(name) for label, name in names.items()}
    if names is None and isinstance(labels, (str, os.PathLike)):
        names = reader.FindFileFor(os.fspath(labels)) or None
    if names is None:
        return {}
    reader.SetFileName(os.fspath(names))
    reader.Read()
    return {label: entry.name for label, entry in reader.GetLabelTable().items() if entry.name}


def as_sampled_image(image: Any) -> tuple[Any, Any]:
    """An image of floats, or one of tensors of floats; the other one is None."""
    import itk

    if isinstance(image, (str, os.PathLike)):
        reader = itk.VolumeFileReader.New(FileName=os.fspath(image))
        return (None, reader.ReadTensors()) if reader.HasTensors() else (reader.ReadScalars(), None)
    tensors = itk.Image[itk.SymmetricSecondRankTensor[itk.F, 3], 3]
    if isinstance(image, tensors):
        return None, image
    scalars = itk.Image[itk.F, 3]
    if isinstance(image, scalars):
        return image, None
    if not isinstance(image, itk.Image):
        raise TypeError(f"An image of type {type(image).__name__} is not taken; give an itk.Image or a file's name.")
    array = itk.array_view_from_image(image)
    if array.ndim != 3:
        raise TypeError("The image has not three dimensions and one number per voxel.")
    copy = itk.image_from_array(array.astype(np.float32))
    copy.CopyInformation(image)
    return copy, None


def as_label_sizes(sizes: Any) -> str | None:
    """The text that the filter takes, such as "3:factor=0.5:max=2,7:min=1"."""
    if sizes is None or isinstance(sizes, str):
        return sizes
    if not isinstance(sizes, Mapping):
        raise TypeError(
            f"label_sizes is {sizes!r}; a dictionary by label is taken, such as {{3: {{'max': 2.0}}, 7: 1.5}}."
        )
    rules = []
    for label, rule in sizes.items():
        rule = rule if isinstance(rule, Mapping) else {"max": rule}
        lengths = [isinstance(value, numbers.Real) for value in rule.values()]
        if not isinstance(label, numbers.Integral) or not all(lengths) or not set(rule) <= set(LABEL_SIZES):
            raise TypeError(
                f"label_sizes has {label!r}: {sizes[label]!r}; by label, a number or a dictionary of numbers named "
                f"{', '.join(LABEL_SIZES)} is taken."
            )
        rules.append(":".join([str(int(label)), *(f"{key}={float(value)!r}" for key, value in rule.items())]))
    return ",".join(rules)


def set_option(mesher: Any, name: str, value: Any) -> None:
    """Call the setter that has this name in lower case."""
    method = "".join(part.capitalize() for part in name.split("_"))
    setter = getattr(mesher, f"Set{method}", None)
    if setter is None:
        raise TypeError(f"multimaterial_mesh() has no option {name}; help(itk.multimaterial_mesh) lists them.")
    if isinstance(value, np.generic):
        value = value.item()
    try:
        setter(value)
    except (NotImplementedError, OverflowError, TypeError):
        known = getattr(mesher, f"Get{method}", lambda: None)()
        kinds = {bool: "True or False", int: "a whole number, at least 0,", float: "a number"}
        kind = kinds.get(type(known), "an itk.Image of the right type of pixels" if known is None else "another type")
        raise TypeError(f"{name} is {value!r}, of type {type(value).__name__}; {kind} is taken.") from None


def set_electrodes(mesher: Any, electrodes: Any) -> None:
    """Take a file of electrodes, or what is in one as a dictionary, of numbers that may be NumPy's."""
    if not isinstance(electrodes, Mapping):
        mesher.SetElectrodes(os.fspath(electrodes))
        return
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "electrodes.json")
        with open(name, "w", encoding="utf-8") as file:
            json.dump(electrodes, file, default=lambda value: value.tolist())
        mesher.SetElectrodes(name)


def _as_spacing(spacing: Any) -> list[float]:
    values = [spacing] * 3 if isinstance(spacing, numbers.Real) else spacing
    values = list(values) if isinstance(values, Iterable) else []
    if len(values) != 3 or not all(isinstance(value, numbers.Real) for value in values):
        raise TypeError(f"spacing is {spacing!r}; a length in mm, or three along x, y and z, is taken.")
    if not all(0.0 < value < np.inf for value in values):
        raise ValueError(f"spacing is {spacing!r}; lengths are positive.")
    return [float(value) for value in values]


def _from_array(array: np.ndarray) -> Any:
    import itk
    from itk.itkMultiMaterialMeshTypesPython import _as_labels

    if array.ndim != 3:
        raise TypeError(f"The array has {array.ndim} dimensions; one with three is needed.")
    if array.dtype.kind not in "biuf":
        raise TypeError(f"An array of {array.dtype} is not taken; labels are integers, bool or whole numbers.")
    if array.dtype == bool:
        array = array.astype(np.uint8)
    elif array.dtype not in (np.uint8, np.uint16, np.int16, np.int32):
        array = _as_labels(array)
    return itk.image_from_array(np.ascontiguousarray(array))


def _from_nibabel(source: Any) -> Any:
    """The image of nibabel is indexed by x, y, z, and its affine leads to RAS; here it is z, y, x and LPS."""
    values = np.asanyarray(source.dataobj)
    if values.ndim > 3 and set(values.shape[3:]) == {1}:
        values = values.reshape(values.shape[:3])
    image = _from_array(values.T)
    unit = getattr(source.header, "get_xyzt_units", lambda: ("mm",))()[0]
    affine = MILLIMETERS.get(unit, 1.0) * np.diag([-1.0, -1.0, 1.0]) @ np.asarray(source.affine, float)[:3]
    spacing = np.linalg.norm(affine[:, :3], axis=0)
    if not np.isfinite(affine).all() or np.linalg.matrix_rank(affine[:, :3]) < 3:
        raise ValueError(f"The image has no place: its affine is singular or not finite, {source.affine.tolist()}.")
    image.SetSpacing(spacing.tolist())
    # the axes need not be at right angles
    image.SetDirection(affine[:, :3] / spacing)
    image.SetOrigin(affine[:, 3].tolist())
    return image
