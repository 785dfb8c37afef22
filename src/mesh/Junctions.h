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
#ifndef mmmJunctions_h
#define mmmJunctions_h

#include "base/Grid.h"
#include "mesh/InterfaceMesh.h"

#include <vector>

namespace mmm
{
/** The materials that meet, sorted, each once. */
using MaterialList = std::vector<Material>;

/** A polyline of edges with the same materials around them. */
struct JunctionCurve
{
  /** From one junction point to another, or closed: the first point is the last one, too. */
  std::vector<PointId> points;
  MaterialList         materials;
};

/** A point where curves end or more than three materials meet. */
struct JunctionPoint
{
  PointId      point;
  MaterialList materials;
};

struct Junctions
{
  std::vector<JunctionCurve> curves;
  /** By ascending number. */
  std::vector<JunctionPoint> points;
};

/** The sides of the triangles, with the plane of the image's box that a triangle lies in, if there is one, instead of
 * `outside`. The planes are the materials from `numberOfMaterials` on, as in IndicatorSet. */
std::vector<std::array<Material, 2>>
SidesWithPlanes(const InterfaceMesh &       interfaces,
                const std::vector<Vector> & points,
                const Grid &                grid,
                std::size_t                 numberOfMaterials,
                Material                    outside);

/** \brief The curves and points of a mesh where three and more materials meet, the planes of the image's box included.
 *
 * A triangle that lies in a plane has it at its side, see SidesWithPlanes(). So the edges and corners of the box and
 * the rims of cuts are junctions as well. */
Junctions
ExtractJunctions(const InterfaceMesh &       interfaces,
                 const std::vector<Vector> & points,
                 const Grid &                grid,
                 std::size_t                 numberOfMaterials,
                 Material                    outside);
} // namespace mmm

#endif
