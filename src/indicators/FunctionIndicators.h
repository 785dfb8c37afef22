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
#ifndef mmmFunctionIndicators_h
#define mmmFunctionIndicators_h

#include "indicators/IndicatorSmoothing.h"

namespace mmm
{
/** What the maps of materials leave to a material without map, per voxel: 1 - sum if the maps are probabilities, which
 * range within [0, 1] but for errors of interpolation, and -max if they are signed, positive inside. Throws
 * itk::ExceptionObject if they are neither. */
std::vector<float>
ComputeRemainder(const std::vector<const float *> & maps, std::size_t numberOfVoxels);

/** \brief Indicators, which are distances, from functions in any unit: probabilities, or other signed distances.
 *
 * The zero level of a material's indicator is where its function equals the largest of the others, between the voxels'
 * centres; from those of parts of one voxel's thickness it stays away a little. A centre is on the side that the
 * material image says; where a function says otherwise, which is so where islands were merged, the voxel's largest
 * value and that of its material change places. */
class FunctionIndicators
{
public:
  /** Per material its functions, of which the largest counts, with a value for each voxel. They must outlive this
   * object, as must the image. */
  FunctionIndicators(const MaterialImage & image, std::vector<std::vector<const float *>> functions);

  /** The signed distance to the zero level, positive inside, as ComputeSmoothIndicator() gives it. */
  Block<float>
  Compute(Material material, const MaterialBox & box) const;

private:
  float
  Value(Material material, std::size_t voxel) const;
  /** By how much the value of a voxel's material is above that of another, which is always positive. */
  float
  Lead(std::size_t voxel, Material other) const;
  /** How far a voxel's centre is from where, on the ways to its neighbours, a material begins or ends. 0 if none does.
   */
  float
  DistanceToNeighbours(Material material, const Index & at) const;
  /** The border's voxels are continued beyond it. */
  std::size_t
  VoxelAt(const Index & at) const;

  const MaterialImage &                   m_Image;
  std::vector<std::vector<const float *>> m_Functions;
  std::vector<float>                      m_Largest;
  std::vector<float>                      m_Second;
};
} // namespace mmm

#endif
