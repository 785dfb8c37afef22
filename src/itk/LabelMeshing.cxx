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
#include "itkLabelMeshing.h"

#include "itk/ElectrodeContacts.h"
#include "itk/ElectrodeSurfaces.h"
#include "itk/FilterMonitor.h"
#include "itk/FunctionImages.h"
#include "itk/ImageRegions.h"
#include "itk/IndicatorMeshing.h"
#include "itk/IndicatorSizing.h"
#include "itk/LabelDomain.h"
#include "itk/LabelIslands.h"
#include "itk/LabelSlices.h"
#include "itk/LabelSmoothing.h"
#include "itk/SizingImage.h"
#include "itk/SizingOptions.h"
#include "itk/SurfaceOverlay.h"
#include "itkImageConversion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

namespace mmm
{
namespace
{
/** Who samples as finely as epsilon 1 does wants the topology rather than the best triangles. */
bool
KeepsTopology(const LabelMeshingInputs & inputs)
{
  const TopologyMode mode = inputs.options.topologyMode;
  return mode == TopologyMode::Keep || (mode == TopologyMode::Automatic && inputs.sizing.options.epsilon <= 1.0);
}

/** An image in the geometry of its grid, where the stages work: the grid's unit of length, origin 0, no rotation. */
template <typename TImage>
typename TImage::Pointer
InGrid(const TImage * image, const GridGeometry & geometry)
{
  const auto copy = TImage::New();
  copy->Graft(image);
  GridGeometry::SetGridGeometry(geometry.GetGrid(), copy);
  return copy;
}

/** What users ask of the sizes, in the grid's unit and geometry. */
SizingInputs
InGrid(const SizingInputs & inputs, const GridGeometry & geometry)
{
  SizingInputs    sizing;
  SizingOptions & options = sizing.options;
  options = inputs.options;
  for (double * length : { &options.chordTolerance, &options.minimumSize, &options.maximumSize })
  {
    *length = geometry.ToGridUnit(*length);
  }
  options.maximumVolume = std::pow(geometry.ToGridUnit(std::cbrt(options.maximumVolume)), 3);
  options.labelSizes = ToGridUnit(options.labelSizes, geometry);
  options.region = ToGridUnit(options.region, geometry);
  if (inputs.image)
  {
    const auto extended =
      CopyRegion(inputs.image.GetPointer(), geometry.GetRegion(), std::numeric_limits<float>::infinity());
    const auto sizes = ReadSizingImage(extended.GetPointer(), geometry);
    const auto image = FloatImage::New();
    GridGeometry::SetGridGeometry(geometry.GetGrid(), image);
    image->Allocate();
    std::copy(sizes.begin(), sizes.end(), image->GetBufferPointer());
    sizing.image = image;
  }
  if (inputs.region)
  {
    sizing.region = InGrid(
      CopyRegion(inputs.region.GetPointer(), geometry.GetRegion(), MaskImage::PixelType(0)).GetPointer(), geometry);
  }
  return sizing;
}

/** Gives an image of a stage the geometry of the domain, with values in mm. */
void
RestoreGeometry(const itk::ImageBase<3> * domain, double unit, FloatImage * image)
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

/** A part of an image of which only the geometry is left. */
itk::ImageBase<3>::Pointer
GeometryOf(const itk::ImageBase<3> * image, const itk::ImageRegion<3> & region)
{
  const auto geometry = itk::ImageBase<3>::New();
  geometry->CopyInformation(image);
  geometry->SetRegions(region);
  return geometry;
}

/** The place of the label that is not meshed among the labels, or -1 if there is none. */
int
ExteriorOf(const LabelOptions & options, const std::vector<int> & labels)
{
  const auto exterior = IsFilled(options) ? labels.end() : std::find_if(labels.begin(), labels.end(), [&](int label) {
    return Contains(options.exteriorLabels, label);
  });
  return exterior == labels.end() ? -1 : static_cast<int>(exterior - labels.begin());
}

/** Labels that were to be meshed but are in no mesh, and their numbers of voxels. */
LabelCounts
FindVanished(const std::vector<int> & labels, const std::set<int> & meshed, const LabelCounts & counts)
{
  LabelCounts vanished;
  for (const int label : labels)
  {
    if (!meshed.count(label))
    {
      vanished.insert(*counts.find(label));
    }
  }
  return vanished;
}

/** Labels that vanish are to be small. */
void
VerifyVanished(const LabelCounts & vanished)
{
  constexpr std::size_t largest = 1000;
  for (const auto & [label, voxels] : vanished)
  {
    if (voxels > largest)
    {
      itkGenericExceptionMacro(
        "Label " << label << " (" << voxels
                 << " voxels) would not be in the mesh: it is thinner than the smoothing radius "
                    "or the edge lengths resolve. Make these smaller, or set AllowVanishedLabels "
                    "(--allow-vanished).");
    }
  }
}

/** The outputs, with a note of the labels that they have. */
MeshingOutputs
NoteLabels(const MeshingOutputs & outputs, std::set<int> & meshed)
{
  MeshingOutputs noting = outputs;
  noting.setTetrahedra = [&](const itk::TetrahedronArrays & arrays) {
    meshed.insert(arrays.labels.begin(), arrays.labels.end());
    outputs.setTetrahedra(arrays);
  };
  return noting;
}

class LabelMesher
{
public:
  LabelMesher(LabelMeshingInputs     inputs,
              const MeshingOutputs & outputs,
              MeshingState &         state,
              LabelMeshingResults &  results,
              FilterMonitor &        monitor)
    : m_Inputs(std::move(inputs))
    , m_Outputs(outputs)
    , m_State(state)
    , m_Results(results)
    , m_Monitor(monitor)
  {}

  void
  Run()
  {
    m_Monitor.BeginStage("merging of islands");
    for (int & label : m_Inputs.surfaces.labels)
    {
      // all exterior is one material, with the first of its labels if there is any of that
      label = Contains(m_Inputs.options.exteriorLabels, label) ? m_Inputs.options.exteriorLabels.front() : label;
    }
    const LabelSlices             slices(m_Inputs, m_Monitor);
    const ElectrodeSurfaces       electrodes(m_Inputs, m_Results.electrodes);
    std::optional<SurfaceOverlay> surfaces;
    if (!m_Inputs.surfaces.labels.empty())
    {
      surfaces.emplace(m_Inputs.surfaces, UniteExterior(m_Inputs));
      m_Inputs.labels = ComposeLabels(m_Inputs.labels, m_Inputs.surfaces).GetPointer();
    }
    auto               labels = this->Crop(this->MergeIslands(electrodes, slices));
    const GridGeometry geometry(m_Domain, m_Domain->GetLargestPossibleRegion());

    m_Monitor.BeginStage("indicators");
    auto indicators = this->ComputeIndicators(geometry, labels, surfaces);
    labels = nullptr;

    m_Monitor.BeginStage("sizing");
    MeshingInputs inputs;
    inputs.indicators.images.assign(indicators.begin(), indicators.end());
    inputs.indicators.labels = m_Results.labels;
    inputs.indicators.exterior = ExteriorOf(m_Inputs.options, m_Results.labels);
    auto sizing = ComputeSizingImage(inputs.indicators, InGrid(m_Inputs.sizing, geometry), m_Monitor);

    inputs.sizing = sizing;
    inputs.options = m_Inputs.meshing;
    inputs.outsideLabel = m_Inputs.options.exteriorLabels.empty() ? 0 : m_Inputs.options.exteriorLabels.front();
    inputs.keepTopology = KeepsTopology(m_Inputs);
    inputs.reference = m_Domain;
    std::set<int> meshed;
    const auto    release = [&] {
      if (!m_Inputs.options.keepIntermediates)
      {
        indicators.clear();
        sizing = nullptr;
      }
    };
    MeshIndicators(inputs, release, NoteLabels(m_Outputs, meshed), m_State, m_Monitor);
    if (slices.AreDivided())
    {
      m_State.report.warnings.push_back(slices.Describe());
    }
    if (m_Inputs.meshing.surfaceOnly)
    {
      for (const auto & sides : m_Outputs.surface->GetCellData()->CastToSTLConstContainer())
      {
        meshed.insert(sides.Begin(), sides.End());
      }
    }
    meshed.insert(m_State.outsideLabel);
    MeasureContacts(m_Inputs.electrodes,
                    m_Outputs.surface,
                    m_Inputs.options.exteriorLabels,
                    m_State.outsideLabel,
                    m_Results.electrodes);
    m_Results.vanishedLabels = FindVanished(m_Results.labels, meshed, m_Counts);
    if (!m_Inputs.options.allowVanishedLabels)
    {
      VerifyVanished(m_Results.vanishedLabels);
    }

    if (m_Inputs.options.keepIntermediates)
    {
      for (auto & image : indicators)
      {
        RestoreGeometry(m_Domain, geometry.GetUnit(), image);
      }
      RestoreGeometry(m_Domain, geometry.GetUnit(), sizing);
      m_Results.indicatorImages = std::move(indicators);
      m_Results.sizingImage = ExtendRegion(sizing.GetPointer(), m_Region);
    }
  }

private:
  /** In the grid's geometry. The input is not needed any more. */
  LabelImage::Pointer
  MergeIslands(const ElectrodeSurfaces & electrodes, const LabelSlices & slices)
  {
    const LabelDomain domain(m_Inputs);
    m_Counts = domain.GetCounts();
    m_Region = domain.GetImage()->GetLargestPossibleRegion();
    m_Results.meshedRegion = slices.ToImage(m_Region);
    m_Domain = GeometryOf(domain.GetImage(), m_Region);
    m_Inputs.labels = nullptr;
    const GridGeometry geometry(m_Domain, m_Region);
    auto               labels = itk::CopyToIntegers(InGrid(domain.GetImage(), geometry).GetPointer());
    MergeLabelIslands(m_Inputs.options.exteriorLabels,
                      m_Inputs.options.minimumIslandSize,
                      labels,
                      m_Results.islandRecords,
                      m_Results.absentExteriorLabels,
                      m_Monitor);
    electrodes.Restore(m_Inputs.surfaces, domain, labels, m_Results.islandRecords);
    slices.Restore(m_Results.islandRecords, m_Results.absentExteriorLabels);
    for (auto & entry : m_Counts)
    {
      entry.second = slices.ToImage(entry.second);
    }
    for (const auto & entry : CountLabels(labels))
    {
      m_Results.labels.push_back(entry.first);
    }
    return labels;
  }

  /** Leaves out exterior that is far from what is meshed, but for functions, which have its size. */
  LabelImage::Pointer
  Crop(LabelImage * labels)
  {
    // in voxels: the indicators' band on both sides of it, and room for the medial axis
    constexpr double margin = 8.0;

    const int place = ExteriorOf(m_Inputs.options, m_Results.labels);
    if (place < 0 || !m_Inputs.functions.images.empty())
    {
      return labels;
    }
    const int  exterior = m_Results.labels[place];
    const auto box = BoxOf(labels, [exterior](int label) { return label != exterior; });
    auto       region = GrowRegion(box, labels->GetSpacing(), margin);
    region.Crop(labels->GetLargestPossibleRegion());
    const auto part = CopyRegion(labels, region, exterior);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      region.SetIndex(axis, region.GetIndex(axis) + m_Region.GetIndex(axis));
    }
    m_Domain = GeometryOf(m_Domain, region);
    return InGrid(part.GetPointer(), GridGeometry(m_Domain, region));
  }

  std::vector<FloatImage::Pointer>
  ComputeIndicators(const GridGeometry &                  geometry,
                    const LabelImage *                    labels,
                    const std::optional<SurfaceOverlay> & surfaces)
  {
    if (!m_Inputs.functions.images.empty())
    {
      return ComputeFunctionIndicators(
        m_Inputs.functions, m_Inputs.options.exteriorLabels, m_Results.labels, labels, m_Monitor);
    }
    const SmoothingOptions options{ geometry.ToGridUnit(m_Inputs.options.radius), KeepsTopology(m_Inputs), true };
    return surfaces ? surfaces->ComputeIndicators(labels, m_Results.labels, geometry, options, m_Monitor)
                    : ComputeIndicatorImages(options, labels, m_Monitor).images;
  }

  LabelMeshingInputs         m_Inputs;
  const MeshingOutputs &     m_Outputs;
  MeshingState &             m_State;
  LabelMeshingResults &      m_Results;
  FilterMonitor &            m_Monitor;
  itk::ImageBase<3>::Pointer m_Domain;
  itk::ImageRegion<3>        m_Region; // of the domain as a whole
  LabelCounts                m_Counts;
};
} // namespace

void
MeshLabels(itk::ProcessObject *   filter,
           LabelMeshingInputs     inputs,
           const MeshingOutputs & outputs,
           MeshingState &         state,
           LabelMeshingResults &  results)
{
  results = LabelMeshingResults();
  state.report = MeshingReport();
  // the shares are those of a head of 7 million voxels
  RunStages(filter,
            state.log,
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
              { "output", 0.01 } },
            [&](FilterMonitor & monitor) { LabelMesher(std::move(inputs), outputs, state, results, monitor).Run(); });
}
} // namespace mmm
