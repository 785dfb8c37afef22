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
#ifndef mmmLinkInspector_h
#define mmmLinkInspector_h

#include "mesh/TetrahedronAdjacency.h"

#include <limits>

namespace mmm
{
/** A face of an interface at a point, seen from one of its other two corners. */
struct LinkSpoke
{
  PointId  corner;
  Material sides[2];
};

/** \brief Looks at the link of one point at a time: a sphere that the materials around the point divide. */
class LinkInspector
{
public:
  /** What lies beyond the mesh has the material `outside`. Materials may change between calls. */
  LinkInspector(const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency, Material outside);

  void
  Inspect(PointId p);

  /** Whether a material is in several parts around the point, or encircles others. */
  bool
  IsDefect() const
  {
    return m_IsDefect;
  }
  /** The other ends of edges around which a material appears in more than one place, ascending. */
  const std::vector<PointId> &
  DefectEdges() const
  {
    return m_DefectEdges;
  }
  /** Whether the point is on no interface. */
  bool
  IsHidden() const
  {
    return m_Materials.empty();
  }
  /** The defects of the point and of the edges at it. */
  std::size_t
  CountDefects() const
  {
    return std::size_t(m_IsDefect) + m_DefectEdges.size();
  }
  /** The defects at all of some points, or at so many that there are not below `enough`; an edge between two of the
   * points counts twice. */
  template <typename TPoints>
  std::size_t
  CountDefectsAt(const TPoints & points, std::size_t enough = std::numeric_limits<std::size_t>::max())
  {
    std::size_t count = 0;
    for (auto p = points.begin(); p != points.end() && count < enough; ++p)
    {
      this->Inspect(*p);
      count += this->CountDefects();
    }
    return count;
  }
  /** The materials at the point, or none if there is but one. */
  const std::vector<Material> &
  Materials() const
  {
    return m_Materials;
  }
  /** For each tetrahedron of the star, a number that it has in common with those of its part. */
  const std::vector<int> &
  Parts() const
  {
    return m_Parents;
  }

private:
  void
  FindPartsAndSpokes(PointId p);
  void
  Unite(int a, int b);
  int
  Find(int a) const;
  void
  ListMaterials(const LinkSpoke * begin, const LinkSpoke * end);

  const TetrahedralMesh &      m_Mesh;
  const TetrahedronAdjacency & m_Adjacency;
  const Material               m_Outside;
  std::vector<int>             m_Parents;
  std::size_t                  m_NumberOfParts{ 0 };
  std::vector<LinkSpoke>       m_Spokes;
  std::vector<Material>        m_Materials;
  std::vector<PointId>         m_DefectEdges;
  bool                         m_IsDefect{ false };
};
} // namespace mmm

#endif
