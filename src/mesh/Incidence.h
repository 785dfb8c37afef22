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
#ifndef mmmIncidence_h
#define mmmIncidence_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmm
{
/** \brief The items at each key, ascending: for example the tetrahedra at each point.
 *
 * `keysOf(item)` returns the item's keys, an array of integers below `keys`. */
class Incidence
{
public:
  template <typename TKeysOf>
  Incidence(std::size_t keys, std::size_t items, const TKeysOf & keysOf)
    : m_Offsets(keys + 1, 0)
  {
    for (std::size_t item = 0; item < items; ++item)
    {
      for (const auto key : keysOf(item))
      {
        ++m_Offsets[key];
      }
    }
    std::size_t sum = 0;
    for (auto & offset : m_Offsets)
    {
      sum += offset;
      offset = sum;
    }
    m_Items.resize(sum);
    for (std::size_t item = items; item-- > 0;)
    {
      for (const auto key : keysOf(item))
      {
        m_Items[--m_Offsets[key]] = std::uint32_t(item);
      }
    }
  }

  const std::uint32_t *
  Begin(std::size_t key) const
  {
    return m_Items.data() + m_Offsets[key];
  }
  const std::uint32_t *
  End(std::size_t key) const
  {
    return m_Items.data() + m_Offsets[key + 1];
  }

private:
  std::vector<std::size_t>   m_Offsets;
  std::vector<std::uint32_t> m_Items;
};
} // namespace mmm

#endif
