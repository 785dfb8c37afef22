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

#include "itkCommonEnums.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
template <typename TMesh>
void
TetrahedralMeshQualityCalculator<TMesh>::ReadPoints(std::vector<mmm::Vector> &     points,
                                                    std::vector<PointIdentifier> & identifiers) const
{
  const auto * container = m_Mesh->GetPoints();
  if (container == nullptr)
  {
    return;
  }
  points.reserve(container->Size());
  bool isContiguous = true;
  for (auto point = container->Begin(); point != container->End(); ++point)
  {
    isContiguous = isContiguous && point.Index() == points.size();
    identifiers.push_back(point.Index());
    points.emplace_back(point.Value()[0], point.Value()[1], point.Value()[2]);
  }
  if (isContiguous)
  {
    identifiers.clear();
  }
}

template <typename TMesh>
int
TetrahedralMeshQualityCalculator<TMesh>::ReadLabel(CellIdentifier cell) const
{
  const auto * data = m_Mesh->GetCellData();
  if (data == nullptr || data->Size() == 0)
  {
    return 0;
  }
  typename MeshType::CellPixelType pixel{};
  if (!data->GetElementIfIndexExists(cell, &pixel))
  {
    itkExceptionMacro(<< "Cell " << cell << " has no label.");
  }
  const auto label = static_cast<double>(pixel);
  if (!(label >= NumericTraits<int>::NonpositiveMin() && label <= NumericTraits<int>::max()) ||
      label != std::floor(label))
  {
    itkExceptionMacro(<< "Cell " << cell << " has the label " << label << ", which is not a whole number of type int.");
  }
  return static_cast<int>(label);
}

template <typename TMesh>
void
TetrahedralMeshQualityCalculator<TMesh>::Compute()
{
  m_Computed = false;
  if (m_Mesh.IsNull())
  {
    itkExceptionMacro(<< "There is no mesh to measure.");
  }
  std::vector<mmm::Vector>     points;
  std::vector<PointIdentifier> pointIdentifiers;
  this->ReadPoints(points, pointIdentifiers);

  std::vector<CellIdentifier>   cellIdentifiers;
  std::vector<mmm::Tetrahedron> tetrahedra;
  std::vector<int>              labels;
  if (const auto * cells = m_Mesh->GetCells())
  {
    cellIdentifiers.reserve(cells->Size());
    tetrahedra.reserve(cells->Size());
    labels.reserve(cells->Size());
    for (auto cell = cells->Begin(); cell != cells->End(); ++cell)
    {
      const auto identifier = cell.Index();
      // a vector of cells may have gaps
      if (cell.Value() == nullptr)
      {
        continue;
      }
      if (cell.Value()->GetType() != CommonEnums::CellGeometry::TETRAHEDRON_CELL)
      {
        itkExceptionMacro(<< "Cell " << identifier << " is no tetrahedron: it is a " << cell.Value()->GetType() << ".");
      }
      const CellType & constCell = *cell.Value();
      auto             pointOfCell = constCell.PointIdsBegin();
      mmm::Tetrahedron tetrahedron{ {} };
      for (auto & index : tetrahedron)
      {
        const PointIdentifier point = *pointOfCell++;
        std::size_t           position = point;
        if (!pointIdentifiers.empty())
        {
          const auto found = std::lower_bound(pointIdentifiers.begin(), pointIdentifiers.end(), point);
          position = found != pointIdentifiers.end() && *found == point
                       ? static_cast<std::size_t>(found - pointIdentifiers.begin())
                       : points.size();
        }
        if (position >= points.size())
        {
          itkExceptionMacro(<< "Cell " << identifier << " has the point " << point << ", which the mesh lacks.");
        }
        index = static_cast<std::uint32_t>(position);
      }
      cellIdentifiers.push_back(identifier);
      tetrahedra.push_back(tetrahedron);
      labels.push_back(this->ReadLabel(identifier));
    }
  }

  mmm::MeshQualityOptions options;
  options.smallestAngle = m_SmallestAngle;
  options.largestAngle = m_LargestAngle;
  options.maximumListed = m_MaximumListed;
  options.duplicateTolerance = m_DuplicateTolerance;
  options.computeBettiNumbers = m_ComputeBettiNumbers;
  try
  {
    m_Report = mmm::ComputeMeshQuality(points, tetrahedra, labels, options);
  }
  catch (const std::logic_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
  for (auto & tetrahedron : m_Report.poorest)
  {
    tetrahedron.index = cellIdentifiers[tetrahedron.index];
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
