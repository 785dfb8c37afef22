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
#ifndef mmmPlanarCells_h
#define mmmPlanarCells_h

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace mmm
{
using PlanarPoint = std::array<double, 2>;
using PlanarEdge = std::array<std::uint32_t, 2>;
/** Points one after the other, by index. */
using PlanarLine = std::vector<std::uint32_t>;

/** A triangle or quadrilateral of a plane: its corners by index, the last one NoCorner for a triangle. */
struct PlanarCell
{
  static constexpr std::uint32_t NoCorner = 0xffffffffu;

  std::array<std::uint32_t, 4> corners;
  int                          label;

  std::size_t
  CountCorners() const
  {
    return corners[3] == NoCorner ? 3 : 4;
  }
};

/** \brief Labelled cells of a plane over common points: what a plane cuts from tetrahedra or from voxels. All are
 * counter-clockwise with the first coordinate to the right and the second one upwards. */
struct PlanarCells
{
  std::vector<PlanarPoint> points;
  std::vector<PlanarCell>  cells;
};

/** Segments of a plane over common points. */
struct PlanarEdges
{
  std::vector<PlanarPoint> points;
  std::vector<PlanarEdge>  edges;
};

/** Twice the area of a cell, positive if it is counter-clockwise. */
double
TwiceArea(const std::vector<PlanarPoint> & points, const PlanarCell & cell);

/** The area of each label. */
std::map<int, double>
AreasByLabel(const PlanarCells & cells);

/** The edges of the cells, each once. */
std::vector<PlanarEdge>
EdgesOf(const std::vector<PlanarCell> & cells);
} // namespace mmm

#endif
