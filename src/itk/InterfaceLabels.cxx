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
#include "itk/InterfaceLabels.h"

#include <algorithm>
#include <limits>

namespace mmm
{
InterfaceLabels::InterfaceLabels(const std::vector<int> & labels, int exterior, int wanted)
  : m_Labels(labels)
  , m_Outside(wanted)
{
  const auto isTaken = [&labels](int label) { return std::find(labels.begin(), labels.end(), label) != labels.end(); };
  if (exterior >= 0)
  {
    m_Outside = labels[exterior];
    return;
  }
  if (isTaken(m_Outside))
  {
    m_Outside = 0;
  }
  if (isTaken(m_Outside))
  {
    m_Outside = *std::min_element(labels.begin(), labels.end());
    // the label below it, unless the range of int ends there
    while (isTaken(m_Outside))
    {
      m_Outside = m_Outside > std::numeric_limits<int>::min() ? m_Outside - 1 : std::numeric_limits<int>::max();
    }
  }
}

std::array<int, 2>
InterfaceLabels::OfSides(const std::array<Material, 2> & sides) const
{
  const int a = this->OfMaterial(sides[0]);
  const int b = this->OfMaterial(sides[1]);
  return { { std::min(a, b), std::max(a, b) } };
}

std::array<int, 5>
InterfaceLabels::OfParticle(const Cell & cell) const
{
  auto labels = this->OfMaterials(cell);
  labels.resize(4, labels.back());
  return { { cell.Dimension(), labels[0], labels[1], labels[2], labels[3] } };
}

std::array<int, 5>
InterfaceLabels::OfJunction(const MaterialList & materials) const
{
  auto       labels = this->OfMaterials(materials);
  const auto count = int(labels.size());
  labels.resize(4, labels.back());
  return { { count, labels[0], labels[1], labels[2], labels[3] } };
}
} // namespace mmm
