// For classes of filters that Ctrl-C is to end, see RunInterruptibly.i.
%define DECL_PYTHON_INTERRUPTIBLE_CLASS(swig_name)
%extend swig_name {
  %pythoncode %{
    def Update(self):
        from itk.itkMultiMaterialMeshTypesPython import _run_interruptibly
        _run_interruptibly(self, super().Update)

    def UpdateLargestPossibleRegion(self):
        from itk.itkMultiMaterialMeshTypesPython import _run_interruptibly
        _run_interruptibly(self, super().UpdateLargestPossibleRegion)
  %}
}
%enddef
