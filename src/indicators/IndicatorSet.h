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
#ifndef mmmIndicatorSet_h
#define mmmIndicatorSet_h

#include "indicators/BoxPlanes.h"
#include "indicators/CandidateMaterials.h"
#include "indicators/Cell.h"
#include "indicators/IndicatorBricks.h"
#include "indicators/IndicatorParameters.h"
#include "indicators/TricubicStencil.h"

namespace mmm
{
/** \brief The indicator functions f_i of all materials, evaluated anywhere in the image box.
 *
 * Between grid nodes the values are interpolated by tricubic (Catmull-Rom) convolution, so that gradients are
 * continuous; beyond the border they are continued constantly. Beyond its block a material has the value `outside`.
 *
 * The six faces of the image box are planes, see BoxPlanes: pseudo-materials which own all that is outside the box.
 * They cut the materials sharply: they are never compared with an f_i. */
class IndicatorSet
{
public:
  /** One indicator a material; `outside` is what they are beyond their bricks. */
  IndicatorSet(const Grid & grid, std::vector<IndicatorBricks> indicators, double outside);

  const Grid &
  GetGrid() const
  {
    return m_Grid;
  }
  std::size_t
  GetNumberOfMaterials() const
  {
    return m_Indicators.size();
  }
  bool
  IsPlane(Material m) const
  {
    return m_Planes.Has(m);
  }
  const BoxPlanes &
  Planes() const
  {
    return m_Planes;
  }

  /** f_m at a point. */
  double
  Value(Material m, const Vector & x) const;
  /** f_m and its gradient at a point. */
  double
  ValueAndGradient(Material m, const Vector & x, Vector & gradient) const;
  /** Value(first, x) - Value(last, x), for less. */
  double
  Difference(Material first, Material last, const Vector & x) const;

  /** f_m at a grid node. */
  double
  ValueAtNode(Material m, const Index & node) const
  {
    return m_Indicators[m].At(node);
  }

  /** The material at a point, which is argmax f_i inside the box, and a plane outside of it. */
  Material
  MaterialAt(const Vector & x) const;
  /** The material at a grid node. */
  Material
  MaterialAtNode(std::size_t offset) const
  {
    return this->NodeMaterials()[offset];
  }
  const std::vector<Material> &
  NodeMaterials() const
  {
    return m_Candidates.NodeMaterials();
  }

  /** The inside/outside function g_m = f_m - max over j != m of f_j (equation 1). */
  double
  InsideOutside(Material m, const Vector & x) const;
  /** The cell indicator J_M = sum over m in M of g_m squared (equation 2). */
  double
  CellIndicator(const Cell & cell, const Vector & x) const;

  /** Moves a point to the nearest point of a cell by Gauss-Newton steps on the differences of its indicators. Returns
   * false where that does not converge within `reach` of the start. It does not ask whether others are larger there. */
  bool
  Project(const Cell & cell, Vector & x, double reach) const;

  /** Project(), and whether the cell's materials are the largest there, see IsMaximal(). */
  bool
  ProjectWhereMaximal(const Cell & cell,
                      Vector &     x,
                      double       reach,
                      double       tolerance = ProjectionParameters::MaximalityTolerance) const
  {
    return this->Project(cell, x, reach) && this->IsMaximal(cell, x, tolerance);
  }

  /** One step of Project(), for a point that is near the cell already. `direction` becomes the normal of a 2-cell or
   * the tangent of a 1-cell. Returns false, and leaves the point, where the cell is further than half a voxel. */
  bool
  Approach(const Cell & cell, Vector & x, Vector & direction) const;

  /** Whether the cell's materials are the largest at x, which lies on the cell: nobody else is larger by more than
   * `tolerance`, and x is in the box. */
  bool
  IsMaximal(const Cell & cell, const Vector & x, double tolerance = ProjectionParameters::MaximalityTolerance) const;

  /** The unit normal of a 2-cell, from its lower to its higher material. */
  Vector
  Normal(const Cell & cell, const Vector & x) const;
  /** The unit tangent of a 1-cell; its sign is arbitrary. */
  Vector
  Tangent(const Cell & cell, const Vector & x) const;

  /** The materials that may be the largest one at x, as a range [first, last). */
  std::pair<const Material *, const Material *>
  Candidates(const Vector & x) const
  {
    return m_Candidates.At(x);
  }

private:
  /** The functions that vanish on a cell, at most three, and their gradients at a point. */
  struct Residuals;

  double
  Evaluate(Material m, const TricubicStencil & stencil) const
  {
    return stencil.Value(m_Indicators[m], m_Outside);
  }
  Residuals
  ResidualsAt(const Cell & cell, const Vector & x) const;
  bool
  GaussNewtonStep(const Cell & cell, const Vector & x, Vector & step, Vector & direction) const;
  void
  SnapToPlanes(const Cell & cell, Vector & x) const;

  Grid                         m_Grid;
  std::vector<IndicatorBricks> m_Indicators;
  double                       m_Outside;
  BoxPlanes                    m_Planes;
  CandidateMaterials           m_Candidates;
};
} // namespace mmm

#endif
