// numpy.asarray(container) for containers of arrays of int, which ITK's own conversion does not know.
%define DECL_PYTHON_INT_ARRAYS_CLASS(swig_name)
%extend swig_name {
  PyObject * _view()
  {
    auto & elements = self->CastToSTLContainer();
    static char nothing;
    char *      data = elements.empty() ? &nothing : reinterpret_cast<char *>(elements.data());
    return PyMemoryView_FromMemory(data, elements.size() * sizeof(swig_name::Element), PyBUF_READ);
  }
  int _width()
  {
    return sizeof(swig_name::Element) / sizeof(int);
  }
  %pythoncode %{
    def __array__(self, dtype=None, copy=None):
        """A copy of the elements, one per row."""
        import numpy as np
        rows = np.frombuffer(self._view(), np.intc).reshape(self.Size(), self._width())
        return rows.astype(np.intc if dtype is None else dtype)
  %}
}
%enddef
