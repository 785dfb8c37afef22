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
#include "sizing/SizingField.h"

#include "base/IndexBox.h"
#include "base/Parallel.h"

#include <cmath>

namespace mmm
{
void
SizingField::Lower(const std::vector<Vector> & places, double size, double slope, double reach)
{
  constexpr std::size_t LayersPerRange = 4;
  ParallelFor(m_Grid.size[2], LayersPerRange, [&](std::size_t begin, std::size_t end) {
    for (const Vector & place : places)
    {
      IndexBox box;
      for (int a = 0; a < 3; ++a)
      {
        const int centre = int(std::floor(place[a] / m_Grid.spacing[a] + 0.5));
        const int nodes = int(reach / m_Grid.spacing[a]);
        box.lower[a] = std::max(centre - nodes, a == 2 ? int(begin) : 0);
        box.upper[a] = std::min(centre + nodes, (a == 2 ? int(end) : m_Grid.size[a]) - 1);
      }
      box.Visit([&](const Index & at) {
        const double distance = (m_Grid.Position(at) - place).norm();
        float &      value = m_Values[m_Grid.Offset(at)];
        value = std::min(value, float(size + slope * distance));
      });
    }
  });
}
} // namespace mmm
