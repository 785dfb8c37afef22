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
#ifndef mmmMeshingPlace_h
#define mmmMeshingPlace_h

#include "base/Grid.h"

#include <vector>

namespace mmm
{
/** Somewhere in the mesh, and the labels that meet there. BuildMesh() gives the numbers of materials and a position in
 * the frame of Grid; the filters give labels and a physical point. */
struct MeshingPlace
{
  Vector           position;
  std::vector<int> labels;
};
} // namespace mmm

#endif
