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

#include "mmmBlockComplex.h"
#include "mmmEulerChanges.h"
#include "mmmIndexBox.h"

namespace mmm
{
/** \brief The partition of the indicators in some blocks, at more samples than a lattice has.
 *
 * Where two samples touch, but a third material is larger between them, there is a sheet that is thinner than the
 * distance of the samples: one of them is given to that material, so that the sheet has no hole. */
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
  /** Gives samples that touch, but with another material in between, to that one. */
  void
  SeparateByThinSheets(const SampleLattice & lattice);
  /** A third material between two, or else one of them. */
  Material
  MaterialBetween(const SampleLattice & lattice, Vector begin, Vector end, Material first, Material last) const;
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
