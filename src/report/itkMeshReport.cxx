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
#include "itkMeshReport.h"

#include "report/CurvingSection.h"
#include "report/ElectrodeSection.h"
#include "report/Json.h"

#include "itkContinuousIndex.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mmm
{
namespace
{
/** An object for each label: {"label": 1, <name>: <value>}. */
template <typename TCounts>
Json
PerLabel(const TCounts & counts, const char * name)
{
  Json list = Json::Array();
  for (const auto & [label, count] : counts)
  {
    list.Add(Json::Object({ { "label", label }, { name, count } }));
  }
  return list;
}

template <typename TVector>
Json
Triple(const TVector & values)
{
  return Json::Array({ double(values[0]), double(values[1]), double(values[2]) });
}

Json
StageSection(const std::vector<StageRecord> & stages)
{
  Json section = Json::Array();
  for (const auto & stage : stages)
  {
    section.Add(Json::Object({ { "name", stage.name },
                               { "seconds", stage.seconds },
                               { "peak_memory_mb", stage.peakMemory > 0.0 ? Json(stage.peakMemory) : Json() } }));
  }
  return section;
}

Json
CountSection(const itk::MeshFacts & facts)
{
  const MeshingReport & report = *facts.meshing;
  Json                  section = Json::Object();
  section.Add("particles_on_0_cells", report.particles[0]);
  section.Add("particles_on_1_cells", report.particles[1]);
  section.Add("particles_on_2_cells", report.particles[2]);
  section.Add("particles_in_the_interior", report.particles[3]);
  section.Add("unused_particles", report.unusedParticles);
  section.Add("points_left_out", report.pointsLeftOut);
  section.Add("steiner_points", report.steinerPoints);
  section.Add("surface_points", facts.surface->GetNumberOfPoints());
  section.Add("triangles", facts.surface->GetNumberOfCells());
  section.Add("points", facts.tetrahedra->GetNumberOfPoints());
  section.Add("tetrahedra", facts.tetrahedra->GetNumberOfCells());
  return section;
}

/** Lists are cut off where they get long. */
constexpr std::size_t MostPlaces = 1000;

Json
ToJson(const MeshingPlace & place)
{
  return Json::Object({ { "labels", place.labels }, { "position_mm", Triple(place.position) } });
}

Json
PlaceList(const std::vector<MeshingPlace> & places)
{
  Json section = Json::Array();
  for (std::size_t p = 0; p < places.size() && p < MostPlaces; ++p)
  {
    section.Add(ToJson(places[p]));
  }
  return section;
}

Json
DifferenceList(const std::vector<TopologyPlace> & differences)
{
  Json section = Json::Array();
  for (std::size_t p = 0; p < differences.size() && p < MostPlaces; ++p)
  {
    Json entry = ToJson(differences[p].place);
    entry.Add("euler_change", differences[p].changes);
    section.Add(entry);
  }
  return section;
}

/** How the labels meet: around the points of interfaces, and by what they have of components, tunnels and cavities. */
Json
TopologySection(const MeshingReport & report)
{
  Json section = Json::Object();
  section.Add("link_defects_found",
              Json::Object({ { "edges", report.links.edges },
                             { "points", report.links.points },
                             { "tetrahedra_relabelled", report.links.relabelled } }));
  section.Add("link_defects_left", report.links.left.size());
  section.Add("link_defects_left_at", PlaceList(report.links.left));
  section.Add("inconsistent_triangles", report.inconsistentTriangles.size());
  section.Add("inconsistent_triangles_at", PlaceList(report.inconsistentTriangles));
  std::ptrdiff_t unexplained = 0;
  Json           numbers = Json::Array();
  for (const auto & topology : report.topology.labels)
  {
    numbers.Add(Json::Object({ { "label", topology.label },
                               { "mesh", topology.mesh },
                               { "indicators", topology.partition },
                               { "equal", topology.mesh == topology.partition },
                               { "euler_unexplained", topology.unexplained } }));
    unexplained += std::abs(topology.unexplained);
  }
  section.Add("betti_numbers", numbers);
  section.Add("differences",
              Json::Object({ { "number", report.topology.differences.size() },
                             { "unexplained", unexplained },
                             { "places", DifferenceList(report.topology.differences) },
                             { "cancelling", report.topology.cancelling.size() },
                             { "cancelling_at", PlaceList(report.topology.cancelling) } }));
  return section;
}

Json
EstimateSection(const MeshEstimate & estimate)
{
  return Json::Object({ { "triangles", std::llround(estimate.triangles) },
                        { "points", std::llround(estimate.points) },
                        { "tetrahedra", std::llround(estimate.tetrahedra) },
                        { "memory_gb", estimate.memory } });
}

Json
RelaxationSection(const MeshingReport & report)
{
  Json section = Json::Array();
  for (std::size_t dimension = 1; dimension < report.relaxation.size(); ++dimension)
  {
    const RelaxationReport & relaxation = report.relaxation[dimension];
    section.Add(Json::Object({ { "cell_dimension", dimension },
                               { "sweeps", relaxation.sweeps },
                               { "mean_move", relaxation.meanMove },
                               { "converged", relaxation.converged },
                               { "added", relaxation.added },
                               { "removed", relaxation.removed } }));
  }
  return section;
}

Json
ResidualSection(const ResidualReports & residuals)
{
  Json section = Json::Array();
  for (std::size_t dimension = 1; dimension < residuals.size(); ++dimension)
  {
    const ResidualReport & residual = residuals[dimension];
    section.Add(Json::Object({ { "cell_dimension", dimension },
                               { "maximum", residual.maximum },
                               { "last_percentile", residual.percentile99 },
                               { "share_above_0.01", residual.leftShare } }));
  }
  return section;
}

Json
SamplingSection(const MeshingReport & report)
{
  const SamplingReport & sampling = report.sampling;
  return Json::Object(
    { { "spacing_by_size",
        Json::Object({ { "median", sampling.medianSpacing },
                       { "first_percentile", sampling.percentile1Spacing },
                       { "last_percentile", sampling.percentile99Spacing },
                       { "share_from_0.6_to_1.6", sampling.nearShare } }) },
      { "residuals_in_voxels",
        Json::Object({ { "of_particles", ResidualSection(report.residualsOfParticles) },
                       { "after_optimization", ResidualSection(report.residualsAfterOptimization) } }) } });
}

Json
OptimizationSection(const OptimizationReport & optimization)
{
  return Json::Object({ { "rounds", optimization.rounds },
                        { "flips", optimization.flips },
                        { "interface_flips", optimization.interfaceFlips },
                        { "relabelled", optimization.relabelled },
                        { "collapses", optimization.collapses },
                        { "moves", optimization.moves } });
}

Json
IslandSection(const std::map<int, IslandRecord> & islands)
{
  Json section = Json::Array();
  for (const auto & [label, record] : islands)
  {
    if (record.components > 0)
    {
      section.Add(Json::Object({ { "label", label },
                                 { "islands", record.components },
                                 { "voxels", record.voxels },
                                 { "voxels_before", record.voxelsBefore },
                                 { "voxels_after", record.voxelsAfter },
                                 { "went_to", PerLabel(record.destinations, "voxels") } }));
    }
  }
  return section;
}

Json
ToJson(const Distribution & distribution)
{
  return Json::Object({ { "average", distribution.average },
                        { "minimum", distribution.minimum },
                        { "first_percentile", distribution.firstPercentile } });
}

/** {"5": 0, "10": 2, "15": 31} */
Json
CountsPerAngle(const std::array<std::size_t, 3> & counts, const std::array<const char *, 3> & angles)
{
  return Json::Object({ { angles[0], counts[0] }, { angles[1], counts[1] }, { angles[2], counts[2] } });
}

void
AddStatistics(Json & section, const TetrahedronStatistics & statistics)
{
  section.Add("tetrahedra", statistics.count);
  section.Add("volume_mm3", statistics.volume);
  section.Add("largest_volume_mm3", statistics.largestVolume);
  section.Add("non_positive", statistics.nonPositive);
  section.Add("radius_ratio", ToJson(statistics.radiusRatio));
  section.Add("smallest_dihedral_angle_deg", ToJson(statistics.smallestAngle));
  section.Add("largest_dihedral_angle_deg", statistics.largestAngle);
  section.Add("tetrahedra_below_deg", CountsPerAngle(statistics.below, { "5", "10", "15" }));
  section.Add("tetrahedra_above_deg", CountsPerAngle(statistics.above, { "165", "170", "175" }));
  section.Add("radius_ratio_histogram", statistics.radiusRatioHistogram);
  section.Add("dihedral_angle_histogram", statistics.dihedralAngleHistogram);
}

/** Whether a corner of a tetrahedron lies on a face of the box that is meshed, where all is cut off flat. */
bool
IsOnBorder(const itk::MeshFacts & facts, std::size_t tetrahedron)
{
  constexpr double tolerance = 1e-6;
  const auto &     region = facts.meshedRegion;
  const auto &     points = facts.tetrahedra->GetPoints()->CastToSTLConstContainer();
  auto * const     cell = facts.tetrahedra->GetCells()->GetElement(tetrahedron);
  return std::any_of(cell->PointIdsBegin(), cell->PointIdsEnd(), [&](auto p) {
    itk::Point<double, 3> point;
    point.CastFrom(points[p]);
    itk::ContinuousIndex<double, 3> index;
    // whether it is inside does not matter here
    static_cast<void>(facts.image->TransformPhysicalPointToContinuousIndex(point, index));
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
ToJson(const itk::MeshFacts & facts, const PoorTetrahedron & tetrahedron)
{
  return Json::Object({ { "index", tetrahedron.index },
                        { "label", tetrahedron.label },
                        { "neighbor_labels", tetrahedron.neighborLabels },
                        { "place", ToString(tetrahedron.GetPlace()) },
                        { "on_image_border", IsOnBorder(facts, tetrahedron.index) },
                        { "boundary_corners", tetrahedron.boundaryCorners },
                        { "boundary_faces", tetrahedron.boundaryFaces },
                        { "center_mm", Triple(tetrahedron.center) },
                        { "smallest_dihedral_angle_deg", tetrahedron.smallestAngle },
                        { "largest_dihedral_angle_deg", tetrahedron.largestAngle } });
}

Json
QualitySection(const itk::MeshFacts & facts)
{
  Json section = Json::Object();
  section.Add("triangle_radius_ratio", ToJson(facts.surfaceQuality));
  if (facts.quality == nullptr)
  {
    return section;
  }
  const MeshQualityReport & quality = *facts.quality;
  Json                      overall = Json::Object();
  AddStatistics(overall, quality.tetrahedra);
  section.Add("overall", overall);
  section.Add("unused_points", quality.unusedPoints);
  section.Add("duplicate_points", quality.duplicatePoints);
  section.Add("overused_faces", quality.overusedFaces);
  section.Add("open_edges", quality.openEdges);
  section.Add("non_manifold_edges", quality.nonManifoldEdges);
  Json labels = Json::Array();
  for (const auto & label : quality.labels)
  {
    Json entry = Json::Object({ { "label", label.label } });
    AddStatistics(entry, label.tetrahedra);
    entry.Add("components", label.components);
    entry.Add("boundary_faces", label.boundaryFaces);
    labels.Add(entry);
  }
  section.Add("labels", labels);
  section.Add("poor_tetrahedra", quality.poorTetrahedra);
  // the list is cut off where it gets long
  section.Add("poor_tetrahedra_listed", quality.poorest.size());
  Json worst = Json::Array();
  for (const auto & tetrahedron : quality.poorest)
  {
    worst.Add(ToJson(facts, tetrahedron));
  }
  section.Add("worst_tetrahedra", worst);
  return section;
}
} // namespace
} // namespace mmm

namespace itk
{
std::string
MakeMeshReport(const MeshFacts & facts)
{
  using mmm::Json;
  const mmm::MeshingReport & meshing = *facts.meshing;
  Json                       report = Json::Object();
  report.Add("exterior_labels_absent", facts.absentExteriorLabels);
  report.Add("outside_label", facts.outsideLabel);
  report.Add("islands_merged", mmm::IslandSection(*facts.islands));
  report.Add("vanished_labels", mmm::PerLabel(*facts.vanishedLabels, "voxels"));
  report.Add("expected", mmm::EstimateSection(meshing.estimate));
  report.Add("counts", mmm::CountSection(facts));
  if (facts.electrodes != nullptr && !facts.electrodes->empty())
  {
    report.Add("electrodes", mmm::ElectrodeSection(*facts.electrodes));
  }
  report.Add("relaxation", mmm::RelaxationSection(meshing));
  report.Add("topology", mmm::TopologySection(meshing));
  report.Add("sampling", mmm::SamplingSection(meshing));
  report.Add("optimization", mmm::OptimizationSection(meshing.optimization));
  report.Add("second_order", mmm::CurvingSection(meshing.curving));
  report.Add("quality", mmm::QualitySection(facts));
  report.Add("stages", mmm::StageSection(*facts.stages));
  return report.ToText() + '\n';
}
} // end namespace itk
