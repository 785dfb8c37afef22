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
#include "image/SliceDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

/** The lower envelope of parabolas that stand on the samples of a line, for one line after the other. */
class LineEnvelope
{
public:
  LineEnvelope(int length, double spacing)
    : m_Spacing(spacing)
    , m_Heights(std::size_t(length))
    , m_Vertices(std::size_t(length))
    , m_Starts(std::size_t(length))
  {}

  /** Replaces the values of a line, `stride` apart, by the envelope of the parabolas value + distance^2. */
  void
  Replace(double * values, std::size_t stride)
  {
    const int count = int(m_Heights.size());
    for (int p = 0; p < count; ++p)
    {
      m_Heights[p] = values[p * stride];
    }
    int parabolas = 0;
    for (int p = 0; p < count; ++p)
    {
      if (m_Heights[p] == Infinite)
      {
        continue;
      }
      double start = -Infinite;
      while (parabolas > 0)
      {
        start = this->Crossing(m_Vertices[parabolas - 1], p);
        if (start > m_Starts[parabolas - 1])
        {
          break;
        }
        start = -Infinite;
        --parabolas;
      }
      m_Vertices[parabolas] = p;
      m_Starts[parabolas] = start;
      ++parabolas;
    }
    for (int p = 0, k = 0; parabolas > 0 && p < count; ++p)
    {
      while (k + 1 < parabolas && m_Starts[k + 1] < p * m_Spacing)
      {
        ++k;
      }
      const double distance = (p - m_Vertices[k]) * m_Spacing;
      values[p * stride] = m_Heights[m_Vertices[k]] + distance * distance;
    }
  }

private:
  /** Where the parabola of q, which is behind p, comes to lie below that of p. */
  double
  Crossing(int p, int q) const
  {
    const double x = p * m_Spacing;
    const double y = q * m_Spacing;
    return (m_Heights[q] + y * y - m_Heights[p] - x * x) / (2.0 * (y - x));
  }

  const double        m_Spacing;
  std::vector<double> m_Heights;
  std::vector<int>    m_Vertices;
  std::vector<double> m_Starts;
};
} // namespace

std::vector<float>
DistancesToSet(const SlicePlane & plane, const std::vector<char> & isIn)
{
  const auto          width = std::size_t(plane.size[0]);
  std::vector<double> squares(plane.NumberOfPixels());
  std::transform(isIn.begin(), isIn.end(), squares.begin(), [](char in) { return in ? 0.0 : Infinite; });
  LineEnvelope alongRow(plane.size[0], plane.spacing[0]);
  for (std::size_t row = 0; row < std::size_t(plane.size[1]); ++row)
  {
    alongRow.Replace(&squares[row * width], 1);
  }
  LineEnvelope alongColumn(plane.size[1], plane.spacing[1]);
  for (std::size_t column = 0; column < width; ++column)
  {
    alongColumn.Replace(&squares[column], width);
  }
  std::vector<float> distances(squares.size());
  std::transform(squares.begin(), squares.end(), distances.begin(), [](double s) { return float(std::sqrt(s)); });
  return distances;
}
} // namespace mmm
