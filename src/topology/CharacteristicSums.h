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
#ifndef mmmCharacteristicSums_h
#define mmmCharacteristicSums_h

#include "image/MaterialImage.h"
#include "base/Parallel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmm
{
/** The Euler characteristic of what a material has of a cell, or by how much two of them differ. */
struct LocalCharacteristic
{
  std::size_t  cell{ std::size_t(-1) };
  Material     material{ 0 };
  std::int32_t value{ 0 };
};

/** Those that are not zero, by cell and material. */
using LocalCharacteristics = std::vector<LocalCharacteristic>;

/** Sums of characteristics by cell and material: a hash table with open addressing. */
class CharacteristicSums
{
public:
  CharacteristicSums();

  void
  Add(std::size_t cell, Material material, int value);

  LocalCharacteristics
  List() const;

private:
  LocalCharacteristic &
  SlotOf(std::size_t cell, Material material);
  void
  Grow();

  /** A power of 2. */
  LocalCharacteristics m_Slots;
  std::size_t          m_Used{ 0 };
};

/** Appends to `lists` what addRange(begin, end, sums) adds for the ranges of some items. */
template <typename TAddRange>
void
AddRanges(std::size_t count, std::size_t grain, std::vector<LocalCharacteristics> & lists, const TAddRange & addRange)
{
  const std::size_t before = lists.size();
  lists.resize(before + (count + grain - 1) / grain);
  ParallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
    CharacteristicSums sums;
    addRange(begin, end, sums);
    lists[before + begin / grain] = sums.List();
  });
}

/** Adds up what is of the same cell, below `numberOfCells`, and material in lists. */
LocalCharacteristics
AddUp(const std::vector<LocalCharacteristics> & lists, std::size_t numberOfCells);
} // namespace mmm

#endif
