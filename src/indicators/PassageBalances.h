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
#ifndef mmmPassageBalances_h
#define mmmPassageBalances_h

#include "indicators/IndicatorRaises.h"

namespace mmm
{
/** A place where a material leads another one by little. */
struct WeakPlace
{
  Vector   position;
  Material own;
  Material second;
};

/** \brief Finds the middles of what is narrow near some places, and tips the balance there.
 *
 * A middle is a critical point of the difference of two materials where neither leads by much, see FindCriticalPoint().
 * The one that leads gets its lead of PassageParameters at least, half of it from the other one, unless that one has
 * got it at a neighbour that leads by more. Adds what the nodes around get. */
void
TipBalances(const IndicatorSet & indicators, const std::vector<WeakPlace> & places, std::vector<Raise> & raises);
} // namespace mmm

#endif
