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
#ifndef itkFilterReport_h
#define itkFilterReport_h

#include "itkMeshPage.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "itkTetrahedronArrays.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace itk
{
/** \brief The facts that a LabelImageToTetrahedralMeshFilter knows after Update(), and what it was told, for a report.
 *
 * It keeps what the facts point to, but for what is the filter's own: it must not outlive the filter.
 *
 * \tparam TFilter LabelImageToTetrahedralMeshFilter
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TFilter>
class FilterReport
{
public:
  explicit FilterReport(TFilter & filter)
    : m_Filter(filter)
    , m_Tetrahedra(ToLabelMesh(filter.GetOutput()))
  {
    m_Facts.meshing = &filter.GetReport();
    m_Facts.islands = &filter.GetIslandRecords();
    m_Facts.vanishedLabels = &filter.GetVanishedLabels();
    m_Facts.stages = &filter.GetStageRecords();
    m_Facts.electrodes = &filter.GetElectrodeReports();
    m_Facts.absentExteriorLabels = filter.GetAbsentExteriorLabels();
    m_Facts.outsideLabel = filter.GetOutsideLabel();
    m_Facts.tetrahedra = m_Tetrahedra;
    m_Facts.surface = filter.GetSurface();
    m_Facts.surfaceQuality = ComputeSurfaceQuality(*filter.GetSurface());
    m_Facts.image = filter.GetInput();
    m_Facts.meshedRegion = filter.GetMeshedRegion();
    if (!filter.GetSurfaceOnly())
    {
      const auto calculator = TetrahedralMeshQualityCalculator<LabelTetrahedralMesh>::New();
      calculator->SetMesh(m_Tetrahedra);
      calculator->Compute();
      m_Quality = calculator->GetReport();
      m_Facts.quality = &m_Quality;
    }
    this->CountVoxels();
    this->ListSettings();
    this->UseVoxels();
  }
  FilterReport(const FilterReport &) = delete;
  FilterReport &
  operator=(const FilterReport &) = delete;

  const MeshFacts &
  GetFacts() const
  {
    return m_Facts;
  }

  const MeshPageDetails &
  GetDetails() const
  {
    return m_Details;
  }

private:
  using OutputMeshType = typename TFilter::OutputMeshType;

  static LabelTetrahedralMesh::ConstPointer
  ToLabelMesh(const OutputMeshType * mesh)
  {
    if constexpr (std::is_same_v<OutputMeshType, LabelTetrahedralMesh>)
    {
      return mesh;
    }
    else
    {
      using Reader = TetrahedronReader<OutputMeshType>;
      const auto copy = LabelTetrahedralMesh::New();
      FillMesh(Reader(mesh, Reader::OtherCells::Throw).arrays, copy.GetPointer());
      return copy.GetPointer();
    }
  }

  /** Of what is no exterior: its volume is that of a box. */
  void
  CountVoxels()
  {
    const auto & exterior = m_Filter.GetExteriorLabels();
    for (const auto & [label, record] : m_Filter.GetIslandRecords())
    {
      if (std::find(exterior.begin(), exterior.end(), label) == exterior.end())
      {
        m_Details.voxels[label] = record.voxelsAfter;
      }
    }
  }

  /** The pipeline may have released them. */
  void
  UseVoxels()
  {
    const auto * const image = m_Filter.GetInput();
    if (image->GetBufferedRegion() == image->GetLargestPossibleRegion())
    {
      m_Details.labelAt = [image](const Index<3> & index) { return static_cast<int>(image->GetPixel(index)); };
    }
  }

  template <typename TValue>
  void
  Add(const std::string & name, const TValue & value)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    if constexpr (std::is_same_v<TValue, bool>)
    {
      text << (value ? "on" : "off");
    }
    else if constexpr (std::is_floating_point_v<TValue>)
    {
      text << (std::isnan(value) ? "automatic" : std::isinf(value) ? "no limit" : "");
      if (std::isfinite(value))
      {
        text << value;
      }
    }
    else
    {
      text << value;
    }
    m_Details.settings.emplace_back(name, text.str());
  }

  void
  ListSettings()
  {
    std::string exterior;
    for (const int label : m_Filter.GetExteriorLabels())
    {
      exterior += (exterior.empty() ? "" : ", ") + std::to_string(label);
    }
    this->Add("ExteriorLabels", exterior);
    this->Add("FillExterior", m_Filter.GetFillExterior());
    this->Add("AirMargin", m_Filter.GetAirMargin());
    this->Add("MinimumIslandSize", m_Filter.GetMinimumIslandSize());
    this->Add("KeepSlices", m_Filter.GetKeepSlices());
    this->Add("Radius", m_Filter.GetRadius());
    this->Add("TopologyMode", mmm::ToText(m_Filter.GetTopologyMode()));
    this->Add("Epsilon", m_Filter.GetEpsilon());
    this->Add("ChordTolerance", m_Filter.GetChordTolerance());
    this->Add("GradientLimit", m_Filter.GetGradientLimit());
    this->Add("MinimumSize", m_Filter.GetMinimumSize());
    this->Add("MaximumSize", m_Filter.GetMaximumSize());
    this->Add("MaximumVolume", m_Filter.GetMaximumVolume());
    this->Add("LabelSizes", mmm::ToText(m_Filter.GetLabelSizes()));
    this->Add("SizingImage", m_Filter.GetSizingImage() != nullptr);
    this->Add("SizingImageReplaces", m_Filter.GetSizingImageReplaces());
    this->Add("RegionOfInterest", m_Filter.GetRegionOfInterest() != nullptr);
    this->Add("RegionMinimumSize", m_Filter.GetRegionMinimumSize());
    this->Add("RegionMaximumSize", m_Filter.GetRegionMaximumSize());
    this->Add("NumberOfTetrahedra", m_Filter.GetNumberOfTetrahedra());
    this->Add("ElementOrder", m_Filter.GetElementOrder());
    this->Add("SurfaceOnly", m_Filter.GetSurfaceOnly());
    this->Add("Seed", m_Filter.GetSeed());
  }

  TFilter &                          m_Filter;
  LabelTetrahedralMesh::ConstPointer m_Tetrahedra;
  mmm::MeshQualityReport             m_Quality;
  MeshFacts                          m_Facts;
  MeshPageDetails                    m_Details;
};
} // end namespace itk

#endif
