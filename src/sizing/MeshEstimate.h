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
#ifndef mmmMeshEstimate_h
#define mmmMeshEstimate_h

#include "MultiMaterialMeshingReports.h"
#include "indicators/IndicatorSet.h"
#include "sizing/SizingField.h"

#include <vector>

namespace mmm
{
/** The next number of two digits that is not smaller. */
double
RoundUp(double value);

/** \brief Predicts the size of a mesh from its sizing field.
 *
 * Interfaces of area A hold triangles in proportion to A / h^2, and volumes V tetrahedra in proportion to V / h^3. The
 * constants are measured. */
class MeshEstimator
{
public:
  /** `exterior` is the material that is not meshed, or -1. */
  MeshEstimator(const IndicatorSet & indicators, int exterior, const SizingField & sizing, bool surfaceOnly);

  /** What is to be expected if all sizes are multiplied by a factor, and then none is below `smallestSize`. */
  MeshEstimate
  Estimate(double smallestSize = 0.0, double factor = 1.0) const;

  /** The factor for sizes, at most 1, with which this many tetrahedra are to be expected. */
  double
  FactorFor(double tetrahedra) const;

  /** The least size that keeps to both limits; infinite if none does. */
  double
  SmallestSizeFor(double tetrahedra, double memory) const;

private:
  /** Area and volume of about the same size and thickness. */
  struct Bin
  {
    double area{ 0.0 };
    double volume{ 0.0 };
  };

  std::vector<Bin> m_Bins;
  bool             m_SurfaceOnly;
  /** Before there is a mesh, in GB. */
  double m_MemoryOfImages;
};
} // namespace mmm

#endif
