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
#ifndef mmmHeadPhantomSkull_h
#define mmmHeadPhantomSkull_h

#include "phantom/HeadPhantom.h"

namespace mmm::phantom
{
/** Skull with jaw, orbits and spine. `intracranial` is the distance to the intracranial space. */
double
Bones(const Vector & point, double intracranial);

/** Paranasal sinuses, mastoid cells, nasal cavity and airway: pockets that do not open to the outside. */
double
AirCavities(const Vector & point, double intracranial);

/** The skin. `bones` is the value of Bones() at the point. */
double
HeadOutline(const Vector & point, double intracranial, double bones);
} // namespace mmm::phantom

#endif
