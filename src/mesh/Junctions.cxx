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
#include "mesh/Junctions.h"

#include "mesh/Incidence.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mmm
{
namespace
{
/** Points of cuts are exactly coplanar but for rounding. */
constexpr double Flatness = 1e-6;

struct JunctionEdge
{
  std::array<PointId, 2> ends;
  MaterialList           materials;
};

void
Insert(Material material, MaterialList & list)
{
  const auto place = std::lower_bound(list.begin(), list.end(), material);
  if (place == list.end() || *place != material)
  {
    list.insert(place, material);
  }
}

class JunctionExtractor
{
public:
  JunctionExtractor(const std::vector<Triangle> &                triangles,
                    const std::vector<std::array<Material, 2>> & sides,
                    std::size_t                                  numberOfPoints)
    : m_Triangles(triangles)
    , m_Sides(sides)
    , m_Fans(numberOfPoints, triangles.size(), [&](std::size_t t) -> const Triangle & { return triangles[t]; })
    , m_Edges(this->FindEdges(numberOfPoints))
    , m_EdgesAt(numberOfPoints, m_Edges.size(), [&](std::size_t e) { return m_Edges[e].ends; })
    , m_IsUsed(m_Edges.size(), 0)
  {}

  Junctions
  Extract(std::size_t numberOfPoints)
  {
    Junctions junctions;
    for (PointId p = 0; p < numberOfPoints; ++p)
    {
      if (this->IsEnd(p))
      {
        junctions.points.push_back({ p, this->MaterialsAt(p) });
      }
    }
    for (const auto & junction : junctions.points)
    {
      this->Follow(junction.point, junctions.curves);
    }
    // what is left is closed
    for (const auto & edge : m_Edges)
    {
      this->Follow(edge.ends[0], junctions.curves);
    }
    return junctions;
  }

private:
  MaterialList
  MaterialsAt(PointId p) const
  {
    MaterialList materials;
    for (auto t = m_Fans.Begin(p); t != m_Fans.End(p); ++t)
    {
      Insert(m_Sides[*t][0], materials);
      Insert(m_Sides[*t][1], materials);
    }
    return materials;
  }

  /** Sorted by their lower ends, then by the higher ones. */
  std::vector<JunctionEdge>
  FindEdges(std::size_t numberOfPoints) const
  {
    std::vector<JunctionEdge>                      edges;
    std::vector<std::pair<PointId, std::uint32_t>> neighbours;
    for (PointId p = 0; p < numberOfPoints; ++p)
    {
      if (this->MaterialsAt(p).size() < 3)
      {
        continue;
      }
      neighbours.clear();
      for (auto t = m_Fans.Begin(p); t != m_Fans.End(p); ++t)
      {
        for (const PointId other : m_Triangles[*t])
        {
          if (other > p)
          {
            neighbours.emplace_back(other, *t);
          }
        }
      }
      std::sort(neighbours.begin(), neighbours.end());
      for (auto first = neighbours.begin(); first != neighbours.end();)
      {
        JunctionEdge edge{ { { p, first->first } }, {} };
        for (; first != neighbours.end() && first->first == edge.ends[1]; ++first)
        {
          Insert(m_Sides[first->second][0], edge.materials);
          Insert(m_Sides[first->second][1], edge.materials);
        }
        if (edge.materials.size() > 2)
        {
          edges.push_back(std::move(edge));
        }
      }
    }
    return edges;
  }

  bool
  IsEnd(PointId p) const
  {
    const auto * first = m_EdgesAt.Begin(p);
    const auto   count = m_EdgesAt.End(p) - first;
    return (count != 0 && count != 2) || (count == 2 && m_Edges[first[0]].materials != m_Edges[first[1]].materials) ||
           this->MaterialsAt(p).size() > 3;
  }

  /** Uses an edge and returns its other end. */
  PointId
  Advance(std::uint32_t edge, PointId from)
  {
    m_IsUsed[edge] = 1;
    const auto & ends = m_Edges[edge].ends;
    return ends[0] == from ? ends[1] : ends[0];
  }

  /** Appends the curves that leave a point along edges that are not used yet. */
  void
  Follow(PointId start, std::vector<JunctionCurve> & curves)
  {
    for (auto first = m_EdgesAt.Begin(start); first != m_EdgesAt.End(start); ++first)
    {
      if (m_IsUsed[*first])
      {
        continue;
      }
      JunctionCurve curve{ { start }, m_Edges[*first].materials };
      PointId       p = this->Advance(*first, start);
      curve.points.push_back(p);
      while (p != start && !this->IsEnd(p))
      {
        const auto * next = m_EdgesAt.Begin(p);
        p = this->Advance(m_IsUsed[next[0]] ? next[1] : next[0], p);
        curve.points.push_back(p);
      }
      curves.push_back(std::move(curve));
    }
  }

  const std::vector<Triangle> &                m_Triangles;
  const std::vector<std::array<Material, 2>> & m_Sides;
  Incidence                                    m_Fans;
  std::vector<JunctionEdge>                    m_Edges;
  Incidence                                    m_EdgesAt;
  std::vector<char>                            m_IsUsed;
};
} // namespace

std::vector<std::array<Material, 2>>
SidesWithPlanes(const InterfaceMesh &       interfaces,
                const std::vector<Vector> & points,
                const Grid &                grid,
                std::size_t                 numberOfMaterials,
                Material                    outside)
{
  auto sides = interfaces.sides;
  for (std::size_t t = 0; t < sides.size(); ++t)
  {
    for (int plane = 0; plane < 6; ++plane)
    {
      const int    axis = plane / 2;
      const double place = plane % 2 ? grid.UpperFace(axis) : grid.LowerFace(axis);
      const auto & corners = interfaces.triangles[t];
      if (std::all_of(corners.begin(), corners.end(), [&](PointId corner) {
            return std::abs(points[corner][axis] - place) < Flatness;
          }))
      {
        std::replace(sides[t].begin(), sides[t].end(), outside, Material(numberOfMaterials + plane));
        break;
      }
    }
  }
  return sides;
}

Junctions
ExtractJunctions(const InterfaceMesh &       interfaces,
                 const std::vector<Vector> & points,
                 const Grid &                grid,
                 std::size_t                 numberOfMaterials,
                 Material                    outside)
{
  const auto        sides = SidesWithPlanes(interfaces, points, grid, numberOfMaterials, outside);
  JunctionExtractor extractor(interfaces.triangles, sides, points.size());
  return extractor.Extract(points.size());
}
} // namespace mmm
