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
#ifndef mmmJunctionTable_h
#define mmmJunctionTable_h

#include "indicators/IndicatorSet.h"

#include <utility>
#include <vector>

namespace mmm
{
/** \brief Where three materials meet: per brick of the grid, the triples of a junction near it. */
class JunctionTable
{
public:
  explicit JunctionTable(const IndicatorSet & indicators);

  /** Whether p and q, on the interfaces of `own` with `atP` and `atQ`, belong to one junction's wedge. */
  bool
  IsWedge(Material own, Material atP, Material atQ, const Vector & p, const Vector & q) const;

private:
  using Entry = std::pair<std::size_t, Cell>; // a brick, and a triple there

  bool
  HasNear(const Cell & triple, const Vector & x) const;
  void
  CollectCube(const Index & cube, std::vector<Entry> & found) const;
  Material
  MaterialAt(const Index & node) const;
  std::size_t
  BrickAt(const Index & node) const;

  const IndicatorSet &           m_Indicators;
  Index                          m_Edge;
  Grid                           m_Bricks;
  std::vector<std::vector<Cell>> m_Triples;
};
} // namespace mmm

#endif
