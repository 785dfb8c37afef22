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
#ifndef mmmTetrahedronMeasurement_h
#define mmmTetrahedronMeasurement_h

#include "quality/MeshQuality.h"

namespace mmm
{
/** Measures the shapes of all tetrahedra, by region and in all, and lists the poorest: the report has the regions'
 * labels. */
void
MeasureTetrahedra(const std::vector<Vector> &        points,
                  const std::vector<Tetrahedron> &   tetrahedra,
                  const std::vector<std::uint32_t> & regions,
                  const MeshQualityOptions &         options,
                  MeshQualityReport &                report);
} // namespace mmm

#endif
