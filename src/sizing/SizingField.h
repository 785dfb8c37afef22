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
#ifndef mmmSizingField_h
#define mmmSizingField_h

#include "base/Grid.h"

#include <algorithm>

namespace mmm
{
/** The sizing field h between the grid nodes: trilinear, continued constantly beyond the border. */
class SizingField
{
public:
  /** `values` holds a size per grid node, of which the field keeps a copy. */
  SizingField(const Grid & grid, const float * values)
    : m_Grid(grid)
    , m_Values(values, values + grid.NumberOfNodes())
  {}

  const float *
  Values() const
  {
    return m_Values.data();
  }
  float
  AtNode(const Index & node) const
  {
    return m_Values[m_Grid.Offset(node)];
  }

  double
  operator()(const Vector & x) const
  {
    int    node[3][2];
    double weight[3][2];
    for (int a = 0; a < 3; ++a)
    {
      const int    last = m_Grid.size[a] - 1;
      const double u = std::min(std::max(x[a] / m_Grid.spacing[a], 0.0), double(last));
      node[a][0] = std::min(int(u), std::max(last - 1, 0));
      node[a][1] = std::min(node[a][0] + 1, last);
      weight[a][1] = u - node[a][0];
      weight[a][0] = 1.0 - weight[a][1];
    }
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const int i = corner & 1;
      const int j = (corner >> 1) & 1;
      const int k = corner >> 2;
      value += weight[0][i] * weight[1][j] * weight[2][k] * m_Values[m_Grid.Offset(node[0][i], node[1][j], node[2][k])];
    }
    return value;
  }

  /** Lowers h to `size` at some places, and so around them that it grows by `slope` times the distance; as far as
   * `reach` along each axis. */
  void
  Lower(const std::vector<Vector> & places, double size, double slope, double reach);

private:
  Grid               m_Grid;
  std::vector<float> m_Values;
};
} // namespace mmm

#endif
