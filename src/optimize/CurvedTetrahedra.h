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
#ifndef mmmCurvedTetrahedra_h
#define mmmCurvedTetrahedra_h

#include "mesh/CurvedEdges.h"
#include "mesh/QuadraticTetrahedron.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mmm
{
/** \brief Tetrahedra with some curved edges, which can be made straight again.
 *
 * Tetrahedra and edges are called by their places in the vectors, which have to stay. The edges are sorted. */
class CurvedTetrahedra
{
public:
  static constexpr std::uint32_t NoEdge = 0xffffffffu;

  CurvedTetrahedra(const std::vector<Tetrahedron> & tetrahedra,
                   const std::vector<Vector> &      points,
                   const CurvedEdges &              edges);

  bool
  IsCurved(std::size_t edge) const
  {
    return m_IsCurved[edge] != 0;
  }
  void
  Straighten(std::size_t edge)
  {
    m_IsCurved[edge] = 0;
  }
  bool
  HasCurvedEdge(std::size_t t) const;

  double
  VolumeOf(std::size_t t) const;

  /** The lower bound of its Jacobian in units of that of the straight tetrahedron. */
  double
  RelativeJacobian(std::size_t t) const;

  /** Of a tetrahedron whose Jacobian is below EdgeCurvingParameters::LeastJacobian: the edge without which it is the
   * largest; else NoEdge. */
  std::uint32_t
  FindInverting(std::size_t t) const;

private:
  using EdgeNumbers = std::array<std::uint32_t, 6>;

  /** In the order of TetrahedronEdges; NoEdge where they are straight. */
  EdgeNumbers
  EdgesOf(std::size_t t) const;
  QuadraticTetrahedron
  NodesWith(std::size_t t, const EdgeNumbers & edges) const;
  double
  StraightJacobian(std::size_t t) const;

  const std::vector<Tetrahedron> & m_Tetrahedra;
  const std::vector<Vector> &      m_Points;
  const CurvedEdges &              m_Edges;
  std::vector<char>                m_IsCurved;
  /** Of each point, where the edges begin whose lower end it is. */
  std::vector<std::uint32_t> m_First;
};
} // namespace mmm

#endif
