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
#include "optimize/EdgeCollapser.h"
#include "base/MakeUnique.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
using Id = OptimizerState::Id;

bool
EdgeCollapser::FindAny(Id t, ComplexChange & change)
{
  const Tetrahedron corners = m_State.complex.Corners(t);
  for (const PointId u : corners)
  {
    if (!this->LookAround(u))
    {
      continue;
    }
    const double before = m_State.WorstOf(m_Star);
    const double floor = OptimizerState::TriangleFloor(before);
    for (const PointId v : corners)
    {
      if (v != u && this->MayCollapse(t, u, v, floor) &&
          this->CollapseStar(t, u, v, before + OptimizationParameters::LeastGain, change))
      {
        return true;
      }
    }
  }
  return false;
}

bool
EdgeCollapser::FindForTriangles(Id                           t,
                                const std::vector<PointId> & corners,
                                double                       radiusRatio,
                                double                       quality,
                                ComplexChange &              change)
{
  for (const PointId u : corners)
  {
    const auto mayGoTo = [&](PointId v) { return v != u && this->MayBeOnCellOf(u, v); };
    if (std::none_of(corners.begin(), corners.end(), mayGoTo) || !this->LookAround(u))
    {
      continue;
    }
    for (const PointId v : corners)
    {
      // the tetrahedra take longest to judge, and it is triangles that fail most often
      if (mayGoTo(v) && this->MayCollapse(t, u, v, radiusRatio) &&
          this->CollapseStar(
            t, u, v, std::max(quality, m_State.EnoughBesideTriangles(m_State.WorstOf(m_Star))), change))
      {
        return true;
      }
    }
  }
  return false;
}

bool
EdgeCollapser::FindForEdge(Id t, PointId u, PointId v, double radiusRatio, double quality, ComplexChange & change)
{
  return this->LookAround(u) && this->MayCollapse(t, u, v, radiusRatio) &&
         this->CollapseStar(t, u, v, std::min(quality, m_State.WorstOf(m_Star)), change);
}

/** Finds what is around u. Returns false where that is too much for u to go anywhere. */
bool
EdgeCollapser::LookAround(PointId u)
{
  m_State.complex.GetStar(u, m_Star);
  m_NumberOfMaterials = this->CountMaterialsAround(u);
  if (m_Star.size() > OptimizationParameters::LargestStar || m_NumberOfMaterials > 3)
  {
    return false;
  }
  m_Fan = m_NumberOfMaterials > 1 ? this->FanOf(u, m_Star) : std::vector<FanTriangle>();
  return true;
}

/** How many materials are in the star of u, with the exterior where it lies on the outside of the mesh. */
std::size_t
EdgeCollapser::CountMaterialsAround(PointId u) const
{
  std::vector<Material> around;
  const auto            add = [&around](Material m) {
    if (std::find(around.begin(), around.end(), m) == around.end())
    {
      around.push_back(m);
    }
  };
  for (const Id t : m_Star)
  {
    add(m_State.complex.MaterialOf(t));
    for (int f = 0; f < 4; ++f)
    {
      if (m_State.complex.Corners(t)[f] != u && m_State.complex.Neighbour(t, f) == NoTetrahedron)
      {
        add(m_State.exterior);
      }
    }
  }
  return around.size();
}

/** Whether the interfaces around u let it go to v, with triangles at least as good as `floor`. */
bool
EdgeCollapser::MayCollapse(Id t, PointId u, PointId v, double floor)
{
  return m_NumberOfMaterials == 1 || (this->IsOnCellOf(u, v) && this->MayCollapseOnInterface(t, u, v, floor));
}

/** All new tetrahedra have to be better than `enough`. */
bool
EdgeCollapser::CollapseStar(Id t, PointId u, PointId v, double enough, ComplexChange & change)
{
  change.fresh.clear();
  for (const Id s : m_Star)
  {
    Tetrahedron corners = m_State.complex.Corners(s);
    if (std::find(corners.begin(), corners.end(), v) != corners.end())
    {
      continue;
    }
    std::replace(corners.begin(), corners.end(), u, v);
    if (!(m_State.Quality(corners, m_State.complex.MaterialOf(s)) > enough))
    {
      return false;
    }
    change.fresh.push_back({ corners, m_State.complex.MaterialOf(s) });
  }
  if (!this->LinksMeetInRing(t, u, v))
  {
    return false;
  }
  change.kind = ComplexChange::Kind::Collapse;
  change.old = m_Star;
  change.centre = { u };
  change.beside = { v };
  return true;
}

/** The link condition: the points and edges that lie opposite both u and v are those of the ring around uv. */
bool
EdgeCollapser::LinksMeetInRing(Id t, PointId u, PointId v)
{
  m_State.complex.GetRing(t, u, v, m_Ring);
  m_State.complex.GetStar(v, m_OtherStar);
  using Edge = std::array<PointId, 2>;
  const auto linkOf = [&](PointId p, const std::vector<Id> & star) {
    std::vector<Edge> link; // a point is listed as an edge to itself
    for (const Id s : star)
    {
      const auto & corners = m_State.complex.Corners(s);
      for (int a = 0; a < 4; ++a)
      {
        for (int b = a; b < 4; ++b)
        {
          if (corners[a] != p && corners[b] != p)
          {
            link.push_back({ { std::min(corners[a], corners[b]), std::max(corners[a], corners[b]) } });
          }
        }
      }
    }
    MakeUnique(link);
    return link;
  };
  const auto        ofU = linkOf(u, m_Star);
  const auto        ofV = linkOf(v, m_OtherStar);
  std::vector<Edge> common;
  std::set_intersection(ofU.begin(), ofU.end(), ofV.begin(), ofV.end(), std::back_inserter(common));
  return common.size() == m_Ring.link.size() + m_Ring.tetrahedra.size();
}

/** Whether u, where some materials meet, lies on a surface or a curve of as many, which v is on or at the end of. What
 * is no particle has joined a surface, on which the edge then runs. */
bool
EdgeCollapser::IsOnCellOf(PointId u, PointId v) const
{
  const auto & cells = m_State.constraint.Cells();
  return m_NumberOfMaterials == (u < cells.size() ? cells[u].count : 2) && this->MayBeOnCellOf(u, v);
}

/** Whether v is on the cell of u or at its end, whatever materials are around u. */
bool
EdgeCollapser::MayBeOnCellOf(PointId u, PointId v) const
{
  const auto & cells = m_State.constraint.Cells();
  return v < cells.size() && (u >= cells.size() || cells[v].Includes(cells[u]));
}

/** The triangles of interfaces around p, by their corners besides p. */
std::vector<EdgeCollapser::FanTriangle>
EdgeCollapser::FanOf(PointId p, const std::vector<Id> & star) const
{
  std::vector<FanTriangle> fan;
  for (const Id s : star)
  {
    const auto &   corners = m_State.complex.Corners(s);
    const Material own = m_State.complex.MaterialOf(s);
    for (int f = 0; f < 4; ++f)
    {
      const Id       other = m_State.complex.Neighbour(s, f);
      const Material beyond = other == NoTetrahedron ? m_State.exterior : m_State.complex.MaterialOf(other);
      // each once, from the side of the lower material
      if (corners[f] == p || !m_State.complex.IsInterface(s, f) || (other != NoTetrahedron && beyond < own))
      {
        continue;
      }
      const auto & face = TetrahedronFaces[f];
      const int    at = corners[face[0]] == p ? 0 : (corners[face[1]] == p ? 1 : 2);
      fan.push_back({ corners[face[(at + 1) % 3]], corners[face[(at + 2) % 3]], own, beyond });
    }
  }
  return fan;
}

/** The ends of the edges from a point that the triangles of a fan have; with `onCurves` those of the edges where three
 * sheets or more meet. */
std::vector<PointId>
EdgeCollapser::EndsOf(const std::vector<FanTriangle> & fan, bool onCurves)
{
  std::vector<PointId> ends;
  for (const auto & triangle : fan)
  {
    ends.push_back(triangle.b);
    ends.push_back(triangle.c);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<PointId> result;
  for (auto first = ends.begin(); first != ends.end();)
  {
    const auto last = std::upper_bound(first, ends.end(), *first);
    if (!onCurves || last - first > 2)
    {
      result.push_back(*first);
    }
    first = last;
  }
  return result;
}

/** Whether point u of a surface or a curve may slide along it into v. The edge has to lie on all sheets at u; u and v
 * share no other points of sheets, no edges opposite them, and no other points of curves (the link condition). No
 * triangle may turn over, get too flat, or leave the zero set. */
bool
EdgeCollapser::MayCollapseOnInterface(Id t, PointId u, PointId v, double floor)
{
  const int materials = int(m_NumberOfMaterials);
  m_State.complex.GetRing(t, u, v, m_Ring);
  int       cuts = m_Ring.closed ? 0 : 2;
  const int count = int(m_Ring.tetrahedra.size());
  for (int n = m_Ring.closed ? 0 : 1; n < count; ++n)
  {
    cuts += m_State.complex.MaterialOf(m_Ring.tetrahedra[n]) !=
            m_State.complex.MaterialOf(m_Ring.tetrahedra[(n + count - 1) % count]);
  }
  if (cuts != materials)
  {
    return false;
  }
  const Vector & x = m_State.points[u];
  const Vector & y = m_State.points[v];
  const auto     isNear = [&](const FanTriangle & triangle, const Vector & place) {
    return m_State.DistanceToInterface(triangle.own, triangle.beyond, place, triangle.b) <=
           m_State.parameters.interfaceTolerance;
  };
  const auto staysGood = [&](const FanTriangle & triangle) {
    if (triangle.b == v || triangle.c == v)
    {
      return true;
    }
    const Vector & p = m_State.points[triangle.b];
    const Vector & q = m_State.points[triangle.c];
    const Vector   before = (p - x).cross(q - x);
    const Vector   after = (p - y).cross(q - y);
    return before.dot(after) > OptimizationParameters::LeastCosineOfCollapse * before.norm() * after.norm() &&
           TriangleRadiusRatio(y, p, q) >= floor && isNear(triangle, (p + q + y) / 3.0) &&
           (materials == 2 || (isNear(triangle, 0.5 * (p + y)) && isNear(triangle, 0.5 * (q + y))));
  };
  // what fails most often comes first
  if (!std::all_of(m_Fan.begin(), m_Fan.end(), staysGood))
  {
    return false;
  }
  m_State.complex.GetStar(v, m_OtherStar);
  const auto otherFan = this->FanOf(v, m_OtherStar);
  const auto countCommon = [&](bool onCurves) {
    const auto           ofU = EndsOf(m_Fan, onCurves);
    const auto           ofV = EndsOf(otherFan, onCurves);
    std::vector<PointId> common;
    std::set_intersection(ofU.begin(), ofU.end(), ofV.begin(), ofV.end(), std::back_inserter(common));
    return int(common.size());
  };
  if (countCommon(false) != materials || (materials > 2 && countCommon(true) > 0))
  {
    return false;
  }
  // two triangles would become one, and what is between them vanish
  const auto isOfU = [&](const FanTriangle & other) {
    return std::any_of(m_Fan.begin(), m_Fan.end(), [&](const FanTriangle & triangle) {
      return std::minmax(triangle.b, triangle.c) == std::minmax(other.b, other.c);
    });
  };
  return std::none_of(otherFan.begin(), otherFan.end(), isOfU);
}
} // namespace mmm
