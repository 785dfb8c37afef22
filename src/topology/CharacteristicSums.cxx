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
#include "topology/CharacteristicSums.h"

#include "base/Hash.h"
#include "base/ParallelCollect.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
namespace
{
constexpr std::size_t Empty = std::size_t(-1);
constexpr std::size_t InitialSlots = 1024; // a power of 2, as ever

bool
IsBefore(const LocalCharacteristic & a, const LocalCharacteristic & b)
{
  return a.cell != b.cell ? a.cell < b.cell : a.material < b.material;
}
} // namespace

CharacteristicSums::CharacteristicSums()
  : m_Slots(InitialSlots)
{}

void
CharacteristicSums::Add(std::size_t cell, Material material, int value)
{
  LocalCharacteristic & slot = this->SlotOf(cell, material);
  if (slot.cell != Empty)
  {
    slot.value += value;
    return;
  }
  slot = { cell, material, value };
  if (2 * ++m_Used > m_Slots.size())
  {
    this->Grow();
  }
}

LocalCharacteristics
CharacteristicSums::List() const
{
  LocalCharacteristics list;
  std::copy_if(m_Slots.begin(), m_Slots.end(), std::back_inserter(list), [](const LocalCharacteristic & slot) {
    return slot.cell != Empty && slot.value != 0;
  });
  std::sort(list.begin(), list.end(), IsBefore);
  return list;
}

LocalCharacteristic &
CharacteristicSums::SlotOf(std::size_t cell, Material material)
{
  std::size_t n = Hash(std::uint64_t(cell) << 16 | material) & (m_Slots.size() - 1);
  while (m_Slots[n].cell != Empty && (m_Slots[n].cell != cell || m_Slots[n].material != material))
  {
    n = (n + 1) & (m_Slots.size() - 1);
  }
  return m_Slots[n];
}

void
CharacteristicSums::Grow()
{
  LocalCharacteristics before(2 * m_Slots.size());
  before.swap(m_Slots);
  for (const auto & slot : before)
  {
    if (slot.cell != Empty)
    {
      this->SlotOf(slot.cell, slot.material) = slot;
    }
  }
}

LocalCharacteristics
AddUp(const std::vector<LocalCharacteristics> & lists, std::size_t numberOfCells)
{
  constexpr std::size_t Parts = 64;
  const std::size_t     cellsPerPart = numberOfCells / Parts + 1;
  return ParallelCollect<LocalCharacteristic>(Parts, 1, [&](std::size_t part, LocalCharacteristics & sums) {
    const auto isBelow = [](const LocalCharacteristic & entry, std::size_t cell) { return entry.cell < cell; };
    LocalCharacteristics all;
    for (const auto & list : lists)
    {
      const auto begin = std::lower_bound(list.begin(), list.end(), part * cellsPerPart, isBelow);
      all.insert(all.end(), begin, std::lower_bound(begin, list.end(), (part + 1) * cellsPerPart, isBelow));
    }
    std::sort(all.begin(), all.end(), IsBefore);
    for (std::size_t n = 0; n < all.size();)
    {
      LocalCharacteristic sum = all[n];
      for (++n; n < all.size() && !IsBefore(sum, all[n]); ++n)
      {
        sum.value += all[n].value;
      }
      if (sum.value != 0)
      {
        sums.push_back(sum);
      }
    }
  });
}
} // namespace mmm
