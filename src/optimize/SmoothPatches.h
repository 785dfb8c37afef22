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
#ifndef mmmSmoothPatches_h
#define mmmSmoothPatches_h

#include "mesh/InterfaceMesh.h"

namespace mmm
{
/** \brief Triangles of the same two materials are one patch where they meet smoothly; all other edges are seams. */
struct SmoothPatches
{
  struct Seam
  {
    std::array<PointId, 2> points;
    std::size_t            triangles;
  };

  /** Of triangles. */
  std::vector<Vector>        normals;
  std::vector<std::uint32_t> ofTriangles;
  std::vector<Seam>          seams;
};

/** Normals differ by less than the angle of a cosine within a patch. */
SmoothPatches
FindSmoothPatches(const std::vector<Vector> & points, const InterfaceMesh & interfaces, double leastCosine);
} // namespace mmm

#endif
