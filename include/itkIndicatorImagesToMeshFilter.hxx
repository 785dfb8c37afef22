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
#ifndef itkIndicatorImagesToMeshFilter_hxx
#define itkIndicatorImagesToMeshFilter_hxx

#include "itk/IndicatorImages.h"
#include "itk/MeshConversion.h"
#include "base/OutOfMemory.h"
#include "itk/ReportTranslation.h"
#include "itk/SizingImage.h"

#include "itkLineCell.h"
#include "itkPrintHelper.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"
#include "itkVertexCell.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <sstream>
#include <string>

namespace itk
{
template <typename TIndicatorImage, typename TOutputMesh>
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::IndicatorImagesToMeshFilter()
{
  this->AddRequiredInputName("SizingImage");
  this->SetNumberOfRequiredOutputs(4);
  for (DataObjectPointerArraySizeType n = 0; n < 4; ++n)
  {
    this->SetNthOutput(n, Self::MakeOutput(n));
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
DataObject::Pointer
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::MakeOutput(DataObjectPointerArraySizeType index)
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

template <typename TIndicatorImage, typename TOutputMesh>
auto
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetSurface() -> SurfaceMeshType *
{
  return dynamic_cast<SurfaceMeshType *>(this->ProcessObject::GetOutput(1));
}

template <typename TIndicatorImage, typename TOutputMesh>
auto
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetParticles() -> ParticleMeshType *
{
  return dynamic_cast<ParticleMeshType *>(this->ProcessObject::GetOutput(2));
}

template <typename TIndicatorImage, typename TOutputMesh>
auto
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetJunctions() -> JunctionMeshType *
{
  return dynamic_cast<JunctionMeshType *>(this->ProcessObject::GetOutput(3));
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::SetLabels(const LabelsType & labels)
{
  if (m_Labels != labels)
  {
    m_Labels = labels;
    this->Modified();
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::SetSizingImage(const SizingImageType * image)
{
  this->ProcessObject::SetInput("SizingImage", const_cast<SizingImageType *>(image));
}

template <typename TIndicatorImage, typename TOutputMesh>
auto
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetSizingImage() const -> const SizingImageType *
{
  return dynamic_cast<const SizingImageType *>(this->ProcessObject::GetInput("SizingImage"));
}

template <typename TIndicatorImage, typename TOutputMesh>
std::vector<const TIndicatorImage *>
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GetIndicatorImages() const
{
  std::vector<const TIndicatorImage *> images(this->GetNumberOfIndexedInputs());
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    images[n] = dynamic_cast<const TIndicatorImage *>(this->ProcessObject::GetInput(n));
  }
  return images;
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  const auto images = this->GetIndicatorImages();
  for (std::size_t n = 0; n < images.size(); ++n)
  {
    if (images[n] == nullptr)
    {
      itkExceptionMacro("Input " << n << " of " << images.size() << " is missing.");
    }
  }
  if (this->GetSizingImage() == nullptr)
  {
    itkExceptionMacro("The input \"SizingImage\" is not a three-dimensional image of float.");
  }
  if (m_Labels.size() != images.size())
  {
    itkExceptionMacro("There are " << m_Labels.size() << " labels for " << images.size() << " indicator images.");
  }
  auto sorted = m_Labels;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
  {
    itkExceptionMacro("The label " << *twice << " is given to more than one indicator image.");
  }
  if (m_ExteriorIndex < -1 || m_ExteriorIndex >= static_cast<int>(images.size()))
  {
    itkExceptionMacro("ExteriorIndex is " << m_ExteriorIndex << ", but there are " << images.size()
                                          << " indicator images.");
  }
  if (m_ExteriorIndex == 0 && images.size() == 1)
  {
    itkExceptionMacro("There is nothing but exterior.");
  }
  if (!(m_MaximumMemory > 0.0))
  {
    itkExceptionMacro("The largest memory is " << m_MaximumMemory << " GB. It must be positive.");
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::VerifyInputInformation() const
{
  const auto images = this->GetIndicatorImages();
  const auto region = mmm::IndicatorImages<TIndicatorImage>(images).GetRegion();
  for (std::size_t n = 1; n < images.size(); ++n)
  {
    if (!mmm::HaveSameGeometry(images[0], images[n]))
    {
      itkExceptionMacro("Indicator image " << n << " differs from indicator image 0 in origin, spacing or direction.");
    }
  }
  const SizingImageType * sizes = this->GetSizingImage();
  if (!mmm::HaveSameGeometry(images[0], sizes))
  {
    itkExceptionMacro("The sizing image differs from the indicator images in origin, spacing or direction.");
  }
  if (sizes->GetLargestPossibleRegion() != region)
  {
    itkExceptionMacro("The sizing image covers " << sizes->GetLargestPossibleRegion()
                                                 << " and the indicator images together " << region
                                                 << ". They must be the same.");
  }
  if (m_ReferenceImage && m_ReferenceImage->GetLargestPossibleRegion().GetSize() != region.GetSize())
  {
    itkExceptionMacro("The reference image has " << m_ReferenceImage->GetLargestPossibleRegion().GetSize()
                                                 << " voxels and the sizing image " << region.GetSize()
                                                 << ". They must be the same.");
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GenerateInputRequestedRegion()
{
  for (const auto & name : this->GetInputNames())
  {
    if (auto * input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GenerateOutputRequestedRegion(DataObject *)
{
  for (DataObjectPointerArraySizeType n = 0; n < this->GetNumberOfIndexedOutputs(); ++n)
  {
    this->ProcessObject::GetOutput(n)->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::GenerateData()
try
{
  // the shares are those of a head of 7 million voxels
  mmm::FilterMonitor monitor(this,
                             m_StageLog,
                             { { "preparation", 0.01 },
                               { "seeding of particles", 0.02 },
                               { "relaxation of 1-cells", 0.01 },
                               { "relaxation of 2-cells", 0.13 },
                               { "surface", 0.22 },
                               { "topology", 0.02 },
                               { "seeding of the interior", 0.02 },
                               { "relaxation of the interior", 0.09 },
                               { "constrained tetrahedralization", 0.08 },
                               { "optimization", 0.33 },
                               { "fit of the interfaces", 0.06 },
                               { "output", 0.01 } });
  m_Report = mmm::MeshingReport();
  monitor.BeginStage("preparation");
  const mmm::IndicatorImages<TIndicatorImage> images(this->GetIndicatorImages());
  const auto              sizes = mmm::ReadSizingImage(this->GetSizingImage(), images.GetGeometry());
  const mmm::IndicatorSet indicators = images.MakeIndicatorSet();
  this->ReleaseInputs(); // where they ask for it: nothing below needs their pixels
  const mmm::SizingField  sizing(indicators.GetGrid(), sizes.data());
  const mmm::GridGeometry outputGeometry =
    m_ReferenceImage ? mmm::GridGeometry(m_ReferenceImage, m_ReferenceImage->GetLargestPossibleRegion())
                     : images.GetGeometry();

  const mmm::MeshEstimator estimator(indicators, m_ExteriorIndex, sizing, m_SurfaceOnly);
  m_Report.estimate = estimator.Estimate();
  this->VerifyEstimate(estimator, outputGeometry.GetUnit());

  mmm::MeshingParameters parameters;
  parameters.exterior = m_ExteriorIndex;
  parameters.seed = m_Seed;
  parameters.surfaceOnly = m_SurfaceOnly;
  parameters.keepTopology = m_KeepTopology;
  parameters.compareTopology = m_CompareTopology;
  mmm::MeshingResult result;
  result.report.estimate = m_Report.estimate;
  try
  {
    mmm::BuildMesh(indicators, sizing, parameters, monitor, result);
    for (const auto & warning : result.report.warnings)
    {
      itkWarningMacro(<< warning);
    }
    monitor.BeginStage("output");
  }
  catch (...)
  {
    // for those who want to see where it failed
    this->FillSurfaceAndParticles(result, outputGeometry);
    throw;
  }
  this->FillSurfaceAndParticles(result, outputGeometry);
  this->FillTetrahedra(result, outputGeometry);
  monitor.Report(1.0);
}
catch (const std::bad_alloc &)
{
  mmm::ThrowOutOfMemory(std::string(this->GetNameOfClass()) + ", in stage \"" + m_StageLog.current + "\",");
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::VerifyEstimate(const mmm::MeshEstimator & estimator,
                                                                          double                     unit) const
{
  const auto most = static_cast<double>(m_MaximumNumberOfTetrahedra);
  const bool isTooLarge = m_Report.estimate.tetrahedra > most;
  if (!isTooLarge && m_Report.estimate.memory <= m_MaximumMemory)
  {
    return;
  }
  std::ostringstream words;
  words << "About " << mmm::Describe(m_Report.estimate) << " are to be expected, more than the limit of ";
  if (isTooLarge)
  {
    words << m_MaximumNumberOfTetrahedra << " tetrahedra.";
  }
  else
  {
    words << m_MaximumMemory << " GB.";
  }
  const double size = unit * estimator.SmallestSizeFor(most, m_MaximumMemory);
  if (std::isfinite(size))
  {
    words << " A smallest size of " << mmm::RoundUp(size) << " mm is expected to keep to it.";
  }
  else
  {
    words << " No smallest size is expected to keep to it: the images or their thin parts take more. Larger voxels or "
             "fewer labels would help.";
  }
  itkExceptionMacro(<< words.str());
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::FillSurfaceAndParticles(const mmm::MeshingResult & result,
                                                                                   const mmm::GridGeometry &  geometry)
{
  const mmm::InterfaceLabels labels(m_Labels, m_ExteriorIndex, m_OutsideLabel);
  m_UsedOutsideLabel = labels.GetOutside();
  m_Report = result.report;
  mmm::TranslateReport(geometry, labels, m_Report);

  // where the surface was not reached, the particles are all that there is
  const bool hasSurface = !result.points.empty();
  const auto count = result.particles.Size();

  SurfaceMeshType * surface = this->GetSurface();
  if (hasSurface)
  {
    const bool isReflected = geometry.IsReflected();
    const auto isReversed = [&](std::size_t triangle) {
      const auto & sides = result.interfaces.sides[triangle];
      return isReflected != (labels.OfMaterial(sides[0]) > labels.OfMaterial(sides[1]));
    };
    std::vector<SurfaceMeshType::CellPixelType> sideLabels;
    sideLabels.reserve(result.interfaces.sides.size());
    for (const auto & sides : result.interfaces.sides)
    {
      sideLabels.emplace_back(labels.OfSides(sides));
    }
    mmm::SetMeshPoints(surface, geometry, result.points, result.numberOfSurfacePoints);
    mmm::SetMeshCells<TriangleCell<SurfaceMeshType::CellType>>(surface, result.interfaces.triangles, isReversed);
    mmm::SetMeshCellData(surface, std::move(sideLabels));
  }
  surface->SetBufferedRegion(surface->GetRequestedRegion());

  ParticleMeshType * particles = this->GetParticles();
  mmm::SetMeshPoints(particles, geometry, result.particles.positions, count);
  const auto data = ParticleMeshType::PointDataContainer::New();
  auto &     values = data->CastToSTLContainer();
  values.reserve(count);
  for (std::size_t p = 0; p < count; ++p)
  {
    values.emplace_back(labels.OfParticle(result.particles.CellOf(p)));
  }
  particles->SetPointData(data);
  particles->SetBufferedRegion(particles->GetRequestedRegion());

  this->FillJunctions(result, geometry, labels);
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::FillJunctions(const mmm::MeshingResult &   result,
                                                                         const mmm::GridGeometry &    geometry,
                                                                         const mmm::InterfaceLabels & labels)
{
  JunctionMeshType * mesh = this->GetJunctions();
  const auto         cells = JunctionMeshType::CellsContainer::New();

  std::vector<mmm::Vector>                     points;
  std::vector<JunctionMeshType::CellPixelType> data;
  std::map<mmm::PointId, std::size_t>          places;
  const auto                                   placeOf = [&](mmm::PointId point) {
    const auto inserted = places.emplace(point, points.size());
    if (inserted.second)
    {
      points.push_back(result.points[point]);
    }
    return inserted.first->second;
  };
  const auto append = [&](auto * cell, int curve, const mmm::MaterialList & materials) {
    cells->InsertElement(cells->Size(), cell);
    const auto                      values = labels.OfJunction(materials);
    JunctionMeshType::CellPixelType pixel;
    pixel[0] = curve;
    std::copy(values.begin(), values.end(), &pixel[1]);
    data.push_back(pixel);
  };
  for (const auto & junction : result.junctions.points)
  {
    auto * vertex = new VertexCell<JunctionMeshType::CellType>;
    vertex->SetPointId(0, placeOf(junction.point));
    append(vertex, -1, junction.materials);
  }
  for (std::size_t c = 0; c < result.junctions.curves.size(); ++c)
  {
    const auto & curve = result.junctions.curves[c];
    for (std::size_t p = 1; p < curve.points.size(); ++p)
    {
      auto * line = new LineCell<JunctionMeshType::CellType>;
      line->SetPointId(0, placeOf(curve.points[p - 1]));
      line->SetPointId(1, placeOf(curve.points[p]));
      append(line, static_cast<int>(c), curve.materials);
    }
  }
  mmm::SetMeshPoints(mesh, geometry, points, points.size());
  mesh->SetCellsAllocationMethod(MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(cells);
  mmm::SetMeshCellData(mesh, std::move(data));
  mesh->SetBufferedRegion(mesh->GetRequestedRegion());
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::FillTetrahedra(const mmm::MeshingResult & result,
                                                                          const mmm::GridGeometry &  geometry)
{
  TOutputMesh * output = this->GetOutput();
  if (!m_SurfaceOnly)
  {
    const bool                                       isReflected = geometry.IsReflected();
    std::vector<typename TOutputMesh::CellPixelType> labels;
    labels.reserve(result.tetrahedra.materials.size());
    for (const auto material : result.tetrahedra.materials)
    {
      labels.push_back(static_cast<typename TOutputMesh::CellPixelType>(m_Labels[material]));
    }
    mmm::SetMeshPoints(output, geometry, result.points, result.points.size());
    mmm::SetMeshCells<TetrahedronCell<typename TOutputMesh::CellType>>(
      output, result.tetrahedra.tetrahedra, [isReflected](std::size_t) { return isReflected; });
    mmm::SetMeshCellData(output, std::move(labels));
  }
  output->SetBufferedRegion(output->GetRequestedRegion());
}

template <typename TIndicatorImage, typename TOutputMesh>
void
IndicatorImagesToMeshFilter<TIndicatorImage, TOutputMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  using namespace print_helper;
  Superclass::PrintSelf(os, indent);
  os << indent << "Labels: " << m_Labels << std::endl;
  os << indent << "ExteriorIndex: " << m_ExteriorIndex << std::endl;
  os << indent << "OutsideLabel: " << m_OutsideLabel << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "SurfaceOnly: " << (m_SurfaceOnly ? "On" : "Off") << std::endl;
  os << indent << "KeepTopology: " << (m_KeepTopology ? "On" : "Off") << std::endl;
  os << indent << "CompareTopology: " << (m_CompareTopology ? "On" : "Off") << std::endl;
  os << indent << "MaximumNumberOfTetrahedra: " << m_MaximumNumberOfTetrahedra << std::endl;
  os << indent << "MaximumMemory: " << m_MaximumMemory << std::endl;
  itkPrintSelfObjectMacro(ReferenceImage);
  os << indent << "UsedOutsideLabel: " << m_UsedOutsideLabel << std::endl;
  os << indent << "Particles on cells of dimension 0 to 3: " << m_Report.particles[0] << ' ' << m_Report.particles[1]
     << ' ' << m_Report.particles[2] << ' ' << m_Report.particles[3] << std::endl;
  os << indent << "CurrentStage: " << m_StageLog.current << " (" << m_StageLog.progress << ')' << std::endl;
}
} // namespace itk

#endif
