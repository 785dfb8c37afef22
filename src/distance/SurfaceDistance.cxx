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
#include "distance/SurfaceDistance.h"

#include "base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t RowGrain = 8;
constexpr std::size_t TriangleGrain = 256;
/** How far from a sheet of the surface it is asked what is behind it, in units of the grid. */
constexpr double SheetDepth = 1e-3;
/** Triangles with longer edges, in units of the grid, may be boundary between their corners and middle only. */
constexpr double LongestUniform = 2.0;

std::vector<TriangleTree::Corners>
CornersOf(const TriangleSurface & surface)
{
  std::vector<TriangleTree::Corners> corners;
  corners.reserve(surface.triangles.size());
  for (const auto & [a, b, c] : surface.triangles)
  {
    corners.push_back({ { surface.points[a], surface.points[b], surface.points[c] } });
  }
  return corners;
}

bool
IsInside(double winding)
{
  return std::abs(winding) > 0.5;
}

bool
AcceptAll(std::uint32_t)
{
  return true;
}
} // namespace

/** The nodes of a row along the first axis, and what is known of them. */
struct SurfaceDistance::Row
{
  Index               start;
  std::vector<double> distances;
  std::vector<double> windings;
  double              doubt{ 0.0 };
  std::size_t         doubted{ 0 };
  double              lowest{ 0.0 };
  double              highest{ 0.0 };
};

SurfaceDistance::SurfaceDistance(const TriangleSurface & surface, const SurfaceDefects & defects)
  : m_IsClosed(defects.boundaryEdges == 0)
  , m_IsBranching(defects.branchingEdges > 0)
  , m_Tree(CornersOf(surface))
  , m_Winding(m_Tree)
{}

void
SurfaceDistance::ComputeRow(const Grid & grid, double band, Row & row) const
{
  const double step = grid.spacing[0];
  Index        at = row.start;
  for (int i = 0; i < grid.size[0]; ++i)
  {
    at[0] = i;
    const Vector x = grid.Position(at);
    // a step changes the distance by no more than its length
    const double reach = i == 0 ? band : std::min(band, row.distances.back() + 1.001 * step);
    const auto   nearest = m_Tree.FindNearest(x, reach, AcceptAll);
    // where there is no surface between a node and the last one, both are on the same side
    const bool isSame = m_IsClosed && i > 0 && row.distances.back() > step;
    row.windings.push_back(isSame ? row.windings.back() : m_Winding.At(x));
    row.distances.push_back(std::min(nearest.distance, band));
    if (!isSame && nearest.distance < band && nearest.distance > 0.0)
    {
      const double winding = row.windings.back();
      row.doubt += std::abs(winding - std::round(winding));
      ++row.doubted;
      row.lowest = std::min(row.lowest, winding);
      row.highest = std::max(row.highest, winding);
    }
  }
}

bool
SurfaceDistance::IsBoundary(const Vector & point, const Vector & across) const
{
  const double length = across.norm();
  if (length == 0.0)
  {
    return true;
  }
  const Vector depth = across * (SheetDepth / length);
  return IsInside(m_Winding.At(point - depth)) != IsInside(m_Winding.At(point + depth));
}

SurfaceDistance::Kind
SurfaceDistance::FindKind(std::uint32_t triangle) const
{
  const auto & [a, b, c] = m_Tree.GetTriangle(triangle);
  const Vector normal = (b - a).cross(c - a);
  if (std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() }) > LongestUniform || normal.norm() == 0.0)
  {
    return Kind::InPart;
  }
  const Vector middle = (a + b + c) / 3.0;
  int          count = 0;
  for (const Vector & place : { middle, a, b, c })
  {
    // not on other triangles
    count += this->IsBoundary(0.9 * place + 0.1 * middle, normal);
  }
  return count == 0 ? Kind::Nowhere : count == 4 ? Kind::Everywhere : Kind::InPart;
}

void
SurfaceDistance::CorrectRow(const Grid & grid, double band, const std::vector<Kind> & kinds, Row & row) const
{
  Index at = row.start;
  for (int i = 0; i < grid.size[0]; ++i)
  {
    at[0] = i;
    if (row.distances[i] < band)
    {
      const Vector x = grid.Position(at);
      const auto   nearest = m_Tree.FindNearest(
        x,
        band,
        [&](std::uint32_t t) { return kinds[t] != Kind::Nowhere; },
        [&](std::uint32_t t, const Vector & point) {
          return kinds[t] == Kind::Everywhere || this->IsBoundary(point, point - x);
        });
      row.distances[i] = nearest.distance;
    }
  }
}

std::vector<float>
SurfaceDistance::Compute(const Grid & grid, double band, Monitor & monitor)
{
  // where a hole is closed, values grow about as distances do in holes of half this width
  const double perWinding = 2.0 * band;

  const auto       numberOfRows = std::size_t(grid.size[1]) * grid.size[2];
  std::vector<Row> rows(numberOfRows);
  ParallelFor(numberOfRows, RowGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r)
    {
      rows[r].start = { { 0, int(r % grid.size[1]), int(r / grid.size[1]) } };
      this->ComputeRow(grid, band, rows[r]);
    }
  });
  monitor.Report(0.6);

  double      doubt = 0.0;
  std::size_t doubted = 0;
  double      lowest = 0.0;
  double      highest = 0.0;
  for (const Row & row : rows)
  {
    doubt += row.doubt;
    doubted += row.doubted;
    lowest = std::min(lowest, row.lowest);
    highest = std::max(highest, row.highest);
  }
  m_Doubt = doubted > 0 ? doubt / doubted : 0.0;
  m_HasOverlaps = std::max(highest, -lowest) > 1.5 || (highest > 0.5 && lowest < -0.5);
  if (m_HasOverlaps || m_IsBranching)
  {
    std::vector<Kind> kinds(m_Tree.GetOrder().size());
    ParallelFor(kinds.size(), TriangleGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        kinds[t] = this->FindKind(static_cast<std::uint32_t>(t));
      }
    });
    monitor.Report(0.8);
    ParallelFor(numberOfRows, RowGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r)
      {
        this->CorrectRow(grid, band, kinds, rows[r]);
      }
    });
  }

  std::vector<float> values;
  values.reserve(grid.NumberOfNodes());
  for (const Row & row : rows)
  {
    for (std::size_t i = 0; i < row.distances.size(); ++i)
    {
      const double depth = std::abs(row.windings[i]) - 0.5;
      const double distance = m_IsClosed ? row.distances[i] : std::min(row.distances[i], perWinding * std::abs(depth));
      values.push_back(static_cast<float>(depth > 0.0 ? distance : -distance));
    }
  }
  monitor.Report(1.0);
  return values;
}
} // namespace mmm
