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
#include "phantom/HeadPhantom.h"
#include "phantom/HeadPhantomBrain.h"
#include "phantom/HeadPhantomSkull.h"

namespace mmm
{
HeadTissue
HeadPhantomTissue(const Vector & point)
{
  const double intracranial = phantom::IntracranialSpace(point);
  if (intracranial < 0)
  {
    return phantom::IntracranialTissue(point, -intracranial);
  }
  const double bones = phantom::Bones(point, intracranial);
  const double outline = phantom::HeadOutline(point, intracranial, bones);
  if (outline >= 0)
  {
    return HeadTissue::Outside;
  }
  constexpr double skin = 3.0;
  if (outline < -skin && phantom::AirCavities(point, intracranial) < 0)
  {
    return HeadTissue::Air;
  }
  return bones < 0 ? HeadTissue::Skull : HeadTissue::Scalp;
}
} // namespace mmm
