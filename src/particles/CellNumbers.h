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
#ifndef mmmCellNumbers_h
#define mmmCellNumbers_h

#include "indicators/Cell.h"

#include <cstdint>
#include <map>
#include <vector>

namespace mmm
{
/** Finds cells in a table of them, and adds those that are new. */
class CellNumbers
{
public:
  explicit CellNumbers(std::vector<Cell> & table)
    : m_Table(table)
  {
    for (std::uint32_t n = 0; n < table.size(); ++n)
    {
      m_Numbers.insert({ table[n], n });
    }
  }
  std::uint32_t
  operator()(const Cell & cell)
  {
    const auto entry = m_Numbers.insert({ cell, std::uint32_t(m_Table.size()) });
    if (entry.second)
    {
      m_Table.push_back(cell);
    }
    return entry.first->second;
  }

private:
  std::vector<Cell> &           m_Table;
  std::map<Cell, std::uint32_t> m_Numbers;
};
} // namespace mmm

#endif
