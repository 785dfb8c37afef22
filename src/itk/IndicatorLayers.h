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
#ifndef mmmIndicatorLayers_h
#define mmmIndicatorLayers_h

#include "base/IndexBox.h"

#include <vector>

namespace mmm
{
/** A shape on top of what is below: its signed distance, positive inside, in units of the grid. */
struct IndicatorLayer
{
  int label;
  /** The labels below that it may hide; all if there are none. */
  std::vector<int> replaced;
  /** Beyond these nodes it is far. */
  IndexBox box;
  /** At the nodes of the box. */
  std::vector<float> distances;

  bool
  Hides(int label) const;
};

/** \brief The indicator of a label on a part of the grid; beyond it is -IndicatorBandWidth. */
struct LabelIndicator
{
  int                label;
  IndexBox           box;
  std::vector<float> values;

  float &
  At(const Index & at)
  {
    const Index size = box.Size();
    return values[(std::size_t(at[2] - box.lower[2]) * size[1] + (at[1] - box.lower[1])) * size[0] + at[0] -
                  box.lower[0]];
  }
};

bool
IsEmpty(const IndexBox & box);

/** The smallest box that holds both. */
IndexBox
Union(const IndexBox & first, const IndexBox & second);

/** Puts layers on top of indicators, each over those before it.
 *
 * With d for the layer's distance times a slope, and M for the largest indicator f of the labels that it may hide,
 * these become M - s (M - f) - max(d, 0), and that of the layer M + min(d, 0), or what its label has already if that is
 * larger. So the difference to what is the largest below it is d on both sides of the interface. Interfaces between the
 * others stay where they are; s makes their differences softer near a layer that hides all labels. In the end what is
 * added to all indicators of a node is such that the two largest are opposite, as signed distances are.
 *
 * There has to be an indicator of each layer's label, whose box holds that of the layer. */
void
PutOnTop(const Grid & grid, const std::vector<IndicatorLayer> & layers, std::vector<LabelIndicator> & indicators);
} // namespace mmm

#endif
