// Reports reach Python as plain objects, see mmmPythonReports.h.
%{
#include "mmmPythonReports.h"
%}

%typemap(out) mmm::MeshingReport const &, mmm::MeshQualityReport const &, std::vector< mmm::StageRecord > const &,
              std::vector< mmm::ElectrodeReport > const &, std::map< int, mmm::SizeRule > const &, std::map< int, mmm::LabelEntry > const &, std::map< int, mmm::IslandRecord > const &, std::map< int, unsigned long > const &,
              std::map< int, unsigned long long > const &
{
  $result = mmm::ToPython(*$1);
  if (!$result)
  {
    SWIG_fail;
  }
}
