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
#ifndef mmmSampleFinder_h
#define mmmSampleFinder_h

#include "mesh/TetrahedralMesh.h"
#include "particles/Particles.h"

#include <algorithm>
#include <array>

namespace mmm
{
/** A place on a cell where a particle is needed. */
struct MissingSample
{
  Vector position;
  Cell   cell;
};

/** Corners of a tetrahedron: two for an edge, and so on. Ascending. */
struct TetrahedronPart
{
  std::array<PointId, 4> corners{};
  int                    count{ 0 };

  const PointId *
  begin() const
  {
    return corners.data();
  }
  const PointId *
  end() const
  {
    return corners.data() + count;
  }
  friend bool
  operator==(const TetrahedronPart & a, const TetrahedronPart & b)
  {
    return a.count == b.count && std::equal(a.begin(), a.end(), b.begin());
  }
  friend bool
  operator<(const TetrahedronPart & a, const TetrahedronPart & b)
  {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

/** \brief Looks for the samples that a tetrahedron lacks whose corners have no material in common. Planes count for
 * none.
 */
class SampleFinder
{
public:
  SampleFinder(const IndicatorSet & indicators, const ParticleSet & particles);

  bool
  HaveCommonMaterial(const TetrahedronPart & part) const;

  /** Appends the parts of least dimension whose corners have no material in common. */
  void
  ListParts(const Tetrahedron & tetrahedron, std::vector<TetrahedronPart> & parts) const;

  /** The sample that such a part lacks. Returns false where none is found. */
  bool
  FindSample(const TetrahedronPart & part, MissingSample & sample) const;

private:
  Vector
  CentreOf(const TetrahedronPart & part) const;
  Cell
  CommonPlanes(const TetrahedronPart & part) const;
  /** Where the material changes between two points, as near to the middle as possible. */
  bool
  FindOnLine(const Vector & from, const Vector & to, const Cell & planes, MissingSample & sample) const;
  /** Where a material ends between two points close together. */
  bool
  FindCrossing(Vector inside, Vector outside, Material own, const Cell & planes, MissingSample & sample) const;
  /** Where the materials of the sides of a triangle, or of the faces of a tetrahedron, meet. */
  bool
  FindJunction(const TetrahedronPart & part, MissingSample & sample) const;
  /** Where the material of the middle ends on the way to a corner that does not have it. */
  bool
  FindBetween(const TetrahedronPart & part, MissingSample & sample) const;

  const IndicatorSet & m_Indicators;
  const ParticleSet &  m_Particles;
};
} // namespace mmm

#endif
