/*=========================================================================
 *
 *  Copyright NumFOCUS
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkOptimizeTetrahedralMeshFilter_hxx
#define itkOptimizeTetrahedralMeshFilter_hxx

#include <cmath>

namespace itk
{
template <typename TMesh>
void
OptimizeTetrahedralMeshFilter<TMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (!std::isnan(m_Tolerance) && !(m_Tolerance > 0.0 && std::isfinite(m_Tolerance)))
  {
    itkExceptionMacro("Tolerance is " << m_Tolerance << "; it has to be positive, or Automatic.");
  }
}

template <typename TMesh>
void
OptimizeTetrahedralMeshFilter<TMesh>::GenerateData()
{
  const auto read = [this] {
    using Reader = TetrahedronReader<TMesh>;
    Reader reader(this->GetInput(), Reader::OtherCells::LeaveOut);
    m_NumberOfCellsLeftOut = reader.leftOut;
    return std::move(reader.arrays);
  };
  const auto write = [this](const TetrahedronArrays & arrays) {
    TMesh * output = this->GetOutput();
    FillMesh(arrays, output);
    output->SetBufferedRegion(output->GetRequestedRegion());
  };
  mmm::ImproveTetrahedra(this, { m_Tolerance, m_FeatureAngle, m_MaximumNumberOfRounds }, read, write, m_Results);
}

template <typename TMesh>
void
OptimizeTetrahedralMeshFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << m_Tolerance << std::endl;
  os << indent << "FeatureAngle: " << m_FeatureAngle << std::endl;
  os << indent << "MaximumNumberOfRounds: " << m_MaximumNumberOfRounds << std::endl;
  os << indent << "LargestTolerance: " << m_Results.largestTolerance << std::endl;
  os << indent << "NumberOfCellsLeftOut: " << m_NumberOfCellsLeftOut << std::endl;
}
} // namespace itk

#endif
