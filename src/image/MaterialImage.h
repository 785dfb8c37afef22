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
#ifndef mmmMaterialImage_h
#define mmmMaterialImage_h

#include "base/Grid.h"

#include <cstdint>
#include <vector>

namespace mmm
{
/** A material is known to the geometry core by its position in the sorted list of labels. */
using Material = std::uint16_t;

/** \brief A label image in the core's terms: per voxel the material, which is a number from 0 to N - 1. */
struct MaterialImage
{
  Grid                  grid;
  std::vector<Material> materials;
  std::size_t           numberOfMaterials{ 0 };

  /** Labels are continued beyond the border: the voxel nearest to a node outside the image stands for it. */
  Material
  AtNearest(const Index & at) const
  {
    return materials[grid.Offset(grid.Clamp(at))];
  }
};
} // namespace mmm

#endif
