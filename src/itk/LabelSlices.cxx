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
#include "itk/LabelSlices.h"

#include "image/SliceInterpolation.h"
#include "itk/FilterMonitor.h"
#include "itk/GridGeometry.h"
#include "itk/LabelDomain.h"
#include "itk/LabelIslands.h"
#include "itk/Labels.h"
#include "itkImageConversion.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mmm
{
namespace
{
/** Slices are divided where they are at least this many times as thick as voxels are wide. Measured:
 * docs/measurements.md. */
constexpr double LeastRatio = 4.0;
/** Then they become about this many times as thick, which is as good as cubes, in fewer voxels. Measured likewise. */
constexpr double WantedRatio = 2.0;
/** More slices would be more of the same. */
constexpr double MostParts = 20.0;

/** Into how many slices each one is to be divided, along each axis. */
std::array<int, 3>
PartsFor(const itk::ImageBase<3> * image)
{
  constexpr double rounding = 1e-3;
  const auto       grid = GridGeometry(image, image->GetLargestPossibleRegion()).GetGrid(); // its smallest spacing is 1
  std::array<int, 3> parts;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double ratio = grid.spacing[axis] + rounding;
    parts[axis] =
      ratio < LeastRatio ? 1 : static_cast<int>(std::min(MostParts, std::ceil(ratio / WantedRatio - rounding)));
  }
  return parts;
}

/** Throws if the stages take more memory than that for sure, in GB, or number voxels by more bits than they have. */
void
VerifySize(const itk::ImageBase<3> * image, const std::array<int, 3> & parts, double limit)
{
  constexpr double mostVoxels = 4e9;
  double           voxels = 1.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    voxels *= static_cast<double>(image->GetLargestPossibleRegion().GetSize(axis)) * parts[axis];
  }
  const double gigabytes = LeastMemory(voxels);
  if (gigabytes > limit || voxels > mostVoxels)
  {
    itkGenericExceptionMacro("With its slices divided, the image has "
                             << voxels << " voxels and takes at least " << gigabytes
                             << " GB, which is too much. KeepSlices (--keep-slices) leaves them as they are.");
  }
}

/** An image without pixels, where each voxel of another one is divided. */
itk::ImageBase<3>::Pointer
DividedGeometry(const itk::ImageBase<3> * image, const std::array<int, 3> & parts)
{
  const auto                      fine = itk::ImageBase<3>::New();
  auto                            region = image->GetLargestPossibleRegion();
  auto                            spacing = image->GetSpacing();
  itk::ContinuousIndex<double, 3> first;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, region.GetIndex(axis) * parts[axis]);
    region.SetSize(axis, region.GetSize(axis) * static_cast<itk::SizeValueType>(parts[axis]));
    spacing[axis] /= parts[axis];
    first[axis] = 0.5 / parts[axis] - 0.5;
  }
  itk::ImageBase<3>::PointType origin;
  image->TransformContinuousIndexToPhysicalPoint(first, origin);
  fine->SetRegions(region);
  fine->SetOrigin(origin);
  fine->SetSpacing(spacing);
  fine->SetDirection(image->GetDirection());
  return fine;
}

template <typename TImage>
typename TImage::Pointer
AllocateLike(const itk::ImageBase<3> * geometry)
{
  const auto image = TImage::New();
  image->CopyInformation(geometry);
  image->SetRegions(geometry->GetLargestPossibleRegion());
  image->Allocate();
  return image;
}

/** The values of an image in all parts of its voxels. */
template <typename TImage>
typename TImage::ConstPointer
Divide(const TImage * image, const itk::ImageBase<3> * geometry, const std::array<int, 3> & parts)
{
  const auto fine = AllocateLike<TImage>(geometry);
  const auto first = image->GetLargestPossibleRegion().GetIndex();
  const auto fineFirst = geometry->GetLargestPossibleRegion().GetIndex();
  for (itk::ImageRegionIteratorWithIndex<TImage> it(fine, fine->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    auto at = it.GetIndex();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      at[axis] = first[axis] + (at[axis] - fineFirst[axis]) / parts[axis];
    }
    it.Set(image->GetPixel(at));
  }
  return fine.GetPointer();
}

LabelImage::ConstPointer
Interpolate(const LabelImage * image, const itk::ImageBase<3> * geometry, const std::array<int, 3> & parts)
{
  const auto    labels = LabelsOf(image);
  MaterialImage materials = MakeMaterialImage(image, labels);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (parts[axis] > 1)
    {
      materials = InterpolateSlices(materials, axis, parts[axis]);
    }
  }
  const auto fine = AllocateLike<LabelImage>(geometry);
  std::transform(materials.materials.begin(), materials.materials.end(), fine->GetBufferPointer(), [&](Material m) {
    return labels[m];
  });
  return fine.GetPointer();
}

/** Whether there is something to mesh: if not, that is said later. */
bool
IsMeshable(const LabelMeshingInputs & inputs)
{
  const auto counts = CountLabels(inputs.labels);
  const bool isAnyMeshed = std::any_of(counts.begin(), counts.end(), [&](const auto & entry) {
    return !Contains(inputs.options.exteriorLabels, entry.first);
  });
  return counts.size() > 1 && isAnyMeshed &&
         (inputs.acceptIntensities || DescribeIntensities(inputs.labels, counts).empty());
}
} // namespace

LabelSlices::LabelSlices(LabelMeshingInputs & inputs, FilterMonitor & monitor)
  : m_HasElectrodes(!inputs.electrodes.list.empty())
  , m_Spacing(inputs.labels->GetSpacing())
{
  if (inputs.options.keepSlices || !inputs.functions.images.empty() || !inputs.surfaces.labels.empty() ||
      !IsMeshable(inputs))
  {
    return;
  }
  m_Parts = PartsFor(inputs.labels);
  if (!this->AreDivided())
  {
    return;
  }
  VerifySize(inputs.labels, m_Parts, inputs.meshing.maximumMemory);
  const auto labels = itk::CopyToIntegers(inputs.labels.GetPointer());
  MergeLabelIslands(inputs.options.exteriorLabels,
                    inputs.options.minimumIslandSize,
                    labels,
                    m_Records,
                    m_AbsentExteriorLabels,
                    monitor);
  const auto geometry = DividedGeometry(inputs.labels, m_Parts);
  inputs.labels = Interpolate(labels, geometry, m_Parts);
  SizingInputs & sizing = inputs.sizing;
  if (sizing.image)
  {
    sizing.image = Divide(sizing.image.GetPointer(), geometry, m_Parts);
  }
  if (sizing.region)
  {
    sizing.region = Divide(sizing.region.GetPointer(), geometry, m_Parts);
  }
}

bool
LabelSlices::AreDivided() const
{
  return std::any_of(m_Parts.begin(), m_Parts.end(), [](int parts) { return parts > 1; });
}

std::string
LabelSlices::Describe() const
{
  if (!this->AreDivided())
  {
    return {};
  }
  std::ostringstream text;
  text << "Voxels of " << m_Spacing[0] << " x " << m_Spacing[1] << " x " << m_Spacing[2] << " mm are divided into "
       << m_Parts[0] << " x " << m_Parts[1] << " x " << m_Parts[2]
       << ", with shapes that change evenly from slice to slice; KeepSlices (--keep-slices) leaves them as they are.";
  return text.str();
}

std::size_t
LabelSlices::ToImage(std::size_t voxels) const
{
  const auto parts = static_cast<std::size_t>(m_Parts[0]) * m_Parts[1] * m_Parts[2];
  return std::max<std::size_t>(1, (voxels + parts / 2) / parts);
}

itk::ImageRegion<3>
LabelSlices::ToImage(const itk::ImageRegion<3> & region) const
{
  const auto down = [](itk::IndexValueType index, int parts) {
    return static_cast<itk::IndexValueType>(std::floor(static_cast<double>(index) / parts));
  };
  auto first = region.GetIndex();
  auto last = region.GetUpperIndex();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    first[axis] = down(first[axis], m_Parts[axis]);
    last[axis] = down(last[axis], m_Parts[axis]);
  }
  itk::ImageRegion<3> least;
  least.SetIndex(first);
  least.SetUpperIndex(last);
  return least;
}

void
LabelSlices::Restore(std::map<int, IslandRecord> & records, std::vector<int> & absentExteriorLabels) const
{
  if (!this->AreDivided())
  {
    return;
  }
  std::map<int, IslandRecord> restored = m_Records;
  for (const auto & [label, record] : records)
  {
    const bool isNew = restored.count(label) == 0;
    if (isNew || m_HasElectrodes) // these took voxels of others
    {
      restored[label].voxelsAfter = record.voxelsAfter == 0 ? 0 : this->ToImage(record.voxelsAfter);
    }
    if (isNew)
    {
      restored[label].voxelsBefore = this->ToImage(record.voxelsBefore);
    }
  }
  records = restored;
  absentExteriorLabels = m_AbsentExteriorLabels;
}
} // namespace mmm
