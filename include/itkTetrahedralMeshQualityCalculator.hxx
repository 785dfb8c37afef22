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
#ifndef itkTetrahedralMeshQualityCalculator_hxx
#define itkTetrahedralMeshQualityCalculator_hxx

namespace itk
{
template <typename TMesh>
void
TetrahedralMeshQualityCalculator<TMesh>::Compute()
{
  m_Computed = false;
  if (m_Mesh.IsNull())
  {
    itkExceptionMacro(<< "There is no mesh to measure.");
  }
  using Reader = TetrahedronReader<MeshType>;
  const Reader mesh(m_Mesh, Reader::OtherCells::Throw);

  mmm::MeshQualityOptions options;
  options.smallestAngle = m_SmallestAngle;
  options.largestAngle = m_LargestAngle;
  options.maximumListed = m_MaximumListed;
  options.duplicateTolerance = m_DuplicateTolerance;
  options.computeBettiNumbers = m_ComputeBettiNumbers;
  m_Report = mmm::ComputeMeshQuality(mesh.arrays, options);
  for (auto & tetrahedron : m_Report.poorest)
  {
    tetrahedron.index = mesh.cellIdentifiers[tetrahedron.index];
  }
  m_Computed = true;
}

template <typename TMesh>
auto
TetrahedralMeshQualityCalculator<TMesh>::GetReport() const -> const ReportType &
{
  if (!m_Computed)
  {
    itkExceptionMacro(<< "Compute() must be called before its report can be had.");
  }
  return m_Report;
}

template <typename TMesh>
void
TetrahedralMeshQualityCalculator<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);

  itkPrintSelfObjectMacro(Mesh);
  os << indent << "SmallestAngle: " << m_SmallestAngle << std::endl;
  os << indent << "LargestAngle: " << m_LargestAngle << std::endl;
  os << indent << "MaximumListed: " << m_MaximumListed << std::endl;
  os << indent << "DuplicateTolerance: " << m_DuplicateTolerance << std::endl;
  os << indent << "ComputeBettiNumbers: " << (m_ComputeBettiNumbers ? "On" : "Off") << std::endl;
  os << indent << "Report: ";
  if (m_Computed)
  {
    os << std::endl << m_Report;
  }
  else
  {
    os << "(not computed)" << std::endl;
  }
}
} // namespace itk

#endif
