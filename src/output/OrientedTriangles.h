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
#ifndef mmmOrientedTriangles_h
#define mmmOrientedTriangles_h

#include "itkMultiMaterialMeshTypes.h"

#include <array>
#include <vector>

namespace mmm
{
/** Corners are numbers of points. The normal points from the first of the two labels to the second. */
struct OrientedTriangle
{
  std::array<itk::IdentifierType, 3> corners;
  itk::FixedArray<int, 2>            sides;
};

/** The triangles between the labels and all others, the labels' side first. */
std::vector<OrientedTriangle>
FindSurface(const itk::LabelInterfaceMesh & mesh, const std::vector<int> & labels);

/** A mesh of triangles of the source, with the points that they have. */
void
SetTriangles(const itk::LabelInterfaceMesh &       source,
             const std::vector<OrientedTriangle> & triangles,
             itk::LabelInterfaceMesh *             mesh);
} // namespace mmm

#endif
