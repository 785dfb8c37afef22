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
#ifndef mmmLevelSet_h
#define mmmLevelSet_h

#include "base/Grid.h"

#include <cstdint>

namespace mmm
{
/** \brief A level set function, positive inside, on a block of the grid, with the narrow band that it is solved in.
 *
 * Values are kept in [-width, width]; nodes of the band are at least one node away from the block's rim. */
class LevelSet
{
public:
  LevelSet(const Index & lower, const Index & size, const Vector & spacing, double width);

  std::size_t
  Offset(const Index & gridIndex) const
  {
    return (std::size_t(gridIndex[2] - m_Lower[2]) * m_Size[1] + (gridIndex[1] - m_Lower[1])) * m_Size[0] +
           (gridIndex[0] - m_Lower[0]);
  }
  /** The grid index of a node of the block. */
  Index
  IndexAt(std::size_t offset) const
  {
    const auto row = offset / m_Size[0];
    return Index{
      { m_Lower[0] + int(offset % m_Size[0]), m_Lower[1] + int(row % m_Size[1]), m_Lower[2] + int(row / m_Size[1]) }
    };
  }
  const Index &
  GetLower() const
  {
    return m_Lower;
  }
  const Index &
  GetSize() const
  {
    return m_Size;
  }
  double
  GetWidth() const
  {
    return m_Width;
  }
  std::vector<float> &
  Values()
  {
    return m_Values;
  }
  const std::vector<float> &
  Values() const
  {
    return m_Values;
  }

  /** The values in a box of grid nodes, which has to be within the block. */
  Block<float>
  Copy(const Index & lower, const Index & size) const;

  /** The nodes that are solved for: those with |value| below `distance`. */
  void
  SelectBand(double distance);
  const std::vector<std::uint32_t> &
  Band() const
  {
    return m_Band;
  }

  /** What the values are before they become distances: for nodes beside the zero level, near distances give their
   * distance by value and slope, so that curved levels stay where they are; others only by where the level crosses the
   * grid's edges. */
  enum class Before
  {
    NearDistances,
    AnyFunction
  };

  /** Makes the values the signed distance to their own zero level: nodes beside it first, the rest of the band by the
   * Eikonal equation (first-order Godunov). */
  void
  Redistance(Before before);

  /** Moves the zero level by the difference between its mean curvature and that curvature's local average, until it
   * rests. This smooths like flow by mean curvature, but keeps the volume: spheres, tubes and sheets do not shrink. It
   * rests when the values near it change by less than `tolerance` per unit of time (root mean square);
   * `maximumSteps` explicit steps are a bound for what never rests. `lower` and `upper`, given per node of the band,
   * are obstacles that the values never pass. Returns the number of steps taken. */
  int
  FlowByMeanCurvature(const std::vector<float> & lower,
                      const std::vector<float> & upper,
                      double                     tolerance,
                      int                        maximumSteps);

private:
  /** Nodes of the band that follow each other along the first axis. */
  struct Run
  {
    std::uint32_t place; // of the first one, in the band
    std::uint32_t length;
  };
  struct Scratch
  {
    std::vector<float> weight; // per node of the block
    std::vector<float> weighted;
    std::vector<float> bandMean; // per node of the band
  };
  /** Values are computed for this many nodes at once. */
  static constexpr std::size_t Lanes = 8;
  /** The runs that are worked on together. */
  static constexpr std::size_t RunGrain = 1024;

  /** Calls body(place in the band, node, length, number of the range) for all runs. */
  template <typename TBody>
  void
  ForEachRun(const TBody & body) const;
  /** valueAt(node) for all nodes of the band. It is asked for nodes beyond the runs, too, and must not fail there. */
  template <typename TValue>
  void
  ComputeOverBand(const TValue & valueAt, std::vector<float> & result) const;
  /** The average over the neighbourhood, within about 1.5 nodes, of a speed given per node of the band. */
  void
  MeanOverBand(const std::vector<float> & speed, Scratch & scratch) const;

  Index                      m_Lower;
  Index                      m_Size;
  Vector                     m_Spacing;
  double                     m_Width;
  double                     m_BandDistance{ 0.0 };
  std::vector<float>         m_Values; // Lanes more than the block has nodes
  std::vector<std::uint32_t> m_Band;
  std::vector<Run>           m_Runs;
};
} // namespace mmm

#endif
