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
#include "optimize/CurvedTetrahedra.h"

#include "optimize/OptimizationParameters.h"

#include <algorithm>
#include <limits>

namespace mmm
{
CurvedTetrahedra::CurvedTetrahedra(const std::vector<Tetrahedron> & tetrahedra,
                                   const std::vector<Vector> &      points,
                                   const CurvedEdges &              edges)
  : m_Tetrahedra(tetrahedra)
  , m_Points(points)
  , m_Edges(edges)
  , m_IsCurved(edges.size(), 1)
  , m_First(points.size() + 1, 0)
{
  for (const CurvedEdge & edge : edges)
  {
    ++m_First[edge.ends[0] + 1];
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    m_First[p + 1] += m_First[p];
  }
}

bool
CurvedTetrahedra::HasCurvedEdge(std::size_t t) const
{
  const auto edges = this->EdgesOf(t);
  return std::any_of(edges.begin(), edges.end(), [](std::uint32_t edge) { return edge != NoEdge; });
}

double
CurvedTetrahedra::VolumeOf(std::size_t t) const
{
  return this->HasCurvedEdge(t) ? QuadraticVolume(this->NodesWith(t, this->EdgesOf(t)))
                                : this->StraightJacobian(t) / 6.0;
}

double
CurvedTetrahedra::RelativeJacobian(std::size_t t) const
{
  return this->HasCurvedEdge(t) ? SmallestJacobian(this->NodesWith(t, this->EdgesOf(t))) / this->StraightJacobian(t)
                                : 1.0;
}

std::uint32_t
CurvedTetrahedra::FindInverting(std::size_t t) const
{
  const auto   edges = this->EdgesOf(t);
  const double enough = EdgeCurvingParameters::LeastJacobian * this->StraightJacobian(t);
  if (SmallestJacobian(this->NodesWith(t, edges)) >= enough)
  {
    return NoEdge;
  }
  std::uint32_t worst = NoEdge;
  double        best = -std::numeric_limits<double>::infinity();
  for (int e = 0; e < 6; ++e)
  {
    auto others = edges;
    others[e] = NoEdge;
    const double jacobian = edges[e] == NoEdge ? best : SmallestJacobian(this->NodesWith(t, others));
    if (jacobian > best)
    {
      worst = edges[e];
      best = jacobian;
    }
  }
  return worst;
}

CurvedTetrahedra::EdgeNumbers
CurvedTetrahedra::EdgesOf(std::size_t t) const
{
  EdgeNumbers edges;
  for (int e = 0; e < 6; ++e)
  {
    const auto ends = std::minmax(m_Tetrahedra[t][TetrahedronEdges[e][0]], m_Tetrahedra[t][TetrahedronEdges[e][1]]);
    edges[e] = NoEdge;
    for (auto n = m_First[ends.first]; n < m_First[ends.first + 1]; ++n)
    {
      if (m_Edges[n].ends[1] == ends.second && m_IsCurved[n])
      {
        edges[e] = n;
      }
    }
  }
  return edges;
}

QuadraticTetrahedron
CurvedTetrahedra::NodesWith(std::size_t t, const EdgeNumbers & edges) const
{
  QuadraticTetrahedron nodes;
  for (int corner = 0; corner < 4; ++corner)
  {
    nodes[corner] = m_Points[m_Tetrahedra[t][corner]];
  }
  for (int e = 0; e < 6; ++e)
  {
    nodes[4 + e] = edges[e] == NoEdge ? Vector(0.5 * (nodes[TetrahedronEdges[e][0]] + nodes[TetrahedronEdges[e][1]]))
                                      : m_Edges[edges[e]].middle;
  }
  return nodes;
}

double
CurvedTetrahedra::StraightJacobian(std::size_t t) const
{
  const Tetrahedron & c = m_Tetrahedra[t];
  return 6.0 * TetrahedronVolume(m_Points[c[0]], m_Points[c[1]], m_Points[c[2]], m_Points[c[3]]);
}
} // namespace mmm
