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
#include "mmmEdgeCollapser.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
using Id = OptimizerState::Id;
using Element = OptimizerState::Element;

/** The materials around a point, sorted, with the exterior where it lies on the outside of the mesh. */
std::vector<Material>
EdgeCollapser::MaterialsAround(PointId p, const std::vector<Id> & star) const
{
  std::vector<Material> around;
  for (const Id t : star)
  {
    around.push_back(m_State.complex.MaterialOf(t));
    for (int f = 0; f < 4; ++f)
    {
      if (m_State.complex.Corners(t)[f] != p && m_State.complex.Neighbour(t, f) == NoTetrahedron)
      {
        around.push_back(m_State.exterior);
      }
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

bool
EdgeCollapser::Collapse(Id t, PointId u, PointId v)
{
  m_State.complex.GetStar(u, m_Star);
  const double before = m_State.WorstOf(m_Star);
  return this->CollapseStar(t, u, v, before + OptimizerState::LeastGain, OptimizerState::TriangleFloor(before));
}

bool
EdgeCollapser::CollapseForTriangles(Id t, PointId u, PointId v, double radiusRatio)
{
  m_State.complex.GetStar(u, m_Star);
  return this->CollapseStar(t, u, v, m_State.EnoughBesideTriangles(m_State.WorstOf(m_Star)), radiusRatio);
}

/** All new tetrahedra have to be better than `enough`, triangles at least as good as `floor`. */
bool
EdgeCollapser::CollapseStar(Id t, PointId u, PointId v, double enough, double floor)
{
  if (m_Star.size() > 60)
  {
    return false;
  }
  const auto aroundU = this->MaterialsAround(u, m_Star);
  if (aroundU.size() > 2)
  {
    return false; // on a junction
  }
  if (aroundU.size() == 2)
  {
    const auto & cells = m_State.constraint.Cells();
    if (u >= cells.size() || cells[u].Dimension() != 2 || v >= cells.size() || !cells[v].Includes(cells[u]) ||
        !this->MayCollapseOnInterface(t, u, v, aroundU, floor))
    {
      return false;
    }
  }
  std::vector<Element> fresh;
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
    fresh.push_back({ corners, m_State.complex.MaterialOf(s) });
  }
  if (!this->LinksMeetInRing(t, u, v))
  {
    return false;
  }
  const std::vector<Id> old = m_Star;
  m_State.complex.Replace(old, fresh, m_Ids);
  ++m_State.report.collapses;
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
    std::sort(link.begin(), link.end());
    link.erase(std::unique(link.begin(), link.end()), link.end());
    return link;
  };
  const auto        ofU = linkOf(u, m_Star);
  const auto        ofV = linkOf(v, m_OtherStar);
  std::vector<Edge> common;
  std::set_intersection(ofU.begin(), ofU.end(), ofV.begin(), ofV.end(), std::back_inserter(common));
  return common.size() == m_Ring.link.size() + m_Ring.tetrahedra.size();
}

/** Whether point u of a surface may slide into v: the edge lies on the surface, the surface's own links meet in two
 * points only, and its new triangles are good, unfolded and near the zero set. */
bool
EdgeCollapser::MayCollapseOnInterface(Id t, PointId u, PointId v, const std::vector<Material> & materials, double floor)
{
  m_State.complex.GetRing(t, u, v, m_Ring);
  int       cuts = m_Ring.closed ? 0 : 2;
  const int count = int(m_Ring.tetrahedra.size());
  for (int n = m_Ring.closed ? 0 : 1; n < count; ++n)
  {
    cuts += m_State.complex.MaterialOf(m_Ring.tetrahedra[n]) !=
            m_State.complex.MaterialOf(m_Ring.tetrahedra[(n + count - 1) % count]);
  }
  if (cuts != 2)
  {
    return false;
  }
  const auto fanPoints = [&](PointId p, const std::vector<Id> & star, std::vector<std::array<PointId, 2>> * fan) {
    std::vector<PointId> points;
    for (const Id s : star)
    {
      for (int f = 0; f < 4; ++f)
      {
        const auto & corners = m_State.complex.Corners(s);
        const Id     other = m_State.complex.Neighbour(s, f);
        if (corners[f] == p || !m_State.complex.IsInterface(s, f) ||
            (other != NoTetrahedron && m_State.complex.MaterialOf(other) < m_State.complex.MaterialOf(s)))
        {
          continue;
        }
        PointId face[3];
        for (int c = 0; c < 3; ++c)
        {
          face[c] = corners[TetrahedronFaces[f][c]];
        }
        for (int c = 0; c < 3; ++c)
        {
          if (face[c] == p)
          {
            points.push_back(face[(c + 1) % 3]);
            points.push_back(face[(c + 2) % 3]);
            if (fan)
            {
              fan->push_back({ { face[(c + 1) % 3], face[(c + 2) % 3] } });
            }
          }
        }
      }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  };
  m_State.complex.GetStar(v, m_OtherStar);
  std::vector<std::array<PointId, 2>> fan;
  const auto                          ofU = fanPoints(u, m_Star, &fan);
  const auto                          ofV = fanPoints(v, m_OtherStar, nullptr);
  std::vector<PointId>                common;
  std::set_intersection(ofU.begin(), ofU.end(), ofV.begin(), ofV.end(), std::back_inserter(common));
  if (common.size() != 2)
  {
    return false;
  }
  for (const auto & edge : fan)
  {
    if (edge[0] == v || edge[1] == v)
    {
      continue;
    }
    const Vector & p = m_State.points[edge[0]];
    const Vector & q = m_State.points[edge[1]];
    const Vector   before = (p - m_State.points[u]).cross(q - m_State.points[u]);
    const Vector   after = (p - m_State.points[v]).cross(q - m_State.points[v]);
    if (before.dot(after) <= 0.5 * before.norm() * after.norm() ||
        TriangleRadiusRatio(m_State.points[v], p, q) < floor ||
        m_State.DistanceToInterface(materials[0], materials[1], (p + q + m_State.points[v]) / 3.0, edge[0]) >
          m_State.parameters.interfaceTolerance)
    {
      return false;
    }
  }
  return true;
}
} // namespace mmm
