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
#ifndef mmmFineSamples_h
#define mmmFineSamples_h

#include "topology/BlockComplex.h"
#include "topology/EulerChanges.h"
#include "base/IndexBox.h"

namespace mmm
{
/** \brief The partition of the indicators in some blocks, at more samples than a lattice has.
 *
 * Where two samples of different materials touch, but a third one is larger between them, there is a sheet that is
 * thinner than the distance of the samples: the sample of the lower material is given to it, so that the sheet has no
 * hole. If that sample also touches the other material without a third one in between, the hole is there, and stays. */
class FineSamples
{
public:
  /** `blocks` are cells with even indices. There will be `subdivision` steps between two samples of the lattice. */
  FineSamples(const SampleLattice & lattice,
              const BlockComplex &  complex,
              const IndexBox &      blocks,
              int                   subdivision,
              Material              exterior);

  /** How many samples that would be. */
  static std::size_t
  Count(const BlockComplex & complex, const IndexBox & blocks, int subdivision);

  /** What new samples and sheets add to the characteristics of what the materials have of a cell. */
  EulerChanges
  ChangesAt(const Index & cell) const;

private:
  /** In samples of the lattice. */
  Vector
  SamplePosition(const Index & at) const;
  /** Gives samples in front of thin sheets to the sheets. */
  void
  SeparateByThinSheets(const SampleLattice & lattice);
  /** Adds the characteristics of those samples of a cell that are some steps apart. */
  void
  AddAt(const Index & cell, const std::vector<Material> & samples, int step, int sign, EulerChanges & changes) const;

  const BlockComplex &  m_Complex;
  const int             m_Subdivision;
  const Material        m_Exterior;
  const Index           m_First;
  const Grid            m_Grid;
  std::vector<Material> m_Sampled;
  /** The same with thin sheets. */
  std::vector<Material> m_Separated;
};
} // namespace mmm

#endif
