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
#include "io/gmsh/GmshNodes.h"
#include "io/CellMesh.h"

#include <algorithm>

namespace mmm
{
void
GmshNodes::Finish()
{
  if (!std::is_sorted(m_Sorted.begin(), m_Sorted.end()))
  {
    std::sort(m_Sorted.begin(), m_Sorted.end());
  }
  const auto twice = std::adjacent_find(
    m_Sorted.begin(), m_Sorted.end(), [](const auto & a, const auto & b) { return a.first == b.first; });
  if (twice != m_Sorted.end())
  {
    throw MeshFileError("two nodes have the number " + std::to_string(twice->first));
  }
}

std::uint64_t
GmshNodes::Find(std::uint64_t number) const
{
  // Nearly all files number them from 1 without gaps.
  if (number - 1 < m_Sorted.size() && m_Sorted[number - 1].first == number)
  {
    return m_Sorted[number - 1].second;
  }
  const auto found = std::lower_bound(
    m_Sorted.begin(), m_Sorted.end(), number, [](const auto & node, std::uint64_t n) { return node.first < n; });
  if (found == m_Sorted.end() || found->first != number)
  {
    throw MeshFileError("an element refers to the node " + std::to_string(number) + ", which is not in the file");
  }
  return found->second;
}
} // namespace mmm
