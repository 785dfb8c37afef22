// The functional interface returns all outputs. ITK's own looks for all of them in GetOutput().
%define DECL_PYTHON_MESH_OUTPUTS_CLASS(swig_name)
%extend swig_name {
  %pythoncode %{
    def __internal_call__(self):
        """Update and return the tetrahedra, the surface and the particles."""
        self.UpdateLargestPossibleRegion()
        return self.GetOutput(), self.GetSurface(), self.GetParticles()
  %}
}
%enddef
