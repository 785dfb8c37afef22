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

#include "itk/MeshConversion.h"
#include "base/OutOfMemory.h"
#include "itk/TetrahedraOfMesh.h"

#include "itkTetrahedronCell.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

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
try
{
  mmm::FilterMonitor monitor(
    this, m_StageLog, { { "reading", 0.02 }, { "interfaces", 0.05 }, { "optimization", 0.91 }, { "output", 0.02 } });
  monitor.BeginStage("reading");
  using Tetrahedra = mmm::TetrahedraOfMesh<MeshType>;
  Tetrahedra input(this->GetInput(), Tetrahedra::OtherCells::LeaveOut);
  m_NumberOfCellsLeftOut = input.leftOut;
  if (input.tetrahedra.empty())
  {
    itkExceptionMacro("The mesh has no tetrahedra.");
  }
  std::vector<int> labels = input.labels;
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  if (labels.size() > mmm::MostMaterialsToImprove)
  {
    itkExceptionMacro("The mesh has " << labels.size() << " labels; there can be " << mmm::MostMaterialsToImprove
                                      << " at most.");
  }

  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra.swap(input.tetrahedra);
  mesh.materials.reserve(input.labels.size());
  for (const int label : input.labels)
  {
    mesh.materials.push_back(
      static_cast<mmm::Material>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin()));
  }
  mmm::ImprovementParameters parameters;
  parameters.tolerance = m_Tolerance;
  parameters.featureAngle = m_FeatureAngle;
  parameters.rounds = m_MaximumNumberOfRounds;
  m_Report = mmm::ImproveMesh(static_cast<mmm::Material>(labels.size()), parameters, input.points, mesh, monitor);
  m_LargestTolerance = parameters.tolerance;

  monitor.BeginStage("output");
  TMesh *                                    output = this->GetOutput();
  std::vector<typename TMesh::CellPixelType> outputLabels;
  outputLabels.reserve(mesh.materials.size());
  for (const auto material : mesh.materials)
  {
    outputLabels.push_back(static_cast<typename TMesh::CellPixelType>(labels[material]));
  }
  mmm::SetMeshPoints(output, input.points);
  mmm::SetMeshCells<TetrahedronCell<typename TMesh::CellType>>(
    output, mesh.tetrahedra, [](std::size_t) { return false; });
  mmm::SetMeshCellData(output, std::move(outputLabels));
  output->SetBufferedRegion(output->GetRequestedRegion());
  monitor.Report(1.0);
}
catch (const std::bad_alloc &)
{
  mmm::ThrowOutOfMemory(std::string(this->GetNameOfClass()) + ", in stage \"" + m_StageLog.current + "\",");
}

template <typename TMesh>
void
OptimizeTetrahedralMeshFilter<TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << m_Tolerance << std::endl;
  os << indent << "FeatureAngle: " << m_FeatureAngle << std::endl;
  os << indent << "MaximumNumberOfRounds: " << m_MaximumNumberOfRounds << std::endl;
  os << indent << "LargestTolerance: " << m_LargestTolerance << std::endl;
  os << indent << "NumberOfCellsLeftOut: " << m_NumberOfCellsLeftOut << std::endl;
}
} // namespace itk

#endif
