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
#ifndef mmmIndicatorRaises_h
#define mmmIndicatorRaises_h

#include "base/IndexBox.h"
#include "indicators/IndicatorSet.h"

#include <vector>

namespace mmm
{
/** \brief What an indicator gets at a node, or loses. */
struct Raise
{
  std::size_t node;
  Material    material;
  float       amount;

  bool
  IsLoss() const
  {
    return amount < 0.0f;
  }
};

/** \brief Changes indicators as far as each node keeps its material: of what one gets at a node the largest gain and
 * the largest loss. `indicators` are those of the blocks before. `raises` becomes what was wanted, without the others.
 */
void
ApplyRaises(const IndicatorSet & indicators, std::vector<Raise> & raises, std::vector<Block<float>> & blocks);
} // namespace mmm

#endif
