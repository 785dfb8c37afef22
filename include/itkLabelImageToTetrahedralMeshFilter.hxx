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

#include "itkIndicatorImagesToSizingImageFilter.h"
#include "itkLabelImageToIndicatorImagesFilter.h"
#include "itkMergeLabelIslandsImageFilter.h"
#include "itk/ImageRegions.h"
#include "itk/IntensityCheck.h"
#include "sizing/MeshEstimate.h"
#include "base/OutOfMemory.h"
#include "itk/SizingImage.h"

#include "itkImageRegionConstIterator.h"
#include "itkPrintHelper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <set>
#include <string>

namespace itk
{
template <typename TLabelImage, typename TOutputMesh>
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::LabelImageToTetrahedralMeshFilter()
{
  this->AddOptionalInputName("SizingImage");
  this->AddOptionalInputName("RegionOfInterest");
  this->SetNumberOfRequiredOutputs(4);
  for (DataObjectPointerArraySizeType n = 0; n < 4; ++n)
  {
    this->SetNthOutput(n, Self::MakeOutput(n));
  }
}

template <typename TLabelImage, typename TOutputMesh>
DataObject::Pointer
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MakeOutput(DataObjectPointerArraySizeType index)
{
  switch (index)
  {
    case 1:
      return SurfaceMeshType::New().GetPointer();
    case 2:
      return ParticleMeshType::New().GetPointer();
    case 3:
      return JunctionMeshType::New().GetPointer();
    default:
      return Superclass::MakeOutput(index);
  }
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetSurface() -> SurfaceMeshType *
{
  return dynamic_cast<SurfaceMeshType *>(this->ProcessObject::GetOutput(1));
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetParticles() -> ParticleMeshType *
{
  return dynamic_cast<ParticleMeshType *>(this->ProcessObject::GetOutput(2));
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetJunctions() -> JunctionMeshType *
{
  return dynamic_cast<JunctionMeshType *>(this->ProcessObject::GetOutput(3));
}

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
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetSizingImage(const SizingImageType * image)
{
  this->ProcessObject::SetInput("SizingImage", const_cast<SizingImageType *>(image));
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetSizingImage() const -> const SizingImageType *
{
  return dynamic_cast<const SizingImageType *>(this->ProcessObject::GetInput("SizingImage"));
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetIndicatorImage(LabelType label) const
  -> const IndicatorImageType *
{
  const auto place = std::lower_bound(m_Labels.begin(), m_Labels.end(), label);
  if (m_IndicatorImages.empty() || place == m_Labels.end() || *place != label)
  {
    itkExceptionMacro("There is no indicator image for label "
                      << label << '.' << (m_KeepIntermediates ? "" : " KeepIntermediates is off."));
  }
  return m_IndicatorImages[place - m_Labels.begin()];
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetComputedSizingImage() const -> const SizingImageType *
{
  return m_ComputedSizingImage;
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetRegionOfInterest(const MaskImageType * mask)
{
  this->ProcessObject::SetInput("RegionOfInterest", const_cast<MaskImageType *>(mask));
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetRegionOfInterest() const -> const MaskImageType *
{
  return dynamic_cast<const MaskImageType *>(this->ProcessObject::GetInput("RegionOfInterest"));
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetLabelSizes(const LabelSizesType & sizes)
{
  m_LabelSizes = sizes;
  this->Modified();
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::SetLabelSizes(const std::string & text)
{
  this->SetLabelSizes(mmm::ParseLabelSizeRules(text));
}

template <typename TLabelImage, typename TOutputMesh>
mmm::SizingOptions
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetSizingOptions() const
{
  mmm::SizingOptions options;
  options.epsilon = m_Epsilon;
  options.chordTolerance = m_ChordTolerance;
  options.gradientLimit = m_GradientLimit;
  options.minimumSize = m_MinimumSize;
  options.maximumSize = m_MaximumSize;
  options.maximumVolume = m_MaximumVolume;
  options.labelSizes = m_LabelSizes;
  options.region.minimumSize = m_RegionMinimumSize;
  options.region.maximumSize = m_RegionMaximumSize;
  return options;
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (m_Radius < 0.0 || std::isinf(m_Radius))
  {
    itkExceptionMacro("The radius is " << m_Radius << " mm. It must be finite and not negative.");
  }
  if (m_SizingImageReplaces && this->GetSizingImage() == nullptr)
  {
    itkExceptionMacro("There is no sizing image to stand in place of the computed sizes.");
  }
  if (m_AirMargin < 0.0 || std::isinf(m_AirMargin))
  {
    itkExceptionMacro("The air margin is " << m_AirMargin << " mm. It must be finite and not negative.");
  }
  if (this->IsFilled() && m_ExteriorLabels.empty())
  {
    itkExceptionMacro("The exterior is to be filled, but no label is exterior.");
  }
  if (!(m_MaximumMemory > 0.0))
  {
    itkExceptionMacro("The largest memory is " << m_MaximumMemory << " GB. It must be positive.");
  }
  const std::string error = mmm::DescribeError(this->GetSizingOptions(), this->GetRegionOfInterest() != nullptr);
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
  const auto   verify = [&](const ImageBase<3> * image, const char * name) {
    if (labels == nullptr || image == nullptr)
    {
      return;
    }
    if (!mmm::HaveSameGeometry(labels, image))
    {
      itkExceptionMacro("The " << name << " differs from the label image in origin, spacing or direction.");
    }
    if (labels->GetLargestPossibleRegion() != image->GetLargestPossibleRegion())
    {
      itkExceptionMacro("The " << name << " has " << image->GetLargestPossibleRegion().GetSize()
                               << " voxels and the label image " << labels->GetLargestPossibleRegion().GetSize()
                               << ". They must be on the same grid.");
    }
  };
  verify(this->GetSizingImage(), "sizing image");
  verify(this->GetRegionOfInterest(), "region of interest");
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GenerateInputRequestedRegion()
{
  for (const auto & name : this->GetInputNames())
  {
    if (auto * input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GenerateOutputRequestedRegion(DataObject *)
{
  for (DataObjectPointerArraySizeType n = 0; n < this->GetNumberOfIndexedOutputs(); ++n)
  {
    this->ProcessObject::GetOutput(n)->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GenerateData()
try
{
  // the shares are those of a head of 7 million voxels
  mmm::FilterMonitor monitor(this,
                             m_StageLog,
                             { { "merging of islands", 0.01 },
                               { "indicators", 0.07 },
                               { "sizing", 0.05 },
                               { "preparation", 0.01 },
                               { "seeding of particles", 0.02 },
                               { "relaxation of 1-cells", 0.01 },
                               { "relaxation of 2-cells", 0.11 },
                               { "surface", 0.19 },
                               { "topology", 0.02 },
                               { "seeding of the interior", 0.01 },
                               { "relaxation of the interior", 0.08 },
                               { "constrained tetrahedralization", 0.07 },
                               { "optimization", 0.30 },
                               { "fit of the interfaces", 0.06 },
                               { "output", 0.01 } });
  m_Labels.clear();
  m_AbsentExteriorLabels.clear();
  m_IslandRecords.clear();
  m_VanishedLabels.clear();
  m_Report = mmm::MeshingReport();
  m_IndicatorImages.clear();
  m_ComputedSizingImage = nullptr;

  monitor.BeginStage("merging of islands");
  const TLabelImage * input = this->GetInput();
  auto                counts = mmm::CountLabels(input);
  this->VerifyLabels(input, counts);
  this->VerifyRegionOfInterest(input);
  const auto domain = this->MakeDomain(input, counts);
  if (domain != input)
  {
    counts = mmm::CountLabels(domain.GetPointer());
  }
  this->VerifyLabelSizes(counts);
  m_MeshedRegion = domain->GetLargestPossibleRegion();
  const mmm::GridGeometry geometry(domain, m_MeshedRegion);
  auto                    labels = this->MergeIslands(this->MakeGridImage(domain, geometry), monitor);

  monitor.BeginStage("indicators");
  for (const auto & entry : mmm::CountLabels(labels.GetPointer()))
  {
    m_Labels.push_back(entry.first);
  }
  auto indicators = this->ComputeIndicators(labels, geometry, monitor);
  labels = nullptr;

  monitor.BeginStage("sizing");
  auto sizing = this->ComputeSizing(indicators, geometry, monitor);

  this->BuildMeshes(domain, indicators, sizing, monitor);
  this->FindVanishedLabels(counts);

  if (m_KeepIntermediates)
  {
    for (auto & image : indicators)
    {
      this->RestoreGeometry(domain, image, geometry.GetUnit());
    }
    this->RestoreGeometry(domain, sizing, geometry.GetUnit());
    m_IndicatorImages = std::move(indicators);
    m_ComputedSizingImage = sizing;
  }
}
catch (const std::bad_alloc &)
{
  mmm::ThrowOutOfMemory(std::string(this->GetNameOfClass()) + ", in stage \"" + m_StageLog.current + "\",");
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyLabels(const TLabelImage *     input,
                                                                          const VoxelCountsType & counts) const
{
  if (counts.size() < 2)
  {
    itkExceptionMacro("The label image has a single value"
                      << (counts.empty() ? "" : ", ") << (counts.empty() ? "" : std::to_string(counts.begin()->first))
                      << ": there is nothing to mesh.");
  }
  const bool isAllExterior =
    std::all_of(counts.begin(), counts.end(), [this](const VoxelCountsType::value_type & entry) {
      return this->IsExterior(entry.first);
    });
  if (isAllExterior)
  {
    itkExceptionMacro("All labels of the image are exterior: there is nothing to mesh.");
  }
  const std::string intensities = mmm::DescribeIntensities(input, counts);
  if (!intensities.empty())
  {
    itkExceptionMacro("The image " << intensities << '.');
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyLabelSizes(const VoxelCountsType & counts) const
{
  LabelsType labels;
  for (const auto & entry : counts)
  {
    if (!this->IsExterior(entry.first) || entry.first == this->GetExteriorLabel(counts))
    {
      labels.push_back(entry.first);
    }
  }
  const std::string error = mmm::DescribeUnknownLabels(m_LabelSizes, labels);
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyRegionOfInterest(const TLabelImage * input) const
{
  const MaskImageType * mask = this->GetRegionOfInterest();
  if (mask == nullptr)
  {
    return;
  }
  const auto &                            region = input->GetLargestPossibleRegion();
  ImageRegionConstIterator<TLabelImage>   label(input, region);
  ImageRegionConstIterator<MaskImageType> inRegion(mask, region);
  for (; !label.IsAtEnd(); ++label, ++inRegion)
  {
    if (inRegion.Get() != 0 && (this->IsFilled() || !this->IsExterior(static_cast<LabelType>(label.Get()))))
    {
      return;
    }
  }
  itkExceptionMacro("No voxel of the region of interest is in what is meshed.");
}

template <typename TLabelImage, typename TOutputMesh>
bool
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::IsExterior(LabelType label) const
{
  return std::find(m_ExteriorLabels.begin(), m_ExteriorLabels.end(), label) != m_ExteriorLabels.end();
}

template <typename TLabelImage, typename TOutputMesh>
bool
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::IsFilled() const
{
  return m_FillExterior || !std::isnan(m_AirMargin);
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetExteriorLabel(const VoxelCountsType & counts) const
  -> LabelType
{
  const auto isThere = [&](LabelType label) { return counts.count(label) != 0; };
  const auto first = std::find_if(m_ExteriorLabels.begin(), m_ExteriorLabels.end(), isThere);
  return first == m_ExteriorLabels.end() ? m_ExteriorLabels.front() : *first;
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MakeDomain(const TLabelImage *     input,
                                                                        const VoxelCountsType & counts) const ->
  typename TLabelImage::ConstPointer
{
  if (std::isnan(m_AirMargin))
  {
    return input;
  }
  using PixelType = typename TLabelImage::PixelType;
  const LabelType label = this->GetExteriorLabel(counts);
  const auto      air = static_cast<PixelType>(label);
  if (static_cast<std::int64_t>(air) != label)
  {
    itkExceptionMacro("The label of air, " << label << ", is beyond the range of the image's pixels.");
  }
  const auto box =
    mmm::BoxOf(input, [this](PixelType pixel) { return !this->IsExterior(static_cast<LabelType>(pixel)); });
  const auto region = mmm::GrowRegion(box, input->GetSpacing(), m_AirMargin);
  this->VerifyMemory(region);
  return mmm::CopyRegion(input, region, air);
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyMemory(const RegionType & region) const
{
  // the least that there is at a time: labels twice, sizes, distances and materials
  constexpr double bytesPerVoxel = 2 * sizeof(typename TLabelImage::PixelType) + 12;
  double           voxels = 1.0;
  for (const auto length : region.GetSize())
  {
    voxels *= static_cast<double>(length);
  }
  const double gigabytes = voxels * bytesPerVoxel / (1024.0 * 1024.0 * 1024.0);
  if (gigabytes > m_MaximumMemory)
  {
    itkExceptionMacro("With an air margin of " << m_AirMargin << " mm, the image has " << mmm::DescribeCount(voxels)
                                               << " voxels and takes at least " << gigabytes
                                               << " GB, more than the limit of " << m_MaximumMemory
                                               << " GB. A smaller margin helps.");
  }
}

template <typename TLabelImage, typename TOutputMesh>
int
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetExteriorIndex() const
{
  if (this->IsFilled())
  {
    return -1;
  }
  for (std::size_t n = 0; n < m_Labels.size(); ++n)
  {
    if (this->IsExterior(m_Labels[n]))
    {
      return static_cast<int>(n);
    }
  }
  return -1;
}

template <typename TLabelImage, typename TOutputMesh>
typename TLabelImage::Pointer
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MakeGridImage(const TLabelImage *       domain,
                                                                           const mmm::GridGeometry & geometry) const
{
  const auto image = TLabelImage::New();
  image->Graft(domain);
  mmm::GridGeometry::SetGridGeometry(geometry.GetGrid(), image);
  return image;
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MakeGridSizingImage(
  const mmm::GridGeometry & geometry) const -> SizingImageType::Pointer
{
  const SizingImageType * input = this->GetSizingImage();
  if (input == nullptr)
  {
    return nullptr;
  }
  const auto extended = mmm::CopyRegion(input, geometry.GetRegion(), std::numeric_limits<float>::infinity());
  const auto sizes = mmm::ReadSizingImage(extended.GetPointer(), geometry);
  const auto image = SizingImageType::New();
  mmm::GridGeometry::SetGridGeometry(geometry.GetGrid(), image);
  image->Allocate();
  std::copy(sizes.begin(), sizes.end(), image->GetBufferPointer());
  return image;
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MakeGridRegion(const mmm::GridGeometry & geometry) const
  -> MaskImageType::Pointer
{
  const MaskImageType * input = this->GetRegionOfInterest();
  if (input == nullptr)
  {
    return nullptr;
  }
  const auto image = MaskImageType::New();
  image->Graft(mmm::CopyRegion(input, geometry.GetRegion(), MaskImageType::PixelType(0)).GetPointer());
  mmm::GridGeometry::SetGridGeometry(geometry.GetGrid(), image);
  return image;
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::RestoreGeometry(const TLabelImage * domain,
                                                                             Image<float, 3> *   image,
                                                                             double              unit) const
{
  auto region = image->GetBufferedRegion();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, region.GetIndex(axis) + domain->GetLargestPossibleRegion().GetIndex(axis));
  }
  image->CopyInformation(domain);
  image->SetRegions(region);
  float * values = image->GetBufferPointer();
  std::transform(values, values + region.GetNumberOfPixels(), values, [unit](float value) {
    return static_cast<float>(value * unit);
  });
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::Observe(ProcessObject *      filter,
                                                                     mmm::FilterMonitor & monitor)
{
  filter->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  filter->AddObserver(ProgressEvent(), [this, filter, &monitor](const EventObject &) {
    monitor.Update(filter->GetProgress());
    if (this->GetAbortGenerateData())
    {
      filter->AbortGenerateDataOn();
    }
  });
}

template <typename TLabelImage, typename TOutputMesh>
typename TLabelImage::Pointer
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MergeIslands(const TLabelImage *  labels,
                                                                          mmm::FilterMonitor & monitor)
{
  const auto filter = MergeLabelIslandsImageFilter<TLabelImage>::New();
  filter->SetInput(labels);
  filter->SetExteriorLabels(m_ExteriorLabels);
  filter->SetMinimumIslandSize(m_MinimumIslandSize);
  this->Observe(filter, monitor);
  filter->Update();
  m_IslandRecords = filter->GetRecords();
  m_AbsentExteriorLabels = filter->GetAbsentExteriorLabels();
  return filter->GetOutput();
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::ComputeIndicators(const TLabelImage *       labels,
                                                                               const mmm::GridGeometry & geometry,
                                                                               mmm::FilterMonitor &      monitor)
  -> IndicatorImagesType
{
  const auto filter = LabelImageToIndicatorImagesFilter<TLabelImage, IndicatorImageType>::New();
  filter->SetInput(labels);
  filter->SetRadius(geometry.ToGridUnit(m_Radius));
  // who samples that finely wants the topology rather than the best triangles
  filter->SetKeepContacts(m_Epsilon <= 1.0);
  this->Observe(filter, monitor);
  filter->Update();
  IndicatorImagesType images;
  for (const auto label : m_Labels)
  {
    images.push_back(filter->GetOutputForLabel(label));
  }
  return images;
}

template <typename TLabelImage, typename TOutputMesh>
auto
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::ComputeSizing(const IndicatorImagesType & indicators,
                                                                           const mmm::GridGeometry &   geometry,
                                                                           mmm::FilterMonitor &        monitor)
  -> SizingImageType::Pointer
{
  const auto filter = IndicatorImagesToSizingImageFilter<IndicatorImageType, SizingImageType>::New();
  for (std::size_t n = 0; n < indicators.size(); ++n)
  {
    filter->SetInput(static_cast<unsigned int>(n), indicators[n]);
  }
  filter->SetSizingImage(this->MakeGridSizingImage(geometry));
  filter->SetSizingImageReplaces(m_SizingImageReplaces);
  filter->SetRegionOfInterest(this->MakeGridRegion(geometry));
  filter->SetRegionMinimumSize(geometry.ToGridUnit(m_RegionMinimumSize));
  filter->SetRegionMaximumSize(geometry.ToGridUnit(m_RegionMaximumSize));
  filter->SetLabels(m_Labels);
  filter->SetLabelSizes(mmm::ToGridUnit(m_LabelSizes, geometry));
  filter->SetMaximumVolume(std::pow(geometry.ToGridUnit(std::cbrt(m_MaximumVolume)), 3));
  filter->SetEpsilon(m_Epsilon);
  filter->SetGradientLimit(m_GradientLimit);
  filter->SetChordTolerance(geometry.ToGridUnit(m_ChordTolerance));
  filter->SetMinimumSize(geometry.ToGridUnit(m_MinimumSize));
  filter->SetMaximumSize(geometry.ToGridUnit(m_MaximumSize));
  filter->SetExteriorIndex(this->GetExteriorIndex());
  this->Observe(filter, monitor);
  filter->Update();
  return filter->GetOutput();
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::BuildMeshes(const TLabelImage *         domain,
                                                                         const IndicatorImagesType & indicators,
                                                                         const SizingImageType *     sizing,
                                                                         mmm::FilterMonitor &        monitor)
{
  const auto filter = MeshFilterType::New();
  for (std::size_t n = 0; n < indicators.size(); ++n)
  {
    indicators[n]->SetReleaseDataFlag(!m_KeepIntermediates);
    filter->SetInput(static_cast<unsigned int>(n), indicators[n]);
  }
  filter->SetSizingImage(sizing);
  filter->SetLabels(m_Labels);
  filter->SetExteriorIndex(this->GetExteriorIndex());
  filter->SetOutsideLabel(m_ExteriorLabels.empty() ? 0 : m_ExteriorLabels.front());
  filter->SetSeed(m_Seed);
  filter->SetSurfaceOnly(m_SurfaceOnly);
  filter->SetKeepTopology(m_Epsilon <= 1.0);
  filter->SetCompareTopology(m_CompareTopology);
  filter->SetMaximumNumberOfTetrahedra(m_MaximumNumberOfTetrahedra);
  filter->SetMaximumMemory(m_MaximumMemory);
  filter->SetReferenceImage(domain);
  filter->AddObserver(ProgressEvent(), [this, &filter, &monitor](const EventObject &) {
    m_Report.estimate = filter->GetReport().estimate;
    if (filter->GetCurrentStage() != m_StageLog.current)
    {
      monitor.BeginStage(filter->GetCurrentStage());
    }
    monitor.Report(filter->GetStageProgress());
  });
  try
  {
    filter->Update();
  }
  catch (...)
  {
    this->TakeOutputs(filter);
    throw;
  }
  this->TakeOutputs(filter);
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::TakeOutputs(MeshFilterType * filter)
{
  this->GraftNthOutput(0, filter->GetOutput());
  this->GraftNthOutput(1, filter->GetSurface());
  this->GraftNthOutput(2, filter->GetParticles());
  this->GraftNthOutput(3, filter->GetJunctions());
  m_OutsideLabel = filter->GetUsedOutsideLabel();
  m_Report = filter->GetReport();
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::FindVanishedLabels(const VoxelCountsType & counts)
{
  std::set<LabelType> meshed{ m_OutsideLabel };
  if (m_SurfaceOnly)
  {
    for (const auto & sides : this->GetSurface()->GetCellData()->CastToSTLConstContainer())
    {
      meshed.insert(sides.Begin(), sides.End());
    }
  }
  else
  {
    for (const auto label : this->GetOutput()->GetCellData()->CastToSTLConstContainer())
    {
      meshed.insert(static_cast<LabelType>(label));
    }
  }
  for (const auto label : m_Labels)
  {
    if (!meshed.count(label))
    {
      m_VanishedLabels.insert(*counts.find(label));
    }
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabels: " << m_ExteriorLabels << std::endl;
  os << indent << "FillExterior: " << (m_FillExterior ? "On" : "Off") << std::endl;
  os << indent << "AirMargin: " << m_AirMargin << std::endl;
  os << indent << "MinimumIslandSize: " << m_MinimumIslandSize << std::endl;
  os << indent << "Radius: " << m_Radius << std::endl;
  os << indent << "Epsilon: " << m_Epsilon << std::endl;
  os << indent << "ChordTolerance: " << m_ChordTolerance << std::endl;
  os << indent << "GradientLimit: " << m_GradientLimit << std::endl;
  os << indent << "MinimumSize: " << m_MinimumSize << std::endl;
  os << indent << "MaximumSize: " << m_MaximumSize << std::endl;
  os << indent << "MaximumVolume: " << m_MaximumVolume << std::endl;
  os << indent << "LabelSizes: " << mmm::ToText(m_LabelSizes) << std::endl;
  os << indent << "SizingImageReplaces: " << (m_SizingImageReplaces ? "On" : "Off") << std::endl;
  os << indent << "RegionMinimumSize: " << m_RegionMinimumSize << std::endl;
  os << indent << "RegionMaximumSize: " << m_RegionMaximumSize << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "SurfaceOnly: " << (m_SurfaceOnly ? "On" : "Off") << std::endl;
  os << indent << "CompareTopology: " << (m_CompareTopology ? "On" : "Off") << std::endl;
  os << indent << "MaximumNumberOfTetrahedra: " << m_MaximumNumberOfTetrahedra << std::endl;
  os << indent << "MaximumMemory: " << m_MaximumMemory << std::endl;
  os << indent << "KeepIntermediates: " << (m_KeepIntermediates ? "On" : "Off") << std::endl;
  os << indent << "Labels: " << m_Labels << std::endl;
  os << indent << "MeshedRegion: " << m_MeshedRegion << std::endl;
  os << indent << "OutsideLabel: " << m_OutsideLabel << std::endl;
  os << indent << "AbsentExteriorLabels: " << m_AbsentExteriorLabels << std::endl;
  os << indent << "VanishedLabels:";
  for (const auto & entry : m_VanishedLabels)
  {
    os << ' ' << entry.first << " (" << entry.second << " voxels)";
  }
  os << std::endl;
  os << indent << "CurrentStage: " << m_StageLog.current << " (" << m_StageLog.progress << ')' << std::endl;
}
} // namespace itk

#endif
