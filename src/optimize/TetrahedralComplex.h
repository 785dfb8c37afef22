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
#ifndef mmmTetrahedralComplex_h
#define mmmTetrahedralComplex_h

#include "mesh/TetrahedralMesh.h"

namespace mmm
{
/** \brief A labelled tetrahedral mesh that can be changed locally: tetrahedra know their neighbours, points one of
 * their tetrahedra. */
class TetrahedralComplex
{
public:
  using Id = std::uint32_t;

  struct Element
  {
    Tetrahedron corners;
    Material    material;
  };

  /** The tetrahedra around an edge in turn, and the points that they have besides it: one more if the edge lies on the
   * outside of the mesh and the ring is open. */
  struct Ring
  {
    std::vector<Id>      tetrahedra;
    std::vector<PointId> link;
    bool                 closed{ true };
  };

  TetrahedralComplex(const TetrahedralMesh & mesh, std::size_t numberOfPoints);

  /** One past the largest id; some ids below it may be free. */
  std::size_t
  Size() const
  {
    return m_Corners.size();
  }
  bool
  IsAlive(Id t) const
  {
    return m_Alive[t] != 0;
  }
  const Tetrahedron &
  Corners(Id t) const
  {
    return m_Corners[t];
  }
  Material
  MaterialOf(Id t) const
  {
    return m_Materials[t];
  }
  /** The tetrahedron beyond the face opposite a corner, or NoTetrahedron. */
  Id
  Neighbour(Id t, int face) const
  {
    return m_Neighbours[t][face];
  }
  /** Whether materials differ across a face, or nothing is beyond it. */
  bool
  IsInterface(Id t, int face) const
  {
    const Id other = m_Neighbours[t][face];
    return other == NoTetrahedron || m_Materials[other] != m_Materials[t];
  }
  void
  SetMaterial(Id t, Material material)
  {
    m_Materials[t] = material;
    this->Touch(t);
  }

  /** The tetrahedra around a point. */
  void
  GetStar(PointId point, std::vector<Id> & star) const;
  /** The tetrahedra around an edge, of which `t` is one. */
  void
  GetRing(Id t, PointId a, PointId b, Ring & ring) const;

  /** Puts new tetrahedra in the place of old ones; both must fill the same space. */
  void
  Replace(const std::vector<Id> & old, const std::vector<Element> & fresh);

  /** Whether a tetrahedron at a point has been replaced, or has got another material, since ForgetTouched(). */
  bool
  IsTouched(PointId point) const
  {
    return m_IsTouched[point] != 0;
  }
  void
  ForgetTouched();

  /** Numbers the tetrahedra that are left anew, in the order of their ids, so that all ids below Size() are alive. */
  void
  Compact();

  /** Corners and materials by id; those of free ids mean nothing. */
  const std::vector<Tetrahedron> &
  Tetrahedra() const
  {
    return m_Corners;
  }
  const std::vector<Material> &
  Materials() const
  {
    return m_Materials;
  }

  /** The tetrahedra that are left, in the order of their ids. */
  TetrahedralMesh
  GetMesh() const;

private:
  void
  FindTetrahedronOfEachPoint();
  void
  Touch(Id t)
  {
    for (const auto corner : m_Corners[t])
    {
      m_IsTouched[corner] = 1;
    }
  }

  std::vector<Tetrahedron>       m_Corners;
  std::vector<std::array<Id, 4>> m_Neighbours;
  std::vector<Material>          m_Materials;
  std::vector<char>              m_Alive;
  std::vector<Id>                m_Free;
  std::vector<Id>                m_PointTetrahedron;
  std::vector<char>              m_IsTouched;
};
} // namespace mmm

#endif
