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
#ifndef mmmCell_h
#define mmmCell_h

#include "image/MaterialImage.h"

#include <algorithm>
#include <array>

namespace mmm
{
/** \brief The set M of materials that meet at a junction, sorted.
 *
 * Two materials meet on a 2-cell (a surface), three on a 1-cell (a curve), four on a 0-cell (a point). Where junctions
 * lie closer together than can be meshed they are one point of up to Capacity materials. */
struct Cell
{
  static constexpr int Capacity = 8;

  std::array<Material, Capacity> materials{};
  std::uint8_t                   count{ 0 };

  Cell() = default;
  Cell(std::initializer_list<Material> list)
  {
    for (const Material m : list)
    {
      materials[count++] = m;
    }
    std::sort(this->begin(), this->end());
  }
  Material *
  begin()
  {
    return materials.data();
  }
  Material *
  end()
  {
    return materials.data() + count;
  }
  const Material *
  begin() const
  {
    return materials.data();
  }
  const Material *
  end() const
  {
    return materials.data() + count;
  }
  /** 2 for a surface, 1 for a curve, 0 for a point. */
  int
  Dimension() const
  {
    return std::max(0, 4 - int(count));
  }
  bool
  Has(Material m) const
  {
    return std::find(this->begin(), this->end(), m) != this->end();
  }
  /** Whether all of the other cell's materials are this one's as well. */
  bool
  Includes(const Cell & other) const
  {
    return std::includes(this->begin(), this->end(), other.begin(), other.end());
  }
  /** Takes in the other cell's materials. Returns false, and changes nothing, if there are too many. */
  bool
  Join(const Cell & other)
  {
    std::array<Material, 2 * Capacity> all;
    const auto last = std::set_union(this->begin(), this->end(), other.begin(), other.end(), all.begin());
    if (last - all.begin() > Capacity)
    {
      return false;
    }
    count = std::uint8_t(std::copy(all.begin(), last, materials.begin()) - materials.begin());
    return true;
  }
  friend bool
  operator==(const Cell & a, const Cell & b)
  {
    return a.count == b.count && std::equal(a.begin(), a.end(), b.begin());
  }
  friend bool
  operator!=(const Cell & a, const Cell & b)
  {
    return !(a == b);
  }
  friend bool
  operator<(const Cell & a, const Cell & b)
  {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};
} // namespace mmm

#endif
