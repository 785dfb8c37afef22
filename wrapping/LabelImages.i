// Filters of label images take images of any scalar type whose values are whole numbers, and say what is wrong with
// others. ITK's own way is to list the types that it knows.
%pythoncode %{
def _as_labels(values, start=(0, 0, 0)):
    """The array as one of C's int, in which what is off a whole number by rounding is rounded, as in files. Errors tell
    the voxel, of which the first one has the index start."""
    import numpy as np

    limits = np.iinfo(np.intc)
    tolerance = 1e-3
    labels = values if values.dtype.kind in "iu" else np.rint(values)
    # written so that a value that is not a number fails
    with np.errstate(invalid="ignore", over="ignore"):
        is_label = (labels >= limits.min) & (labels <= limits.max) & (abs(values - labels) <= tolerance)
    if not is_label.all():
        place = np.unravel_index(np.argmin(is_label), values.shape)
        value = values[place]
        voxel = ", ".join(str(int(start[n] + index)) for n, index in enumerate(reversed(place)))
        if np.isfinite(value) and np.rint(value) == value:
            reason = f"labels have to be from {limits.min} to {limits.max}."
        else:
            reason = "a label image has whole numbers. Is this an intensity or probability image?"
        raise ValueError(f"Voxel ({voxel}) has the value {value}; {reason}")
    return labels.astype(np.intc)

def _as_label_image(source):
    """The image, or filter, or an image of itk.SI with the same values if filters are not wrapped for its pixels."""
    import os

    import itk

    image = itk.output(source)
    if not isinstance(image, (itk.Image, itk.VectorImage)):
        if isinstance(image, (str, os.PathLike)):
            raise TypeError(f"A label image is needed, not the name of a file; itk.imread('{image}') reads one.")
        if isinstance(image, itk.LightObject):
            raise TypeError(f"A label image is needed, not an object of {type(image).__name__}.")
        return source
    pixel, dimension = itk.template(image)[1]
    if dimension != 3:
        raise TypeError(f"The image has {dimension} dimensions; a three-dimensional label image is needed.")
    if not isinstance(pixel, itk.support.types.itkCType) or isinstance(image, itk.VectorImage):
        raise TypeError("The voxels have several components; an image with one value per voxel is needed.")
    if any(key[0] is type(image) for key in itk.MergeLabelIslandsImageFilter.keys()):
        return source

    image.Update()
    start = image.GetBufferedRegion().GetIndex()
    labels = itk.image_from_array(_as_labels(itk.array_view_from_image(image), start))
    labels.SetOrigin(image.TransformIndexToPhysicalPoint(start))
    labels.SetSpacing(image.GetSpacing())
    labels.SetDirection(image.GetDirection())
    return labels

def _accept_label_images(name):
    """Let New(image) and the function of the filter of this name, such as "itk::XFilter", take images of any type."""
    from itk.support.template_class import itkTemplate

    # There is one template object for each name. Its class is that of all of ITK, so the method goes to the object.
    template = itkTemplate(name)

    def New(*args, **kwargs):
        """itkTemplate.New() for label images, see help(itk.MedianImageFilter.New)."""
        if args:
            args = (_as_label_image(args[0]),) + args[1:]
        for key in {"Input", "input"} & kwargs.keys():
            kwargs[key] = _as_label_image(kwargs[key])
        return itkTemplate.New(template, *args, **kwargs)

    template.New = New
%}
