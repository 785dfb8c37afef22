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
#ifndef mmmTricubicStencil_h
#define mmmTricubicStencil_h

#include "indicators/IndicatorBricks.h"

#include <algorithm>

namespace mmm
{
/** \brief The 4 x 4 x 4 nodes around a point and their weights in Catmull and Rom's interpolation, an axis at a time.
 *
 * It serves all indicators of a grid. Beyond the border they are continued constantly. */
class TricubicStencil
{
public:
  TricubicStencil(const Grid & grid, const Vector & x)
  {
    for (int a = 0; a < 3; ++a)
    {
      const int    last = grid.size[a] - 1;
      const double position = x[a] / grid.spacing[a];
      const double u = std::min(std::max(position, 0.0), double(last));
      const int    base = std::min(int(u), std::max(last - 1, 0));
      const double t = u - base;
      const double t2 = t * t;
      const double t3 = t2 * t;
      m_Weight[a][0] = -0.5 * t + t2 - 0.5 * t3;
      m_Weight[a][1] = 1.0 - 2.5 * t2 + 1.5 * t3;
      m_Weight[a][2] = 0.5 * t + 2.0 * t2 - 1.5 * t3;
      m_Weight[a][3] = -0.5 * t2 + 0.5 * t3;
      m_Between[a] = t;
      m_Brick[a] = IndicatorBricks::BrickOf(base - 1);
      m_Place[a] = IndicatorBricks::PlaceOf(base - 1);
    }
  }

  /** The value of an indicator, which is `outside` beyond its bricks. */
  double
  Value(const IndicatorBricks & indicator, double outside) const
  {
    if (indicator.IsOutside(m_Brick))
    {
      return outside;
    }
    Four sums = Four::Zero();
    this->ForEachRow(indicator, [&](int k, int j, const Four & row) { sums += m_Weight[2][k] * m_Weight[1][j] * row; });
    double value = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      value += m_Weight[0][i] * sums[i];
    }
    return value;
  }

protected:
  using Four = Eigen::Array4d;

  /** Calls body(k, j, row) with the four values of each of the sixteen rows, which lie in up to four bricks. */
  template <typename TBody>
  void
  ForEachRow(const IndicatorBricks & indicator, const TBody & body) const
  {
    const int     beyond[2] = { m_Place[1] > IndicatorBricks::Edge - 4, m_Place[2] > IndicatorBricks::Edge - 4 };
    const float * values[2][2];
    for (int k = 0; k <= beyond[1]; ++k)
    {
      for (int j = 0; j <= beyond[0]; ++j)
      {
        values[k][j] = indicator.Values(m_Brick[0], m_Brick[1] + j, m_Brick[2] + k) + m_Place[0];
      }
    }
    for (int k = 0; k < 4; ++k)
    {
      const int z = m_Place[2] + k;
      for (int j = 0; j < 4; ++j)
      {
        const int           y = m_Place[1] + j;
        const float * const row = values[z / IndicatorBricks::Edge][y / IndicatorBricks::Edge] +
                                  IndicatorBricks::RowPlace(y % IndicatorBricks::Edge, z % IndicatorBricks::Edge);
        body(k, j, Four(row[0], row[1], row[2], row[3]));
      }
    }
  }

  Index  m_Brick; // of the first node
  Index  m_Place;
  double m_Weight[3][4];
  /** Where the point is between its nodes. */
  double m_Between[3];
};

/** \brief The same with the slopes of the weights. */
class TricubicGradientStencil : public TricubicStencil
{
public:
  TricubicGradientStencil(const Grid & grid, const Vector & x)
    : TricubicStencil(grid, x)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double position = x[a] / grid.spacing[a];
      const bool   within = position > 0.0 && position < grid.size[a] - 1;
      const double scale = within ? 1.0 / grid.spacing[a] : 0.0;
      const double t = m_Between[a];
      const double t2 = t * t;
      m_Slope[a][0] = (-0.5 + 2.0 * t - 1.5 * t2) * scale;
      m_Slope[a][1] = (-5.0 * t + 4.5 * t2) * scale;
      m_Slope[a][2] = (0.5 + 4.0 * t - 4.5 * t2) * scale;
      m_Slope[a][3] = (-t + 1.5 * t2) * scale;
    }
  }

  /** The value of an indicator and its gradient. */
  double
  Value(const IndicatorBricks & indicator, double outside, Vector & gradient) const
  {
    gradient.setZero();
    if (indicator.IsOutside(m_Brick))
    {
      return outside;
    }
    Four sums = Four::Zero();
    Four alongY = Four::Zero();
    Four alongZ = Four::Zero();
    this->ForEachRow(indicator, [&](int k, int j, const Four & row) {
      sums += m_Weight[2][k] * m_Weight[1][j] * row;
      alongY += m_Weight[2][k] * m_Slope[1][j] * row;
      alongZ += m_Slope[2][k] * m_Weight[1][j] * row;
    });
    double value = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      value += m_Weight[0][i] * sums[i];
      gradient[0] += m_Slope[0][i] * sums[i];
      gradient[1] += m_Weight[0][i] * alongY[i];
      gradient[2] += m_Weight[0][i] * alongZ[i];
    }
    return value;
  }

private:
  double m_Slope[3][4];
};
} // namespace mmm

#endif
