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
#include "sizing/JunctionTable.h"

#include "base/IndexBox.h"
#include "base/MakeUnique.h"
#include "base/ParallelCollect.h"
#include "sizing/SizingParameters.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
using Parameters = MedialAxisParameters;
} // namespace

JunctionTable::JunctionTable(const IndicatorSet & indicators)
  : m_Indicators(indicators)
{
  const Grid & grid = indicators.GetGrid();
  for (int a = 0; a < 3; ++a)
  {
    m_Edge[a] = std::max(2, int(std::ceil(Parameters::JunctionBrick / grid.spacing[a])));
    m_Bricks.size[a] = (grid.size[a] + m_Edge[a] - 1) / m_Edge[a];
  }
  // dual cubes reach beyond the border, where a plane takes the place of the nodes that are not there
  const auto found = ParallelCollect<Entry>(grid.size[2] + 1, 1, [&](std::size_t k, std::vector<Entry> & entries) {
    const int plane = int(k) - 1;
    IndexBox{ { { -1, -1, plane } }, { { grid.size[0] - 1, grid.size[1] - 1, plane } } }.Visit(
      [&](const Index & cube) { this->CollectCube(cube, entries); });
  });
  m_Triples.resize(m_Bricks.NumberOfNodes());
  for (const Entry & entry : found)
  {
    m_Triples[entry.first].push_back(entry.second);
  }
  for (auto & triples : m_Triples)
  {
    MakeUnique(triples);
  }
}

bool
JunctionTable::IsWedge(Material own, Material atP, Material atQ, const Vector & p, const Vector & q) const
{
  if (atP == atQ || atP == own || atQ == own)
  {
    return false;
  }
  const Cell triple{ own, atP, atQ };
  return this->HasNear(triple, p) || this->HasNear(triple, q);
}

bool
JunctionTable::HasNear(const Cell & triple, const Vector & x) const
{
  const Grid & grid = m_Indicators.GetGrid();
  Index        node;
  for (int a = 0; a < 3; ++a)
  {
    node[a] = int(std::floor(x[a] / grid.spacing[a] + 0.5));
  }
  const auto & triples = m_Triples[this->BrickAt(grid.Clamp(node))];
  if (!std::binary_search(triples.begin(), triples.end(), triple))
  {
    return false;
  }
  // the sides of a layer that is thinner than a dual cube do not meet
  Vector junction = x;
  return m_Indicators.Project(triple, junction, Parameters::JunctionReach) &&
         m_Indicators.CellIndicator(triple, junction) < Parameters::JunctionTolerance;
}

/** Adds the triples of the materials at a cube's corners, to all bricks in reach. */
void
JunctionTable::CollectCube(const Index & cube, std::vector<Entry> & found) const
{
  Material present[8];
  int      count = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Material m =
      this->MaterialAt({ { cube[0] + (corner & 1), cube[1] + ((corner >> 1) & 1), cube[2] + (corner >> 2) } });
    if (std::find(present, present + count, m) == present + count)
    {
      present[count++] = m;
    }
  }
  if (count < 3)
  {
    return;
  }
  const Grid & grid = m_Indicators.GetGrid();
  IndexBox     bricks;
  for (int a = 0; a < 3; ++a)
  {
    const double reach = Parameters::JunctionReach / grid.spacing[a];
    bricks.lower[a] = std::max(0, int(std::floor(cube[a] - reach + 0.5))) / m_Edge[a];
    bricks.upper[a] = std::min(grid.size[a] - 1, int(std::ceil(cube[a] + reach + 0.5))) / m_Edge[a];
  }
  for (int a = 0; a < count; ++a)
  {
    for (int b = a + 1; b < count; ++b)
    {
      for (int c = b + 1; c < count; ++c)
      {
        const Cell triple{ present[a], present[b], present[c] };
        bricks.Visit([&](const Index & brick) { found.push_back({ m_Bricks.Offset(brick), triple }); });
      }
    }
  }
}

Material
JunctionTable::MaterialAt(const Index & node) const
{
  const Grid & grid = m_Indicators.GetGrid();
  for (int a = 0; a < 3; ++a)
  {
    if (node[a] < 0 || node[a] >= grid.size[a])
    {
      return m_Indicators.Planes().At(2 * a + (node[a] < 0 ? 0 : 1));
    }
  }
  return m_Indicators.MaterialAtNode(grid.Offset(node));
}

std::size_t
JunctionTable::BrickAt(const Index & node) const
{
  return m_Bricks.Offset(node[0] / m_Edge[0], node[1] / m_Edge[1], node[2] / m_Edge[2]);
}
} // namespace mmm
