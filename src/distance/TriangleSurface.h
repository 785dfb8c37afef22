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
#ifndef mmmTriangleSurface_h
#define mmmTriangleSurface_h

#include "base/Grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mmm
{
/** Triangles that are to enclose something, as files have them. */
struct TriangleSurface
{
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Vector>   points;
  std::vector<Triangle> triangles;
};

/** What keeps a surface from being the boundary of a solid. */
struct SurfaceDefects
{
  /** Edges of a single triangle, and the middle of one of them. */
  std::size_t boundaryEdges{ 0 };
  Vector      boundaryPlace{ Vector::Zero() };
  /** Edges of more than two triangles. */
  std::size_t branchingEdges{ 0 };
  /** Triangles that went round the other way than most of those that they are connected to. */
  std::size_t turnedTriangles{ 0 };
};

/** Joins points that are the same, leaves out triangles of less than three points, and turns triangles so that those
 * on both sides of an edge go round alike. Tells what there was. */
SurfaceDefects
RepairSurface(TriangleSurface & surface);
} // namespace mmm

#endif
