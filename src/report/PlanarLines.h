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
#ifndef mmmPlanarLines_h
#define mmmPlanarLines_h

#include "report/PlanarCells.h"

namespace mmm
{
/** The closed lines around what the cells of each label fill, without edges between cells of the same label. The label
 * is on their left. The last point of a line is connected with the first one, which is not repeated. */
std::map<int, std::vector<PlanarLine>>
OutlinesByLabel(const std::vector<PlanarCell> & cells);

/** Few lines that pass each of these edges, which are distinct, once. */
std::vector<PlanarLine>
TrailsOf(const std::vector<PlanarEdge> & edges);
} // namespace mmm

#endif
