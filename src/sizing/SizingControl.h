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
#ifndef mmmSizingControl_h
#define mmmSizingControl_h

#include "indicators/IndicatorSet.h"
#include "sizing/InterfaceSamples.h"
#include "sizing/SizeRule.h"
#include "sizing/SourcePropagation.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace mmm
{
struct SizingParameters;

/** \brief What users add to the computed sizes. Lengths are in the grid's unit. */
struct SizingControl
{
  /** Sizes from here on are no limit. */
  static constexpr float NoLimit = 1e30f;

  /** Empty, or a size for each grid node. */
  std::vector<float> image;
  /** Whether the image stands in place of the computed sizes where it has a limit, else they do not exceed it. */
  bool imageReplaces{ false };
  /** Empty, or a rule for each material. */
  std::vector<SizeRule> materials;
  /** Empty, or for each grid node whether it is in the region of interest. */
  std::vector<std::uint8_t> region;
  SizeRule                  regionRule;
};

/** Whether a region, given per grid node, has a node in a material other than `exterior`. */
bool
IsInMaterials(const std::vector<std::uint8_t> & region, const IndicatorSet & indicators, int exterior);

/** \brief Applies what users ask for to the sizes at interfaces and grid nodes.
 *
 * In the region of interest its bounds stand in place of the materials', and these in place of the general ones. A
 * bound that is not given is the one of the next in this order, moved if it contradicts the other bound. At an
 * interface the materials that have a rule decide, and of two the one that asks for less. */
class SizeRules
{
public:
  /** All must outlive this. */
  SizeRules(const IndicatorSet & indicators, const SizingParameters & parameters, const SizingControl & control);

  /** The size at an interface, from the computed one; infinite where an image stands in its place. */
  float
  AtInterface(const InterfaceSample & sample, double size) const;

  /** Drops the sources that are infinite and adds those of the bounds away from the interfaces. */
  void
  CompleteSources(std::vector<Source> & sources) const;

  /** The sizes that the image asks for at the grid nodes, infinite where it asks for none; nothing without an image. */
  std::vector<float>
  NodeSizes() const;

  /** Takes sizes at the grid nodes down to the largest that are allowed there. */
  void
  LimitSizes(std::vector<float> & sizes) const;

private:
  struct Bounds
  {
    double minimum;
    double maximum;

    /** Those that hold where a rule does; none is above `limit`. */
    Bounds
    Under(const SizeRule & rule, double limit) const;
  };

  bool
  IsInRegion(std::size_t node) const
  {
    return !m_Control.region.empty() && m_Control.region[node] != 0;
  }

  /** The size in a material, from the one that is wanted. */
  double
  In(Material material, bool inRegion, double size) const;

  float
  LimitAt(std::size_t node) const;

  const IndicatorSet &  m_Indicators;
  const SizingControl & m_Control;
  /** Of each material, outside the region of interest and in it. */
  std::vector<Bounds>   m_Bounds[2];
  std::vector<SizeRule> m_Rules;
  bool                  m_HasLocalLimits{ false };
};
} // namespace mmm

#endif
