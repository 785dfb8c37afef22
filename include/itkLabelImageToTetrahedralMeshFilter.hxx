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
#ifndef itkLabelImageToTetrahedralMeshFilter_hxx
#define itkLabelImageToTetrahedralMeshFilter_hxx

#include "itkFilterReport.h"
#include "itkImageConversion.h"
#include "itkPrintHelper.h"

#include <algorithm>
#include <string>

namespace itk
{
template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetExteriorLabels(const LabelsType & labels)
{
  if (m_ExteriorLabels != labels)
  {
    m_ExteriorLabels = labels;
    this->Modified();
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetSurfaceLabels(const LabelsType & labels)
{
  if (m_SurfaceLabels != labels)
  {
    m_SurfaceLabels = labels;
    this->Modified();
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetSurfaceDistanceImage(
  unsigned int                     number,
  const SurfaceDistanceImageType * image)
{
  this->ProcessObject::SetInput("SurfaceDistanceImage" + std::to_string(number),
                                const_cast<SurfaceDistanceImageType *>(image));
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetSurfaceDistanceImage(unsigned int number) const
  -> const SurfaceDistanceImageType *
{
  return dynamic_cast<const SurfaceDistanceImageType *>(
    this->ProcessObject::GetInput("SurfaceDistanceImage" + std::to_string(number)));
}

template <typename TLabelImage, typename TOutputMesh>
mmm::SurfaceInputs
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetSurfaces() const
{
  mmm::SurfaceInputs surfaces;
  surfaces.labels = m_SurfaceLabels;
  // images without labels are not passed over
  for (unsigned int n = 0; n < m_SurfaceLabels.size() || this->GetSurfaceDistanceImage(n) != nullptr; ++n)
  {
    surfaces.distances.push_back(this->GetSurfaceDistanceImage(n));
  }
  return surfaces;
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetIndicatorImage(LabelType label) const
  -> const IndicatorImageType *
{
  const LabelsType & labels = m_Results.labels;
  const auto         place = std::lower_bound(labels.begin(), labels.end(), label);
  if (m_Results.indicatorImages.empty() || place == labels.end() || *place != label)
  {
    itkExceptionMacro("There is no indicator image for label "
                      << label << '.' << (m_KeepIntermediates ? "" : " KeepIntermediates is off."));
  }
  return m_Results.indicatorImages[place - labels.begin()];
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::WriteReport(const std::string & fileName)
{
  if (this->GetSurface()->GetNumberOfCells() == 0)
  {
    itkExceptionMacro("There is no mesh to report on. Call Update() first, and write reports before the outputs are "
                      "taken away.");
  }
  const FilterReport<Self> report(*this);
  WriteMeshReport(fileName, report.GetFacts(), report.GetDetails());
}

template <typename TLabelImage, typename TOutputMesh>
mmm::LabelMeshingInputs
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetInputs() const
{
  mmm::LabelMeshingInputs inputs;
  inputs.options.exteriorLabels = m_ExteriorLabels;
  inputs.options.fillExterior = m_FillExterior;
  inputs.options.airMargin = m_AirMargin;
  inputs.acceptIntensities = m_AcceptIntensities;
  inputs.options.minimumIslandSize = m_MinimumIslandSize;
  inputs.options.keepSlices = m_KeepSlices;
  inputs.options.radius = m_Radius;
  inputs.options.topologyMode = m_TopologyMode;
  inputs.options.allowVanishedLabels = m_AllowVanishedLabels;
  inputs.options.keepIntermediates = m_KeepIntermediates;
  inputs.surfaces = this->GetSurfaces();
  inputs.electrodes = m_Electrodes;
  inputs.sizing = this->GetSizingInputs();
  inputs.meshing = this->GetMeshingOptions();
  return inputs;
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const std::string error = mmm::DescribeError(this->GetInputs());
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyInputInformation() const
{
  const auto * labels = dynamic_cast<const TLabelImage *>(this->GetPrimaryInput());
  std::string  error = mmm::DescribeGeometryError(labels, this->GetSizingInputs());
  error = error.empty() ? mmm::DescribeGeometryError(labels, this->GetSurfaces()) : error;
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GenerateData()
{
  auto inputs = this->GetInputs();
  inputs.labels = ToIntegers(this->GetInput());
  inputs.functions = this->GetFunctions();
  mmm::MeshLabels(this, std::move(inputs), this->GetMeshingOutputs(), this->m_State, m_Results);
  this->Warn();
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabels: " << m_ExteriorLabels << std::endl;
  os << indent << "SurfaceLabels: " << m_SurfaceLabels << std::endl;
  os << indent << "Electrodes: " << m_Electrodes.list.size() << std::endl;
  os << indent << "FillExterior: " << (m_FillExterior ? "On" : "Off") << std::endl;
  os << indent << "AirMargin: " << m_AirMargin << std::endl;
  os << indent << "AcceptIntensities: " << (m_AcceptIntensities ? "On" : "Off") << std::endl;
  os << indent << "MinimumIslandSize: " << m_MinimumIslandSize << std::endl;
  os << indent << "KeepSlices: " << (m_KeepSlices ? "On" : "Off") << std::endl;
  os << indent << "Radius: " << m_Radius << std::endl;
  os << indent << "TopologyMode: " << mmm::ToText(m_TopologyMode) << std::endl;
  os << indent << "AllowVanishedLabels: " << (m_AllowVanishedLabels ? "On" : "Off") << std::endl;
  os << indent << "KeepIntermediates: " << (m_KeepIntermediates ? "On" : "Off") << std::endl;
  os << indent << "Labels: " << m_Results.labels << std::endl;
  os << indent << "MeshedRegion: " << m_Results.meshedRegion << std::endl;
  os << indent << "OutsideLabel: " << this->GetOutsideLabel() << std::endl;
  os << indent << "AbsentExteriorLabels: " << m_Results.absentExteriorLabels << std::endl;
  os << indent << "VanishedLabels:";
  for (const auto & entry : m_Results.vanishedLabels)
  {
    os << ' ' << entry.first << " (" << entry.second << " voxels)";
  }
  os << std::endl;
}
} // namespace itk

#endif
