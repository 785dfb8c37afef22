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
#include "optimize/EdgeRemover.h"

#include "optimize/ShapeQuality.h"

#include <algorithm>

namespace mmm
{
using Id = OptimizerState::Id;


/** The best triangulation of a polygon around the edge ab: each triangle makes a tetrahedron with a and one with b.
 * Returns the worst quality, and appends the triangles. */
double
EdgeRemover::TriangulateLink(const std::vector<PointId> & polygon,
                             PointId                      a,
                             PointId                      b,
                             Material                     material,
                             double                       enough,
                             std::vector<Triangle> &      triangles) const
{
  constexpr int LongestRing = OptimizationParameters::LongestRing;
  const int     n = int(polygon.size());
  double        best[LongestRing + 1][LongestRing + 1];
  int           middle[LongestRing + 1][LongestRing + 1];
  for (int i = 0; i + 1 < n; ++i)
  {
    best[i][i + 1] = BestQuality;
  }
  for (int length = 2; length < n; ++length)
  {
    for (int i = 0; i + length < n; ++i)
    {
      const int k = i + length;
      best[i][k] = WorstQuality;
      middle[i][k] = i + 1;
      for (int j = i + 1; j < k; ++j)
      {
        double q = std::min(best[i][j], best[j][k]);
        if (q > best[i][k] && q > enough)
        {
          q = std::min(q, m_State.Quality({ { polygon[i], polygon[j], polygon[k], b } }, material));
          if (q > best[i][k])
          {
            q = std::min(q, m_State.Quality({ { polygon[k], polygon[j], polygon[i], a } }, material));
          }
        }
        if (q > best[i][k])
        {
          best[i][k] = q;
          middle[i][k] = j;
        }
      }
    }
  }
  std::vector<std::pair<int, int>> stack{ { 0, n - 1 } };
  while (!stack.empty())
  {
    const auto span = stack.back();
    stack.pop_back();
    if (span.second - span.first < 2)
    {
      continue;
    }
    const int j = middle[span.first][span.second];
    triangles.push_back({ { polygon[span.first], polygon[j], polygon[span.second] } });
    stack.push_back({ span.first, j });
    stack.push_back({ j, span.second });
  }
  return best[0][n - 1];
}

/** Takes the edge ab out: the tetrahedra around it are replaced by two for each triangle of their link. On an
 * interface of two materials the surface's edge is flipped, from ab to the link's two points on the interface. */
bool
EdgeRemover::FindForEdge(Id t, PointId a, PointId b, ComplexChange & change)
{
  m_State.complex.GetRing(t, a, b, m_Ring);
  const double before = m_State.WorstOf(m_Ring.tetrahedra);
  const bool   mayFlip = before < QualityOfAngle(m_State.parameters.poorAngle);
  return this->ReplaceRing(a,
                           b,
                           before + OptimizationParameters::LeastGain,
                           mayFlip ? OptimizerState::TriangleFloor(before) : OptimizerState::Unreachable,
                           change);
}

bool
EdgeRemover::FindForTriangles(Id t, PointId a, PointId b, ComplexChange & change)
{
  m_State.complex.GetRing(t, a, b, m_Ring);
  const double before = m_State.WorstOf(m_Ring.tetrahedra);
  return this->ReplaceRing(a, b, m_State.EnoughBesideTriangles(before), 1.0, change);
}

/** The new tetrahedra have to be better than `enough`. An interface edge is flipped if the worse of its triangles gets
 * better, or is at least as good as `floor`. */
bool
EdgeRemover::ReplaceRing(PointId a, PointId b, double enough, double floor, ComplexChange & change)
{
  const auto & ring = m_Ring.tetrahedra;
  const int    count = int(ring.size());
  if (count > OptimizationParameters::LongestRing - 2 || (m_Ring.closed && count < 3) || enough < 0.5 * InvertedQuality)
  {
    return false;
  }
  // the link turns counterclockwise as seen from b, or the other way round: find out
  std::vector<PointId>  link = m_Ring.link;
  std::vector<Material> materials;
  for (const Id r : ring)
  {
    materials.push_back(m_State.complex.MaterialOf(r));
  }
  if (TetrahedronVolume(m_State.points[a], m_State.points[b], m_State.points[link[0]], m_State.points[link[1]]) < 0.0)
  {
    std::swap(a, b);
  }
  // link point n lies between tetrahedra n - 1 and n: there is an interface where their materials differ
  std::vector<int> cuts;
  if (m_Ring.closed)
  {
    for (int n = 0; n < count; ++n)
    {
      if (materials[n] != materials[(n + count - 1) % count])
      {
        cuts.push_back(n);
      }
    }
  }
  else
  {
    cuts = { 0, count };
    for (int n = 1; n < count; ++n)
    {
      if (materials[n] != materials[n - 1])
      {
        return false;
      }
    }
  }
  change.fresh.clear();
  change.beside.clear();
  std::vector<Triangle> triangles;
  double                after = BestQuality;
  const auto            add = [&](const std::vector<PointId> & polygon, Material material) {
    if (polygon.size() < 3)
    {
      after = WorstQuality;
      return;
    }
    triangles.clear();
    after = std::min(after, this->TriangulateLink(polygon, a, b, material, enough, triangles));
    for (const auto & triangle : triangles)
    {
      change.fresh.push_back({ { { triangle[0], triangle[1], triangle[2], b } }, material });
      change.fresh.push_back({ { { triangle[2], triangle[1], triangle[0], a } }, material });
    }
  };
  if (cuts.empty())
  {
    add(link, materials[0]);
  }
  else if (cuts.size() == 2 && floor < OptimizerState::Unreachable)
  {
    const PointId  c = link[cuts[0]];
    const PointId  d = link[cuts[1]];
    const Material one = materials[cuts[0]];
    const Material two = m_Ring.closed ? materials[cuts[1] % count] : m_State.exterior;
    if (!this->MayFlip(a, b, c, d, one, two, floor) || (!m_Ring.closed && this->AreNeighbours(c, d)))
    {
      return false;
    }
    change.beside = { c };
    add(std::vector<PointId>(link.begin() + cuts[0], link.begin() + cuts[1] + 1), one);
    if (m_Ring.closed && after > enough)
    {
      std::vector<PointId> polygon(link.begin() + cuts[1], link.end());
      polygon.insert(polygon.end(), link.begin(), link.begin() + cuts[0] + 1);
      add(polygon, two);
    }
  }
  else
  {
    return false;
  }
  if (!(after > enough))
  {
    return false;
  }
  change.kind = cuts.empty() ? ComplexChange::Kind::Flip : ComplexChange::Kind::InterfaceFlip;
  change.old = ring;
  change.centre = { a, b };
  return true;
}

bool
EdgeRemover::AreNeighbours(PointId p, PointId q)
{
  m_State.complex.GetStar(p, m_Star);
  return std::any_of(m_Star.begin(), m_Star.end(), [&](Id t) {
    const auto & corners = m_State.complex.Corners(t);
    return std::find(corners.begin(), corners.end(), q) != corners.end();
  });
}

/** Whether the edge ab of an interface may become cd. */
bool
EdgeRemover::MayFlip(PointId a, PointId b, PointId c, PointId d, Material one, Material two, double floor) const
{
  const Vector & pa = m_State.points[a];
  const Vector & pb = m_State.points[b];
  const Vector & pc = m_State.points[c];
  const Vector & pd = m_State.points[d];
  const double   was = m_State.DistanceToInterface(one, two, 0.5 * (pa + pb), a);
  const double   is = m_State.DistanceToInterface(one, two, 0.5 * (pc + pd), c);
  if (is > std::max(was, m_State.parameters.interfaceTolerance))
  {
    return false;
  }
  // no fold, and no worse triangles than are allowed
  const Vector n1 = (pb - pa).cross(pc - pa);
  const Vector n2 = (pd - pa).cross(pb - pa);
  const Vector m1 = (pd - pa).cross(pc - pa);
  const Vector m2 = (pc - pb).cross(pd - pb);
  if (m1.dot(m2) <= 0.0 || m1.dot(n1 + n2) <= 0.0 || m2.dot(n1 + n2) <= 0.0)
  {
    return false;
  }
  const double worstBefore = std::min(TriangleRadiusRatio(pa, pb, pc), TriangleRadiusRatio(pa, pb, pd));
  const double worstAfter = std::min(TriangleRadiusRatio(pa, pc, pd), TriangleRadiusRatio(pb, pc, pd));
  return worstAfter >= std::min(worstBefore + OptimizationParameters::LeastGain, floor);
}

bool
EdgeRemover::FindForFace(Id t, int face, ComplexChange & change) const
{
  if (m_State.complex.IsInterface(t, face))
  {
    return false;
  }
  const Id      other = m_State.complex.Neighbour(t, face);
  const auto    corners = m_State.complex.Corners(t);
  const PointId top = corners[face];
  PointId       bottom = top;
  for (const auto corner : m_State.complex.Corners(other))
  {
    if (std::find(corners.begin(), corners.end(), corner) == corners.end())
    {
      bottom = corner;
    }
  }
  const double before = std::min(m_State.Quality(t), m_State.Quality(other));
  change.fresh.clear();
  change.centre.clear();
  change.beside.clear();
  for (int c = 0; c < 3; ++c)
  {
    const PointId     u = corners[TetrahedronFaces[face][c]];
    const PointId     v = corners[TetrahedronFaces[face][(c + 1) % 3]];
    const Tetrahedron candidate{ { u, v, bottom, top } };
    if (!(m_State.Quality(candidate, m_State.complex.MaterialOf(t)) > before + OptimizationParameters::LeastGain))
    {
      return false;
    }
    change.fresh.push_back({ candidate, m_State.complex.MaterialOf(t) });
    change.centre.push_back(u);
  }
  change.kind = ComplexChange::Kind::Flip;
  change.old = { t, other };
  return true;
}

bool
EdgeRemover::FindAny(Id t, ComplexChange & change)
{
  const Tetrahedron corners = m_State.complex.Corners(t);
  for (const auto & edge : TetrahedronEdges)
  {
    if (this->FindForEdge(t, corners[edge[0]], corners[edge[1]], change))
    {
      return true;
    }
  }
  for (int f = 0; f < 4; ++f)
  {
    if (this->FindForFace(t, f, change))
    {
      return true;
    }
  }
  return false;
}
} // namespace mmm
