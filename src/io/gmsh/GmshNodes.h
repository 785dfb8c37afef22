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
#ifndef mmmGmshNodes_h
#define mmmGmshNodes_h

#include <cstdint>
#include <utility>
#include <vector>

namespace mmm
{
/** \brief The places of nodes by their numbers in a Gmsh file, which may have gaps and be in any order. */
class GmshNodes
{
public:
  void
  Add(std::uint64_t number)
  {
    m_Sorted.emplace_back(number, m_Sorted.size());
  }

  /** To be called when all nodes are there. Throws MeshFileError if two have the same number. */
  void
  Finish();

  /** Throws MeshFileError if there is no such node. */
  std::uint64_t
  Find(std::uint64_t number) const;

private:
  std::vector<std::pair<std::uint64_t, std::uint64_t>> m_Sorted;
};
} // namespace mmm

#endif
