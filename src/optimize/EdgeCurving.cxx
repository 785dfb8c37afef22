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
#include "optimize/EdgeCurving.h"

#include "base/Parallel.h"
#include "base/ParallelCollect.h"
#include "mesh/Junctions.h"
#include "mesh/KeyedRuns.h"
#include "optimize/CurvedTetrahedra.h"
#include "optimize/OptimizationParameters.h"

#include <algorithm>

namespace mmm
{
namespace
{
using Parameters = EdgeCurvingParameters;

constexpr std::size_t Grain = 4096;

/** An edge that is to be curved, and the materials that meet at it. */
struct InterfaceEdge
{
  std::array<PointId, 2> ends;
  Cell                   cell;
  /** Whether more materials meet at it than a cell can have. */
  bool isOverfull{ false };
};

/** Whether two materials at least meet that are no planes of the box: all other edges are straight in any case. */
bool
IsBetweenMaterials(const IndicatorSet & indicators, const Cell & cell)
{
  return std::count_if(cell.begin(), cell.end(), [&](Material m) { return !indicators.IsPlane(m); }) >= 2;
}

/** Sorted by their ends. */
std::vector<InterfaceEdge>
FindInterfaceEdges(const IndicatorSet &        indicators,
                   Material                    exterior,
                   const InterfaceMesh &       interfaces,
                   const std::vector<Vector> & points)
{
  const auto sides =
    SidesWithPlanes(interfaces, points, indicators.GetGrid(), indicators.GetNumberOfMaterials(), exterior);
  std::vector<Keyed> triangleSides;
  triangleSides.reserve(3 * interfaces.triangles.size());
  for (std::size_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    const Triangle & triangle = interfaces.triangles[t];
    for (int c = 0; c < 3; ++c)
    {
      const auto ends = std::minmax(triangle[c], triangle[(c + 1) % 3]);
      triangleSides.push_back({ Key(ends.first, ends.second), std::uint32_t(t) });
    }
  }
  std::sort(triangleSides.begin(), triangleSides.end());
  std::vector<InterfaceEdge> edges;
  ForEachRun(triangleSides, [&](std::size_t begin, std::size_t end) {
    const std::uint64_t key = triangleSides[begin].key;
    InterfaceEdge       edge{ { { PointId(key >> 32), PointId(key) } }, {} };
    for (auto n = begin; n < end; ++n)
    {
      const auto & pair = sides[triangleSides[n].value];
      edge.isOverfull |= !edge.cell.Join(Cell{ pair[0], pair[1] });
    }
    if (edge.isOverfull || IsBetweenMaterials(indicators, edge.cell))
    {
      edges.push_back(edge);
    }
  });
  return edges;
}

/** Moves the middle of an edge to its interface; false where that is not close to it. */
bool
PlaceOnInterface(const IndicatorSet &        indicators,
                 const std::vector<Vector> & points,
                 const InterfaceEdge &       edge,
                 Vector &                    middle)
{
  if (edge.isOverfull || edge.cell.Dimension() == 0)
  {
    return false;
  }
  const double length = (points[edge.ends[1]] - points[edge.ends[0]]).norm();
  return indicators.ProjectWhereMaximal(edge.cell, middle, Parameters::LargestRise * length);
}

/** Tells the volumes and the smallest Jacobian. */
void
Measure(const TetrahedralMesh &     mesh,
        const std::vector<Vector> & points,
        const CurvedEdges &         edges,
        CurvingReport &             report)
{
  const CurvedTetrahedra curved(mesh.tetrahedra, points, edges);
  std::vector<double>    volumes(mesh.tetrahedra.size());
  std::vector<double>    jacobians(NumberOfRanges(volumes.size(), Grain), 1.0);
  ParallelFor(volumes.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      double & smallest = jacobians[begin / Grain];
      volumes[t] = curved.VolumeOf(t);
      smallest = std::min(smallest, curved.RelativeJacobian(t));
    }
  });
  for (std::size_t t = 0; t < volumes.size(); ++t)
  {
    report.volumes[int(mesh.materials[t])] += volumes[t];
  }
  for (const double jacobian : jacobians)
  {
    report.smallestJacobian = std::min(report.smallestJacobian, jacobian);
  }
}
} // namespace

std::size_t
StraightenInvertingEdges(const std::vector<Tetrahedron> & tetrahedra,
                         const std::vector<Vector> &      points,
                         CurvedEdges &                    edges)
{
  CurvedTetrahedra curved(tetrahedra, points, edges);
  const auto       toCheck =
    ParallelCollect<std::uint32_t>(tetrahedra.size(), Grain, [&](std::size_t t, std::vector<std::uint32_t> & found) {
      if (curved.HasCurvedEdge(t))
      {
        found.push_back(std::uint32_t(t));
      }
    });
  std::vector<std::uint32_t> inverting;
  do
  {
    // each tetrahedron sees the edges as they were: the order does not matter
    inverting =
      ParallelCollect<std::uint32_t>(toCheck.size(), Grain, [&](std::size_t n, std::vector<std::uint32_t> & found) {
        const std::uint32_t edge = curved.FindInverting(toCheck[n]);
        if (edge != CurvedTetrahedra::NoEdge)
        {
          found.push_back(edge);
        }
      });
    for (const std::uint32_t edge : inverting)
    {
      curved.Straighten(edge);
    }
  } while (!inverting.empty());
  CurvedEdges kept;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    if (curved.IsCurved(e))
    {
      kept.push_back(edges[e]);
    }
  }
  const std::size_t count = edges.size() - kept.size();
  edges.swap(kept);
  return count;
}

CurvedEdges
CurveEdges(const IndicatorSet &        indicators,
           Material                    exterior,
           const TetrahedralMesh &     mesh,
           const InterfaceMesh &       interfaces,
           const std::vector<Vector> & points,
           Monitor &                   monitor,
           CurvingReport &             report)
{
  const auto          candidates = FindInterfaceEdges(indicators, exterior, interfaces, points);
  std::vector<char>   hasPlace(candidates.size(), 0);
  std::vector<Vector> places(candidates.size());
  ParallelFor(candidates.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
    {
      places[e] = 0.5 * (points[candidates[e].ends[0]] + points[candidates[e].ends[1]]);
      hasPlace[e] = PlaceOnInterface(indicators, points, candidates[e], places[e]);
    }
  });
  CurvedEdges edges;
  for (std::size_t e = 0; e < candidates.size(); ++e)
  {
    if (hasPlace[e])
    {
      edges.push_back({ candidates[e].ends, places[e] });
    }
  }
  monitor.Report(0.5);
  report.edges = candidates.size();
  report.withoutPlace = candidates.size() - edges.size();
  report.inverting = StraightenInvertingEdges(mesh.tetrahedra, points, edges);
  monitor.Report(0.9);
  Measure(mesh, points, edges, report);
  return edges;
}
} // namespace mmm
