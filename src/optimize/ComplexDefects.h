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
#ifndef mmmComplexDefects_h
#define mmmComplexDefects_h

#include "optimize/TetrahedralComplex.h"

#include <cassert>
#include <cstddef>
#include <vector>

namespace mmm
{
/** \brief What no phase of the optimizer may add to. */
struct ComplexDefects
{
  /** Tetrahedra whose volume is not positive. */
  std::size_t notPositive{ 0 };
  /** Faces across which a tetrahedron has another neighbour than the one that has the same three points. */
  std::size_t notNeighbours{ 0 };
  /** Edges at which the boundary of a material is open. */
  std::size_t open{ 0 };

  /** Whether there are no more of any kind than there were. */
  bool
  AreWithin(const ComplexDefects & before) const
  {
    return notPositive <= before.notPositive && notNeighbours <= before.notNeighbours && open <= before.open;
  }
};

ComplexDefects
FindDefects(const TetrahedralComplex & complex, const std::vector<Vector> & points);

/** \brief In Debug builds, ends the program where a phase has added defects. */
class SoundnessCheck
{
public:
#ifdef NDEBUG
  SoundnessCheck(const TetrahedralComplex &, const std::vector<Vector> &) {}

  void
  AssertSound() const
  {}
#else
  SoundnessCheck(const TetrahedralComplex & complex, const std::vector<Vector> & points)
    : m_Complex(complex)
    , m_Points(points)
    , m_Before(FindDefects(complex, points))
  {}

  void
  AssertSound() const
  {
    assert(FindDefects(m_Complex, m_Points).AreWithin(m_Before));
  }

private:
  const TetrahedralComplex &  m_Complex;
  const std::vector<Vector> & m_Points;
  const ComplexDefects        m_Before;
#endif
};
} // namespace mmm

#endif
