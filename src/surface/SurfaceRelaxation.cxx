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
#include "surface/SurfaceRelaxation.h"

#include "mesh/Incidence.h"
#include "base/Parallel.h"
#include "base/Shortened.h"
#include "surface/SurfaceConnectivity.h"
#include "surface/SurfaceParameters.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 1024;

using Parameters = SurfaceRelaxationParameters;

void
SweepCentroids(const IndicatorSet &          indicators,
               const std::vector<Triangle> & triangles,
               const Incidence &             fans,
               const std::vector<float> &    sizes,
               ParticleSet &                 particles)
{
  std::vector<Vector> next(particles.positions);
  ParallelFor(particles.Size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      const Cell & cell = particles.CellOf(p);
      if (cell.Dimension() != 2)
      {
        continue;
      }
      Vector sum = Vector::Zero();
      double weights = 0.0;
      for (auto t = fans.Begin(p); t != fans.End(p); ++t)
      {
        const auto &   triangle = triangles[*t];
        const Vector & a = particles.positions[triangle[0]];
        const Vector & b = particles.positions[triangle[1]];
        const Vector & c = particles.positions[triangle[2]];
        const double   h = (sizes[triangle[0]] + sizes[triangle[1]] + sizes[triangle[2]]) / 3.0;
        const double   area = (b - a).cross(c - a).norm();
        const double   weight = area / h;
        sum += weight * (a + b + c) / 3.0;
        weights += weight;
      }
      if (!(weights > 0.0))
      {
        continue;
      }
      Vector       x = particles.positions[p];
      const Vector step = Shortened(sum / weights - x, Parameters::LongestCentroidMove * sizes[p]);
      const Vector normal = indicators.Normal(cell, x);
      x += step - normal * normal.dot(step);
      if (indicators.ProjectWhereMaximal(cell, x, Parameters::Reach * sizes[p]))
      {
        next[p] = x;
      }
    }
  });
  particles.positions.swap(next);
}

struct Edge
{
  double  length; // in units of h
  PointId a;
  PointId b;
};

/** The edges of the interfaces that are too long or too short, the worst first. */
std::vector<Edge>
CollectOffEdges(const std::vector<Triangle> & triangles,
                const std::vector<float> &    sizes,
                const ParticleSet &           particles)
{
  std::vector<Edge> edges;
  for (const auto & triangle : triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      const PointId a = std::min(triangle[c], triangle[(c + 1) % 3]);
      const PointId b = std::max(triangle[c], triangle[(c + 1) % 3]);
      const double  length =
        (particles.positions[a] - particles.positions[b]).norm() / (0.5 * (double(sizes[a]) + sizes[b]));
      if (length > Parameters::LongEdge || length < Parameters::ShortEdge)
      {
        edges.push_back({ length, a, b });
      }
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge & x, const Edge & y) {
    const double offX = std::abs(std::log(std::max(x.length, 1e-9)));
    const double offY = std::abs(std::log(std::max(y.length, 1e-9)));
    return offX != offY ? offX > offY : (x.a != y.a ? x.a < y.a : x.b < y.b);
  });
  return edges;
}

/** The cell that an edge between two particles runs on, a surface or a curve: the one that both lie on or bound. */
bool
CommonCell(const IndicatorSet & indicators, const Cell & a, const Cell & b, Cell & common)
{
  common.count = 0;
  int planes = 0;
  for (const Material m : a)
  {
    if (b.Has(m))
    {
      common.materials[common.count++] = m;
      planes += indicators.IsPlane(m);
    }
  }
  return (common.count == 2 || common.count == 3) && planes < common.count;
}

std::size_t
AdaptToEdges(const IndicatorSet &          indicators,
             const std::vector<Triangle> & triangles,
             const Incidence &             fans,
             const std::vector<float> &    sizes,
             ParticleSet &                 particles)
{
  const std::size_t count = particles.Size();
  std::vector<char> touched(count, 0);
  std::vector<char> kept(count, 1);
  std::size_t       changes = 0;
  // one change a neighbourhood: what it does to the others shows in the next triangulation
  const auto touchAround = [&](PointId p) {
    for (auto t = fans.Begin(p); t != fans.End(p); ++t)
    {
      for (const auto corner : triangles[*t])
      {
        touched[corner] = 1;
      }
    }
  };
  for (const Edge & edge : CollectOffEdges(triangles, sizes, particles))
  {
    if (touched[edge.a] || touched[edge.b])
    {
      continue;
    }
    const Cell & cellA = particles.CellOf(edge.a);
    const Cell & cellB = particles.CellOf(edge.b);
    if (edge.length < Parameters::ShortEdge)
    {
      // the one on the surface goes; two on junctions stay
      const PointId gone = cellB.Dimension() == 2 ? edge.b : edge.a;
      if (particles.CellOf(gone).Dimension() == 2)
      {
        kept[gone] = 0;
        touchAround(gone);
        ++changes;
      }
      continue;
    }
    Cell common;
    if (!CommonCell(indicators, cellA, cellB, common))
    {
      continue;
    }
    const auto known = std::find(particles.cellTable.begin(), particles.cellTable.end(), common);
    Vector     x = 0.5 * (particles.positions[edge.a] + particles.positions[edge.b]);
    if (known != particles.cellTable.end() &&
        indicators.ProjectWhereMaximal(common, x, Parameters::Reach * sizes[edge.a]))
    {
      particles.positions.push_back(x);
      particles.cells.push_back(std::uint32_t(known - particles.cellTable.begin()));
      touchAround(edge.a);
      touchAround(edge.b);
      ++changes;
    }
  }
  particles.Keep(kept);
  return changes;
}
} // namespace

std::size_t
RelaxOnSurface(const IndicatorSet &  indicators,
               const SizingField &   sizing,
               const InterfaceMesh & interfaces,
               int                   sweeps,
               bool                  adapt,
               ParticleSet &         particles)
{
  std::vector<float> sizes(particles.Size());
  ParallelFor(sizes.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
    {
      sizes[p] = float(sizing(particles.positions[p]));
    }
  });
  SurfaceConnectivity connectivity(interfaces, particles.positions);
  const auto &        triangles = connectivity.Triangles();
  const auto          fansOf = [&]() {
    return Incidence(
      particles.Size(), triangles.size(), [&](std::size_t t) -> const Triangle & { return triangles[t]; });
  };
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    connectivity.EqualizeValences(particles.positions);
    SweepCentroids(indicators, triangles, fansOf(), sizes, particles);
  }
  return adapt ? AdaptToEdges(indicators, triangles, fansOf(), sizes, particles) : 0;
}
} // namespace mmm
