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
#ifndef mmmLinkChanges_h
#define mmmLinkChanges_h

#include "surface/LinkInspector.h"

namespace mmm
{
/** Tetrahedra of one material, and another one that they could be of. */
struct LinkChange
{
  std::vector<std::uint32_t> tetrahedra;
  Material                   material;
  /** Corners that do not lie on a cell of the material. */
  std::size_t strangers{ 0 };
  /** How much the indicators are against it. */
  double cost{ 0.0 };
};

/** \brief Lists what may mend the defects at a point: single tetrahedra or pairs, parts of the star, sectors around
 * edges that are defects, and the whole star, with each material that they have a face with. */
class LinkChangeLister
{
public:
  LinkChangeLister(const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency, Material outside);

  /** Nothing where there is no defect. Costs are left open. */
  std::vector<LinkChange>
  List(PointId p, bool withPairs);

private:
  void
  AddSectors(PointId p, PointId q);
  /** To each material that the tetrahedra have a face with. */
  void
  AddChanges(const std::vector<std::uint32_t> & tetrahedra);

  const TetrahedralMesh &      m_Mesh;
  const TetrahedronAdjacency & m_Adjacency;
  const Material               m_Outside;
  LinkInspector                m_Inspector;
  std::vector<LinkChange>      m_Changes;
};
} // namespace mmm

#endif
