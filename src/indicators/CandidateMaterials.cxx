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
#include "indicators/CandidateMaterials.h"

#include "base/IndexBox.h"
#include "base/Parallel.h"

#include <array>
#include <iterator>

namespace mmm
{
namespace
{
/** A material this much below the largest at a node cannot be the largest within a voxel of it. */
constexpr float CandidateMargin = 2.5f;
} // namespace

class CandidateMaterials::LayerLister
{
public:
  LayerLister(const Grid &                         grid,
              const std::vector<IndicatorBricks> & indicators,
              double                               outside,
              std::vector<Material> &              nodeMaterials)
    : m_Grid(grid)
    , m_Indicators(indicators)
    , m_Lowest(float(outside) - 1.0f)
    , m_NodeMaterials(nodeMaterials)
  {}

  void
  List(int k, const Index & bricks, Layer & layer)
  {
    std::vector<Material> all(m_Indicators.size());
    for (std::size_t m = 0; m < all.size(); ++m)
    {
      all[m] = Material(m);
    }
    this->SetRange(2, k);
    const auto inLayer = this->Overlapping(all, 2);
    for (int j = 0; j < bricks[1]; ++j)
    {
      this->SetRange(1, j);
      const auto inRow = this->Overlapping(inLayer, 1);
      for (int i = 0; i < bricks[0]; ++i)
      {
        this->SetRange(0, i);
        this->ReadValues(this->Overlapping(inRow, 0));
        this->SetNodeMaterials({ { i, j, k } });
        this->AddCandidates(layer);
      }
    }
  }

private:
  /** A point of a brick is interpolated from nodes up to two beyond it, but its own material is decided one node
   * around.
   */
  static constexpr int Reach = BrickSize + 2;
  using Values = std::array<float, Reach * Reach * Reach>;

  void
  SetRange(int axis, int brick)
  {
    m_Box.lower[axis] = std::max(brick * BrickSize - 1, 0);
    m_Box.upper[axis] = std::min((brick + 1) * BrickSize + 1, m_Grid.size[axis]) - 1;
  }

  /** Those whose bricks reach into the range of an axis. */
  std::vector<Material>
  Overlapping(const std::vector<Material> & materials, int axis) const
  {
    std::vector<Material> found;
    std::copy_if(materials.begin(), materials.end(), std::back_inserter(found), [&](Material m) {
      return m_Indicators[m].GetLower()[axis] <= m_Box.upper[axis] &&
             m_Indicators[m].GetUpper()[axis] > m_Box.lower[axis];
    });
    return found;
  }

  /** The indicators of those materials that are not outside of the box, and the largest of them. */
  void
  ReadValues(const std::vector<Material> & materials)
  {
    const Index & upper = m_Box.upper;
    const Index   past{ { upper[0] + 1, upper[1] + 1, upper[2] + 1 } };
    m_Here.clear();
    std::copy_if(materials.begin(), materials.end(), std::back_inserter(m_Here), [&](Material m) {
      return !m_Indicators[m].IsOutside(m_Box.lower, past);
    });
    m_Values.resize(m_Here.size());
    m_Largest.fill(m_Lowest);
    m_LargestIs.fill(0);
    for (std::size_t n = 0; n < m_Here.size(); ++n)
    {
      std::size_t place = 0;
      m_Box.Visit([&](const Index & at) {
        const float value = m_Here.size() > 1 ? m_Indicators[m_Here[n]].At(at) : 0.0f;
        m_Values[n][place] = value;
        if (value > m_Largest[place])
        {
          m_Largest[place] = value;
          m_LargestIs[place] = m_Here[n];
        }
        ++place;
      });
    }
  }

  void
  SetNodeMaterials(const Index & brick)
  {
    std::size_t place = 0;
    m_Box.Visit([&](const Index & at) {
      if (at[0] / BrickSize == brick[0] && at[1] / BrickSize == brick[1] && at[2] / BrickSize == brick[2])
      {
        m_NodeMaterials[m_Grid.Offset(at)] = m_LargestIs[place];
      }
      ++place;
    });
  }

  void
  AddCandidates(Layer & layer) const
  {
    const Index size = m_Box.Size();
    const int   places = size[0] * size[1] * size[2];
    const auto  before = layer.materials.size();
    for (std::size_t n = 0; n < m_Here.size(); ++n)
    {
      bool isCandidate = false;
      for (int p = 0; p < places && !isCandidate; ++p)
      {
        isCandidate = m_Values[n][p] > m_Largest[p] - CandidateMargin;
      }
      if (isCandidate)
      {
        layer.materials.push_back(m_Here[n]);
      }
    }
    layer.counts.push_back(std::uint32_t(layer.materials.size() - before));
  }

  const Grid &                                m_Grid;
  const std::vector<IndicatorBricks> &        m_Indicators;
  const float                                 m_Lowest;
  std::vector<Material> &                     m_NodeMaterials;
  IndexBox                                    m_Box;
  std::vector<Material>                       m_Here;
  std::vector<Values>                         m_Values;
  Values                                      m_Largest;
  std::array<Material, Reach * Reach * Reach> m_LargestIs;
};

CandidateMaterials::CandidateMaterials(const Grid &                         grid,
                                       const std::vector<IndicatorBricks> & indicators,
                                       double                               outside)
  : m_Grid(grid)
  , m_NodeMaterials(grid.NumberOfNodes(), 0)
  , m_Start(1, 0)
{
  for (int a = 0; a < 3; ++a)
  {
    m_Bricks[a] = (grid.size[a] + BrickSize - 1) / BrickSize;
  }
  std::vector<Layer> layers(m_Bricks[2]);
  ParallelFor(layers.size(), 1, [&](std::size_t begin, std::size_t end) {
    LayerLister lister(grid, indicators, outside, m_NodeMaterials);
    for (std::size_t k = begin; k < end; ++k)
    {
      lister.List(int(k), m_Bricks, layers[k]);
    }
  });
  for (const auto & layer : layers)
  {
    for (const auto count : layer.counts)
    {
      m_Start.push_back(m_Start.back() + count);
    }
    m_Materials.insert(m_Materials.end(), layer.materials.begin(), layer.materials.end());
  }
}
} // namespace mmm
