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
#ifndef mmmSurfaceDistance_h
#define mmmSurfaceDistance_h

#include "base/Monitor.h"
#include "distance/TriangleSurface.h"
#include "distance/WindingNumber.h"

namespace mmm
{
/** \brief The signed distance of a surface of triangles, positive inside.
 *
 * Inside is where the surface winds around a point, in either direction, by more than half. So holes are closed, where
 * the winding number is a half, and what parts of the surface enclose together counts as one: triangles with both sides
 * inside, or both outside, are none of its boundary. */
class SurfaceDistance
{
public:
  /** The surface as RepairSurface() leaves it, which found these defects. */
  SurfaceDistance(const TriangleSurface & surface, const SurfaceDefects & defects);

  /** The distances at the nodes of a grid, cut off at a band. */
  std::vector<float>
  Compute(const Grid & grid, double band, Monitor & monitor);

  /** How far winding numbers were from whole ones near the surface, on average, from 0 to 0.5: it encloses nothing
   * clearly where that is much. Known after Compute(), as is the other. */
  double
  GetDoubt() const
  {
    return m_Doubt;
  }
  /** Whether parts of the surface enclose the same, or are turned inside out. */
  bool
  HasOverlaps() const
  {
    return m_HasOverlaps;
  }

private:
  struct Row;

  /** Whether a triangle is boundary. */
  enum class Kind : unsigned char
  {
    Nowhere,
    Everywhere,
    InPart
  };

  void
  ComputeRow(const Grid & grid, double band, Row & row) const;
  /** Takes distances of boundary alone. */
  void
  CorrectRow(const Grid & grid, double band, const std::vector<Kind> & kinds, Row & row) const;
  /** Whether the surface separates inside and outside at a point; `across` goes through it. */
  bool
  IsBoundary(const Vector & point, const Vector & across) const;
  Kind
  FindKind(std::uint32_t triangle) const;

  const bool          m_IsClosed;
  const bool          m_IsBranching;
  const TriangleTree  m_Tree;
  const WindingNumber m_Winding;
  double              m_Doubt{ 0.0 };
  bool                m_HasOverlaps{ false };
};
} // namespace mmm

#endif
