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
#ifndef mmmHeadPhantomBrain_h
#define mmmHeadPhantomBrain_h

#include "phantom/HeadPhantom.h"

namespace mmm::phantom
{
/** The bone that rises between middle and posterior fossa; `left` is the point mirrored to the left. */
double
PetrousRidge(const Vector & left);

/** The space within the skull and the spinal canal, its wall the inner surface of the bone. */
double
IntracranialSpace(const Vector & point);

/** The tissue at a point within that space, where `depth` is the distance to the bone. */
HeadTissue
IntracranialTissue(const Vector & point, double depth);
} // namespace mmm::phantom

#endif
