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
#ifndef mmmCandidateMaterials_h
#define mmmCandidateMaterials_h

#include "image/MaterialImage.h"
#include "indicators/IndicatorBricks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mmm
{
/** \brief The materials that may be the largest one around a place, and the largest one at each grid node.
 *
 * The candidates are listed for small bricks of nodes. */
class CandidateMaterials
{
public:
  /** `outside` is what the indicators are beyond their bricks. */
  CandidateMaterials(const Grid & grid, const std::vector<IndicatorBricks> & indicators, double outside);

  const std::vector<Material> &
  NodeMaterials() const
  {
    return m_NodeMaterials;
  }

  /** The candidates at a point, as a range [first, last). */
  std::pair<const Material *, const Material *>
  At(const Vector & x) const
  {
    std::size_t at[3];
    for (int a = 0; a < 3; ++a)
    {
      const int nearest = int(std::floor(x[a] / m_Grid.spacing[a] + 0.5));
      at[a] = std::min(std::max(nearest, 0), m_Grid.size[a] - 1) / BrickSize;
    }
    const auto brick = (at[2] * m_Bricks[1] + at[1]) * m_Bricks[0] + at[0];
    return { m_Materials.data() + m_Start[brick], m_Materials.data() + m_Start[brick + 1] };
  }

private:
  /** Nodes along each axis. */
  static constexpr int BrickSize = 4;

  /** The candidates in each brick of a layer. */
  struct Layer
  {
    std::vector<std::uint32_t> counts;
    std::vector<Material>      materials;
  };
  /** Finds those of a layer of bricks, and its nodes' materials. */
  class LayerLister;

  Grid                       m_Grid;
  std::vector<Material>      m_NodeMaterials;
  Index                      m_Bricks;
  std::vector<std::uint32_t> m_Start;
  std::vector<Material>      m_Materials;
};
} // namespace mmm

#endif
