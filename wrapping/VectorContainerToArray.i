// numpy.asarray(container) for containers of int and of arrays of int, which ITK's own conversion does not know. It is a
// view, one element per row, that keeps the container alive.
%define DECL_PYTHON_INT_ARRAYS_CLASS(swig_name)
%extend swig_name {
  PyObject * _address()
  {
    return PyLong_FromVoidPtr(self->CastToSTLContainer().data());
  }
  int _width()
  {
    return sizeof(swig_name::Element) / sizeof(int);
  }
  %pythoncode %{
    @property
    def __array_interface__(self):
        import numpy as np
        size, width = self.Size(), self._width()
        if size == 0:
            return np.empty((0, width) if width > 1 else 0, np.intc).__array_interface__
        return {
            "version": 3,
            "shape": (size, width) if width > 1 else (size,),
            "typestr": np.dtype(np.intc).str,
            "data": (self._address(), False),
        }
  %}
}
%enddef
