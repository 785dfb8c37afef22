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
#ifndef mmmComplexChange_h
#define mmmComplexChange_h

#include "optimize/TetrahedralComplex.h"

#include <algorithm>

namespace mmm
{
/** \brief A local change of a complex that has been found, but not been made yet. */
struct ComplexChange
{
  enum class Kind : std::uint8_t
  {
    Flip,
    InterfaceFlip,
    Collapse
  };

  Kind                                     kind;
  std::vector<TetrahedralComplex::Id>      old;
  std::vector<TetrahedralComplex::Element> fresh;
  /** What the old tetrahedra have in common: those that have all of these points are the old ones. */
  std::vector<PointId> centre;
  /** Points on whose tetrahedra it depends as well. */
  std::vector<PointId> beside;

  /** Whether the complex is what it was when the change was found, as far as that matters. */
  bool
  IsUpToDate(const TetrahedralComplex & complex) const
  {
    const auto isUntouched = [&](PointId p) { return !complex.IsTouched(p); };
    return std::any_of(centre.begin(), centre.end(), isUntouched) &&
           std::all_of(beside.begin(), beside.end(), isUntouched);
  }
};
} // namespace mmm

#endif
