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
#ifndef itkIndicatorImagesToTetrahedralMeshFilter_hxx
#define itkIndicatorImagesToTetrahedralMeshFilter_hxx

#include "indicators/FunctionIndicators.h"

#include <algorithm>
#include <cmath>

namespace itk
{
template <typename TIndicatorImage, typename TOutputMesh>
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::IndicatorImagesToTetrahedralMeshFilter()
  : m_LabelFilter(LabelFilterType::New())
{
  Superclass::SetInput(m_LabelFilter->GetOutput());
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::SetInput(unsigned int            number,
                                                                               const TIndicatorImage * image)
{
  m_LabelFilter->SetInput(number, image);
  // input 0 is the label image
  this->ProcessObject::SetNthInput(number + 1, const_cast<TIndicatorImage *>(image));
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::SetIndicatorLabels(const LabelsType & labels)
{
  m_LabelFilter->SetIndicatorLabels(labels);
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::SetExteriorLabels(const LabelsType & labels)
{
  Superclass::SetExteriorLabels(labels);
  m_LabelFilter->SetExteriorLabels(labels);
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (!std::isnan(this->GetAirMargin()))
  {
    itkExceptionMacro("An air margin of " << this->GetAirMargin()
                                          << " mm would need the indicators beyond their images. FillExterior meshes "
                                             "the exterior up to the faces of the images' box.");
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
auto
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::ComputeIndicators(const LabelImageType * labels,
                                                                                        const mmm::GridGeometry &,
                                                                                        mmm::FilterMonitor & monitor) ->
  typename Superclass::IndicatorImagesType
{
  const auto &                            present = this->GetLabels();
  const auto &                            exterior = this->GetExteriorLabels();
  std::vector<std::vector<const float *>> functions(present.size());
  const auto                              functionsOf = [&](LabelType label) -> std::vector<const float *> * {
    // all exterior labels have become the one that is present
    const bool isExterior = std::find(exterior.begin(), exterior.end(), label) != exterior.end();
    const auto place = std::find_if(present.begin(), present.end(), [&](LabelType other) {
      return other == label || (isExterior && std::find(exterior.begin(), exterior.end(), other) != exterior.end());
    });
    return place == present.end() ? nullptr : &functions[place - present.begin()];
  };

  const auto                 mapLabels = m_LabelFilter->GetUsedLabels();
  std::vector<const float *> maps;
  for (std::size_t n = 0; n < mapLabels.size(); ++n)
  {
    const TIndicatorImage * map = m_LabelFilter->GetInput(static_cast<unsigned int>(n));
    maps.push_back(map->GetBufferPointer());
    if (auto * const list = functionsOf(mapLabels[n]))
    {
      list->push_back(maps.back());
    }
  }
  std::vector<float> remainder;
  if (m_LabelFilter->IsExteriorImplicit())
  {
    remainder = mmm::ComputeRemainder(maps, labels->GetBufferedRegion().GetNumberOfPixels());
    if (auto * const list = functionsOf(exterior.front()))
    {
      list->push_back(remainder.data());
    }
  }

  const auto                    materials = mmm::MakeMaterialImage(labels, present);
  const auto                    boxes = mmm::ComputeMaterialBoxes(materials);
  const mmm::FunctionIndicators indicators(materials, std::move(functions));
  using ImageType = typename Superclass::IndicatorImageType;
  typename Superclass::IndicatorImagesType images;
  for (std::size_t m = 0; m < present.size(); ++m)
  {
    const auto                     block = indicators.Compute(static_cast<mmm::Material>(m), boxes[m]);
    const auto                     image = ImageType::New();
    typename ImageType::RegionType region;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      region.SetIndex(axis, block.lower[axis]);
      region.SetSize(axis, static_cast<SizeValueType>(block.size[axis]));
    }
    image->CopyInformation(labels);
    image->SetRegions(region);
    image->Allocate();
    std::copy(block.values.begin(), block.values.end(), image->GetBufferPointer());
    images.push_back(image);
    monitor.Report(static_cast<double>(m + 1) / present.size());
  }
  return images;
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToTetrahedralMeshFilter<TIndicatorImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(LabelFilter);
}
} // namespace itk

#endif
