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
#include "mmmSizingImage.h"

#include "itkPrintHelper.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace itk
{
template <typename TLabelImage, typename TOutputMesh>
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::LabelImageToTetrahedralMeshFilter()
{
  this->AddOptionalInputName("SizingImage");
  this->SetNumberOfRequiredOutputs(3);
  for (DataObjectPointerArraySizeType n = 0; n < 3; ++n)
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
mmm::SizingOptions
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetSizingOptions() const
{
  mmm::SizingOptions options;
  options.epsilon = m_Epsilon;
  options.chordTolerance = m_ChordTolerance;
  options.gradientLimit = m_GradientLimit;
  options.minimumSize = m_MinimumSize;
  options.maximumSize = m_MaximumSize;
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
  const std::string error = mmm::DescribeError(this->GetSizingOptions());
  if (!error.empty())
  {
    itkExceptionMacro(<< error);
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyInputInformation() const
{
  const auto *            labels = dynamic_cast<const TLabelImage *>(this->GetPrimaryInput());
  const SizingImageType * sizes = this->GetSizingImage();
  if (labels == nullptr || sizes == nullptr)
  {
    return;
  }
  if (!mmm::HaveSameGeometry(labels, sizes))
  {
    itkExceptionMacro("The sizing image differs from the label image in origin, spacing or direction.");
  }
  if (labels->GetLargestPossibleRegion() != sizes->GetLargestPossibleRegion())
  {
    itkExceptionMacro("The sizing image has "
                      << sizes->GetLargestPossibleRegion().GetSize() << " voxels and the label image "
                      << labels->GetLargestPossibleRegion().GetSize() << ". They must be on the same grid.");
  }
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
                               { "seeding of the interior", 0.01 },
                               { "relaxation of the interior", 0.08 },
                               { "constrained tetrahedralization", 0.07 },
                               { "optimization", 0.36 },
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
  const auto          counts = mmm::CountLabels(input);
  this->VerifyLabels(counts);
  const mmm::GridGeometry geometry(input, input->GetLargestPossibleRegion());
  auto                    labels = this->MergeIslands(this->MakeGridImage(geometry), monitor);

  monitor.BeginStage("indicators");
  auto indicators = this->ComputeIndicators(labels, geometry, monitor);
  labels = nullptr;

  monitor.BeginStage("sizing");
  auto sizing = this->ComputeSizing(indicators, geometry, monitor);

  this->BuildMeshes(indicators, sizing, monitor);
  this->FindVanishedLabels(counts);

  if (m_KeepIntermediates)
  {
    for (auto & image : indicators)
    {
      this->RestoreGeometry(image, geometry.GetUnit());
    }
    this->RestoreGeometry(sizing, geometry.GetUnit());
    m_IndicatorImages = std::move(indicators);
    m_ComputedSizingImage = sizing;
  }
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::VerifyLabels(const VoxelCountsType & counts) const
{
  if (counts.size() < 2)
  {
    itkExceptionMacro("The label image has a single value"
                      << (counts.empty() ? "" : ", ") << (counts.empty() ? "" : std::to_string(counts.begin()->first))
                      << ": there is nothing to mesh.");
  }
  const bool isAllExterior =
    std::all_of(counts.begin(), counts.end(), [this](const VoxelCountsType::value_type & entry) {
      return std::find(m_ExteriorLabels.begin(), m_ExteriorLabels.end(), entry.first) != m_ExteriorLabels.end();
    });
  if (isAllExterior)
  {
    itkExceptionMacro("All labels of the image are exterior: there is nothing to mesh.");
  }
}

template <typename TLabelImage, typename TOutputMesh>
int
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::GetExteriorIndex() const
{
  for (std::size_t n = 0; n < m_Labels.size(); ++n)
  {
    if (std::find(m_ExteriorLabels.begin(), m_ExteriorLabels.end(), m_Labels[n]) != m_ExteriorLabels.end())
    {
      return static_cast<int>(n);
    }
  }
  return -1;
}

template <typename TLabelImage, typename TOutputMesh>
typename TLabelImage::Pointer
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::MakeGridImage(const mmm::GridGeometry & geometry)
{
  const auto image = TLabelImage::New();
  image->Graft(this->GetInput());
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
  const auto sizes = mmm::ReadSizingImage(input, geometry);
  const auto image = SizingImageType::New();
  mmm::GridGeometry::SetGridGeometry(geometry.GetGrid(), image);
  image->Allocate();
  std::copy(sizes.begin(), sizes.end(), image->GetBufferPointer());
  return image;
}

template <typename TLabelImage, typename TOutputMesh>
void
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::RestoreGeometry(Image<float, 3> * image, double unit)
{
  const TLabelImage * input = this->GetInput();
  auto                region = image->GetBufferedRegion();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, region.GetIndex(axis) + input->GetLargestPossibleRegion().GetIndex(axis));
  }
  image->CopyInformation(input);
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
  this->Observe(filter, monitor);
  filter->Update();
  m_Labels = filter->GetLabels();
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
LabelImageToTetrahedralMeshFilter<TLabelImage, TOutputMesh>::BuildMeshes(const IndicatorImagesType & indicators,
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
  filter->SetReferenceImage(this->GetInput());
  filter->AddObserver(ProgressEvent(), [this, &filter, &monitor](const EventObject &) {
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
  os << indent << "MinimumIslandSize: " << m_MinimumIslandSize << std::endl;
  os << indent << "Radius: " << m_Radius << std::endl;
  os << indent << "Epsilon: " << m_Epsilon << std::endl;
  os << indent << "ChordTolerance: " << m_ChordTolerance << std::endl;
  os << indent << "GradientLimit: " << m_GradientLimit << std::endl;
  os << indent << "MinimumSize: " << m_MinimumSize << std::endl;
  os << indent << "MaximumSize: " << m_MaximumSize << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "SurfaceOnly: " << (m_SurfaceOnly ? "On" : "Off") << std::endl;
  os << indent << "KeepIntermediates: " << (m_KeepIntermediates ? "On" : "Off") << std::endl;
  os << indent << "Labels: " << m_Labels << std::endl;
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
