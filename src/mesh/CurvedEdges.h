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
#ifndef mmmCurvedEdges_h
#define mmmCurvedEdges_h

#include "mesh/TetrahedralMesh.h"

#include <array>
#include <vector>

namespace mmm
{
/** \brief An edge of a second-order mesh whose mid-node is not halfway. */
struct CurvedEdge
{
  /** The lower number first. */
  std::array<PointId, 2> ends;
  /** The place of the mid-node. */
  Vector middle;

  friend bool
  operator<(const CurvedEdge & a, const CurvedEdge & b)
  {
    return a.ends < b.ends;
  }
};

/** Sorted by their ends. All other edges of the mesh are straight, with their mid-nodes halfway. */
using CurvedEdges = std::vector<CurvedEdge>;
} // namespace mmm

#endif
