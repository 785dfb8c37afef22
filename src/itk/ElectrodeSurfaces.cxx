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
#include "itk/ElectrodeSurfaces.h"

#include "itk/ElectrodePlacement.h"
#include "itk/ImageRegions.h"
#include "itkImageConversion.h"

#include "itkImageRegionConstIteratorWithIndex.h"

#include <algorithm>

namespace mmm
{
ElectrodeSurfaces::ElectrodeSurfaces(LabelMeshingInputs & inputs, std::vector<ElectrodeReport> & reports)
  : m_First(inputs.surfaces.labels.size())
{
  if (inputs.electrodes.list.empty())
  {
    return;
  }
  SurfaceInputs & surfaces = inputs.surfaces;
  const auto &    exterior = inputs.options.exteriorLabels;
  auto &          sizes = inputs.sizing.options.labelSizes;
  const auto      composed = ComposeLabels(inputs.labels, surfaces);
  auto            placed = PlaceElectrodes(inputs.electrodes, composed, exterior, sizes);
  sizes.insert(placed.sizes.begin(), placed.sizes.end());
  // without exterior there are implants only, which do not go beyond the image
  inputs.labels = CopyRegion(inputs.labels.GetPointer(), placed.region, exterior.empty() ? 0 : exterior.front());
  reports = std::move(placed.reports);

  const auto append = [](const auto & from, auto & to) { to.insert(to.end(), from.begin(), from.end()); };
  surfaces.replaced.resize(m_First);
  append(placed.surfaces.distances, surfaces.distances);
  append(placed.surfaces.labels, surfaces.labels);
  append(placed.surfaces.replaced, surfaces.replaced);
}

void
ElectrodeSurfaces::Restore(const SurfaceInputs &         surfaces,
                           const LabelDomain &           domain,
                           LabelImage *                  labels,
                           std::map<int, IslandRecord> & records) const
{
  const LabelImage * const composed = domain.GetImage();
  const auto &             whole = composed->GetLargestPossibleRegion();
  const auto               shift = labels->GetLargestPossibleRegion().GetIndex() - whole.GetIndex();
  for (std::size_t k = m_First; k < surfaces.labels.size(); ++k)
  {
    const int label = surfaces.labels[k];
    auto      region = surfaces.distances[k]->GetBufferedRegion();
    if (!region.Crop(whole))
    {
      continue;
    }
    for (itk::ImageRegionConstIteratorWithIndex<LabelImage> it(composed, region); !it.IsAtEnd(); ++it)
    {
      if (it.Get() == label)
      {
        labels->SetPixel(it.GetIndex() + shift, label);
      }
    }
    const auto     count = domain.GetCounts().find(label);
    IslandRecord & record = records[label];
    record = IslandRecord();
    record.voxelsBefore = count == domain.GetCounts().end() ? 0 : count->second;
    record.voxelsAfter = record.voxelsBefore;
  }
}

LabelImage::ConstPointer
UniteExterior(const LabelMeshingInputs & inputs)
{
  const auto & exterior = inputs.options.exteriorLabels;
  const auto   counts = CountLabels(inputs.labels);
  const auto   isThere = [&](int label) { return counts.count(label) != 0; };
  const auto   first = std::find_if(exterior.begin(), exterior.end(), isThere);
  if (std::count_if(exterior.begin(), exterior.end(), isThere) < 2)
  {
    return inputs.labels;
  }
  const auto united = itk::CopyToIntegers(inputs.labels.GetPointer());
  const auto size = united->GetLargestPossibleRegion().GetNumberOfPixels();
  std::for_each(united->GetBufferPointer(), united->GetBufferPointer() + size, [&](int & label) {
    label = Contains(exterior, label) ? *first : label;
  });
  return united.GetPointer();
}
} // namespace mmm
