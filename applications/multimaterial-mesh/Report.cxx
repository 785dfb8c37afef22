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
#include "Report.h"

#include "Version.h"

#include "itkMultiThreaderBase.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace cli
{
namespace
{
using Json = nlohmann::ordered_json;

Json
Number(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/** An object for each label: {"label": 1, <name>: <value>}. */
template <typename TCounts>
Json
PerLabel(const TCounts & counts, const char * name)
{
  Json list = Json::array();
  for (const auto & [label, count] : counts)
  {
    list.push_back({ { "label", label }, { name, count } });
  }
  return list;
}

template <typename TVector>
Json
Triple(const TVector & values)
{
  return { Number(values[0]), Number(values[1]), Number(values[2]) };
}

Json
InputSection(const Outcome & outcome)
{
  const auto size = outcome.labels->GetLargestPossibleRegion().GetSize();
  Json       section;
  if (outcome.settings.indicators.empty())
  {
    section["file"] = outcome.settings.labels;
  }
  else
  {
    section["indicators"] = outcome.settings.indicators;
    section["indicator_labels"] = outcome.settings.indicatorLabels;
  }
  section["size"] = { size[0], size[1], size[2] };
  section["spacing_mm"] = Triple(outcome.labels->GetSpacing());
  section["origin_mm"] = Triple(outcome.labels->GetOrigin());
  section["labels"] = PerLabel(outcome.voxels, "voxels");
  return section;
}

Json
ParameterSection(const Settings & settings)
{
  const auto length = [](const std::optional<double> & value) { return value ? Number(*value) : Json(nullptr); };
  const auto file = [](const std::string & name) { return name.empty() ? Json(nullptr) : Json(name); };
  Json       section;
  section["exterior"] = settings.exterior;
  section["fill_exterior"] = settings.IsFilled();
  section["air_margin_mm"] = length(settings.airMargin);
  section["min_island_voxels"] = settings.minIsland;
  section["surface_only"] = settings.surfaceOnly;
  section["msh_format"] = settings.mshFormat;
  section["ras"] = settings.ras;
  section["radius_mm"] = length(settings.radius);
  section["epsilon"] = Number(settings.epsilon);
  section["tolerance_mm"] = length(settings.tolerance);
  section["gradient_limit"] = Number(settings.gradientLimit);
  section["min_size_mm"] = length(settings.minSize);
  section["max_size_mm"] = length(settings.maxSize);
  section["max_volume_mm3"] = length(settings.maxVolume);
  section["label_size"] = mmm::ToText(settings.labelSizes);
  section["sizing_image"] = file(settings.sizingImage);
  section["sizing_mode"] = settings.sizingMode;
  section["roi"] = file(settings.roi);
  section["roi_min_size_mm"] = length(settings.roiMinSize);
  section["roi_max_size_mm"] = length(settings.roiMaxSize);
  section["max_tetrahedra"] = settings.maxTetrahedra ? Json(*settings.maxTetrahedra) : Json(nullptr);
  section["max_memory_gb"] = length(settings.maxMemory);
  section["threads"] = itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
  section["seed"] = settings.seed;
  return section;
}

Json
StageSection(const std::vector<mmm::StageRecord> & stages)
{
  Json section = Json::array();
  for (const auto & stage : stages)
  {
    section.push_back({ { "name", stage.name },
                        { "seconds", Number(stage.seconds) },
                        { "peak_memory_mb", stage.peakMemory > 0.0 ? Number(stage.peakMemory) : Json(nullptr) } });
  }
  return section;
}

Json
CountSection(const Outcome & outcome)
{
  const mmm::MeshingReport & report = outcome.filter->GetReport();
  Json                       section;
  section["particles_on_0_cells"] = report.particles[0];
  section["particles_on_1_cells"] = report.particles[1];
  section["particles_on_2_cells"] = report.particles[2];
  section["particles_in_the_interior"] = report.particles[3];
  section["unused_particles"] = report.unusedParticles;
  section["steiner_points"] = report.steinerPoints;
  section["facet_recovery_failed"] = report.recoveryFailed;
  section["surface_points"] = outcome.surface->GetNumberOfPoints();
  section["triangles"] = outcome.surface->GetNumberOfCells();
  section["points"] = outcome.tetrahedra->GetNumberOfPoints();
  section["tetrahedra"] = outcome.tetrahedra->GetNumberOfCells();
  return section;
}

/** Lists are cut off where they get long. */
constexpr std::size_t MostPlaces = 1000;

Json
ToJson(const mmm::MeshingPlace & place)
{
  return { { "labels", place.labels }, { "position_mm", { place.position[0], place.position[1], place.position[2] } } };
}

Json
PlaceList(const std::vector<mmm::MeshingPlace> & places)
{
  Json section = Json::array();
  for (std::size_t p = 0; p < places.size() && p < MostPlaces; ++p)
  {
    section.push_back(ToJson(places[p]));
  }
  return section;
}

Json
DifferenceList(const std::vector<mmm::TopologyPlace> & differences)
{
  Json section = Json::array();
  for (std::size_t p = 0; p < differences.size() && p < MostPlaces; ++p)
  {
    Json entry = ToJson(differences[p].place);
    entry["euler_change"] = differences[p].changes;
    section.push_back(entry);
  }
  return section;
}

/** How the labels meet: around the points of interfaces, and by what they have of components, tunnels and cavities. */
Json
TopologySection(const mmm::MeshingReport & report)
{
  Json section;
  section["link_defects_found"] = { { "edges", report.links.edges },
                                    { "points", report.links.points },
                                    { "tetrahedra_relabelled", report.links.relabelled } };
  section["link_defects_left"] = report.links.left.size();
  section["link_defects_left_at"] = PlaceList(report.links.left);
  section["inconsistent_triangles"] = report.inconsistentTriangles.size();
  section["inconsistent_triangles_at"] = PlaceList(report.inconsistentTriangles);
  std::ptrdiff_t unexplained = 0;
  section["betti_numbers"] = Json::array();
  for (const auto & topology : report.topology.labels)
  {
    section["betti_numbers"].push_back({ { "label", topology.label },
                                         { "mesh", topology.mesh },
                                         { "indicators", topology.partition },
                                         { "equal", topology.mesh == topology.partition },
                                         { "euler_unexplained", topology.unexplained } });
    unexplained += std::abs(topology.unexplained);
  }
  section["differences"] = { { "number", report.topology.differences.size() },
                             { "unexplained", unexplained },
                             { "places", DifferenceList(report.topology.differences) },
                             { "cancelling", report.topology.cancelling.size() },
                             { "cancelling_at", PlaceList(report.topology.cancelling) } };
  return section;
}

Json
EstimateSection(const mmm::MeshEstimate & estimate)
{
  return { { "triangles", std::llround(estimate.triangles) },
           { "points", std::llround(estimate.points) },
           { "tetrahedra", std::llround(estimate.tetrahedra) },
           { "memory_gb", Number(estimate.memory) } };
}

Json
RelaxationSection(const mmm::MeshingReport & report)
{
  Json section = Json::array();
  for (std::size_t dimension = 1; dimension < report.relaxation.size(); ++dimension)
  {
    const mmm::RelaxationReport & relaxation = report.relaxation[dimension];
    section.push_back({ { "cell_dimension", dimension },
                        { "sweeps", relaxation.sweeps },
                        { "mean_move", Number(relaxation.meanMove) },
                        { "converged", relaxation.converged },
                        { "added", relaxation.added },
                        { "removed", relaxation.removed } });
  }
  return section;
}

Json
ResidualSection(const mmm::ResidualReports & residuals)
{
  Json section = Json::array();
  for (std::size_t dimension = 1; dimension < residuals.size(); ++dimension)
  {
    const mmm::ResidualReport & residual = residuals[dimension];
    section.push_back({ { "cell_dimension", dimension },
                        { "maximum", Number(residual.maximum) },
                        { "last_percentile", Number(residual.percentile99) },
                        { "share_above_0.01", Number(residual.leftShare) } });
  }
  return section;
}

Json
SamplingSection(const mmm::MeshingReport & report)
{
  const mmm::SamplingReport & sampling = report.sampling;
  return { { "spacing_by_size",
             { { "median", Number(sampling.medianSpacing) },
               { "first_percentile", Number(sampling.percentile1Spacing) },
               { "last_percentile", Number(sampling.percentile99Spacing) },
               { "share_from_0.6_to_1.6", Number(sampling.nearShare) } } },
           { "residuals_in_voxels",
             { { "of_particles", ResidualSection(report.residualsOfParticles) },
               { "after_optimization", ResidualSection(report.residualsAfterOptimization) } } } };
}

Json
OptimizationSection(const mmm::OptimizationReport & optimization)
{
  return { { "rounds", optimization.rounds },
           { "flips", optimization.flips },
           { "interface_flips", optimization.interfaceFlips },
           { "relabelled", optimization.relabelled },
           { "collapses", optimization.collapses },
           { "moves", optimization.moves } };
}

Json
IslandSection(const MeshFilter & filter)
{
  Json section = Json::array();
  for (const auto & [label, record] : filter.GetIslandRecords())
  {
    if (record.components > 0)
    {
      section.push_back({ { "label", label },
                          { "islands", record.components },
                          { "voxels", record.voxels },
                          { "voxels_before", record.voxelsBefore },
                          { "voxels_after", record.voxelsAfter },
                          { "went_to", PerLabel(record.destinations, "voxels") } });
    }
  }
  return section;
}

Json
ToJson(const mmm::Distribution & distribution)
{
  return { { "average", Number(distribution.average) },
           { "minimum", Number(distribution.minimum) },
           { "first_percentile", Number(distribution.firstPercentile) } };
}

/** {"5": 0, "10": 2, "15": 31} */
Json
CountsPerAngle(const std::array<std::size_t, 3> & counts, const std::array<const char *, 3> & angles)
{
  return { { angles[0], counts[0] }, { angles[1], counts[1] }, { angles[2], counts[2] } };
}

Json
ToJson(const mmm::TetrahedronStatistics & statistics)
{
  Json section;
  section["tetrahedra"] = statistics.count;
  section["volume_mm3"] = Number(statistics.volume);
  section["largest_volume_mm3"] = Number(statistics.largestVolume);
  section["non_positive"] = statistics.nonPositive;
  section["radius_ratio"] = ToJson(statistics.radiusRatio);
  section["smallest_dihedral_angle_deg"] = ToJson(statistics.smallestAngle);
  section["largest_dihedral_angle_deg"] = Number(statistics.largestAngle);
  section["tetrahedra_below_deg"] = CountsPerAngle(statistics.below, { "5", "10", "15" });
  section["tetrahedra_above_deg"] = CountsPerAngle(statistics.above, { "165", "170", "175" });
  section["radius_ratio_histogram"] = statistics.radiusRatioHistogram;
  section["dihedral_angle_histogram"] = statistics.dihedralAngleHistogram;
  return section;
}

/** Whether a corner of a tetrahedron lies on a face of the box that is meshed, where all is cut off flat. */
bool
IsOnBorder(const Outcome & outcome, std::size_t tetrahedron)
{
  constexpr double tolerance = 1e-6;
  const auto &     region = outcome.filter->GetMeshedRegion();
  const auto &     points = outcome.tetrahedra->GetPoints()->CastToSTLConstContainer();
  auto * const     cell = outcome.tetrahedra->GetCells()->GetElement(tetrahedron);
  return std::any_of(cell->PointIdsBegin(), cell->PointIdsEnd(), [&](auto p) {
    LabelImage::PointType point;
    point.CastFrom(points[p]);
    itk::ContinuousIndex<double, 3> index;
    // whether it is inside does not matter here
    static_cast<void>(outcome.labels->TransformPhysicalPointToContinuousIndex(point, index));
    for (unsigned int a = 0; a < 3; ++a)
    {
      const double place = index[a] - double(region.GetIndex(a)) + 0.5;
      if (std::abs(place) < tolerance || std::abs(place - double(region.GetSize(a))) < tolerance)
      {
        return true;
      }
    }
    return false;
  });
}

Json
ToJson(const Outcome & outcome, const mmm::PoorTetrahedron & tetrahedron)
{
  return { { "index", tetrahedron.index },
           { "label", tetrahedron.label },
           { "neighbor_labels", tetrahedron.neighborLabels },
           { "place", mmm::ToString(tetrahedron.GetPlace()) },
           { "on_image_border", IsOnBorder(outcome, tetrahedron.index) },
           { "boundary_corners", tetrahedron.boundaryCorners },
           { "boundary_faces", tetrahedron.boundaryFaces },
           { "center_mm", Triple(tetrahedron.center) },
           { "smallest_dihedral_angle_deg", Number(tetrahedron.smallestAngle) },
           { "largest_dihedral_angle_deg", Number(tetrahedron.largestAngle) } };
}

Json
QualitySection(const Outcome & outcome)
{
  const mmm::MeshQualityReport & quality = outcome.quality;
  Json                           section;
  section["triangle_radius_ratio"] = ToJson(outcome.surfaceQuality);
  if (outcome.settings.surfaceOnly)
  {
    return section;
  }
  section["overall"] = ToJson(quality.tetrahedra);
  section["unused_points"] = quality.unusedPoints;
  section["duplicate_points"] = quality.duplicatePoints;
  section["overused_faces"] = quality.overusedFaces;
  section["open_edges"] = quality.openEdges;
  section["non_manifold_edges"] = quality.nonManifoldEdges;
  section["labels"] = Json::array();
  for (const auto & label : quality.labels)
  {
    Json entry{ { "label", label.label } };
    entry.update(ToJson(label.tetrahedra));
    entry["components"] = label.components;
    entry["boundary_faces"] = label.boundaryFaces;
    section["labels"].push_back(entry);
  }
  section["poor_tetrahedra"] = quality.poorTetrahedra;
  // the list is cut off where it gets long
  section["poor_tetrahedra_listed"] = quality.poorest.size();
  section["worst_tetrahedra"] = Json::array();
  for (const auto & tetrahedron : quality.poorest)
  {
    section["worst_tetrahedra"].push_back(ToJson(outcome, tetrahedron));
  }
  return section;
}
} // namespace

std::string
MakeReport(const Outcome & outcome)
{
  const MeshFilter & filter = *outcome.filter;
  Json               report;
  report["program"] = "multimaterial-mesh";
  report["version"] = GetVersion();
  report["input"] = InputSection(outcome);
  report["output"] = outcome.settings.output;
  report["parameters"] = ParameterSection(outcome.settings);
  report["exterior_labels_absent"] = filter.GetAbsentExteriorLabels();
  report["outside_label"] = filter.GetOutsideLabel();
  report["islands_merged"] = IslandSection(filter);
  report["vanished_labels"] = PerLabel(filter.GetVanishedLabels(), "voxels");
  report["expected"] = EstimateSection(filter.GetReport().estimate);
  report["counts"] = CountSection(outcome);
  report["relaxation"] = RelaxationSection(filter.GetReport());
  report["topology"] = TopologySection(filter.GetReport());
  report["sampling"] = SamplingSection(filter.GetReport());
  report["optimization"] = OptimizationSection(filter.GetReport().optimization);
  report["quality"] = QualitySection(outcome);
  report["stages"] = StageSection(outcome.stages);
  // File names need not be UTF-8, JSON has to be.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}
} // namespace cli
