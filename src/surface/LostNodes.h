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
#ifndef mmmLostNodes_h
#define mmmLostNodes_h

#include "indicators/IndicatorSet.h"
#include "mesh/TetrahedralMesh.h"

namespace mmm
{
/** \brief The grid nodes that lie in a tetrahedron of another material. Both lists are sorted. */
struct LostNodes
{
  /** Those whose 6 neighbours of their own material are lost, too: it is not the interface that is a little off, but a
   * thread, a sheet or a tip is gone. */
  std::vector<std::size_t> parts;
  /** The others of small labels that lose more than a few of their nodes. */
  std::vector<std::size_t> corners;
};

/** What a labelled tetrahedralization misses; `exterior` is the material of what the tetrahedra do not fill. */
LostNodes
FindLostNodes(const IndicatorSet &        indicators,
              const std::vector<Vector> & points,
              const TetrahedralMesh &     mesh,
              Material                    exterior);
} // namespace mmm

#endif
