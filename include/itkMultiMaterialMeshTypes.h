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
#ifndef itkMultiMaterialMeshTypes_h
#define itkMultiMaterialMeshTypes_h

#include "itkDefaultStaticMeshTraits.h"
#include "itkFixedArray.h"
#include "itkMesh.h"

namespace itk
{
/** Tetrahedra, each with its label as cell data. */
using LabelTetrahedralMesh = Mesh<int, 3, DefaultStaticMeshTraits<int, 3, 3, double>>;

/** Triangles between labels. The cell data is the two labels, the lower one first; the normal points from the first
 * to the second. */
using LabelInterfaceMesh = Mesh<FixedArray<int, 2>, 3, DefaultStaticMeshTraits<FixedArray<int, 2>, 3, 3, double>>;

/** Particles: points without cells. The point data is the dimension of the cell that a particle lies on (0 where four
 * labels meet, 1 where three do, 2 on the surface between two) and the labels that meet there, sorted, the last one
 * repeated to fill the four places. */
using LabelParticleMesh = Mesh<FixedArray<int, 5>, 3, DefaultStaticMeshTraits<FixedArray<int, 5>, 3, 3, double>>;

/** Curves and points where labels meet: lines and vertices. The lines of a curve follow each other, each from the end
 * of the one before. The cell data is the number of the curve, or -1 for a point; how many labels meet; and the first
 * four of them, sorted, the last one repeated to fill the four places. */
using LabelJunctionMesh = Mesh<FixedArray<int, 6>, 3, DefaultStaticMeshTraits<FixedArray<int, 6>, 3, 3, double>>;

/** What makes tetrahedra, and triangles between them, elements of second order: the mid-nodes of the curved edges,
 * which are edges of triangles. Points without cells; the point data is the two ends of the edge, by their numbers
 * among the points of the tetrahedra, the lower one first. All other edges are straight, with their mid-nodes halfway.
 */
using LabelMidNodeMesh = Mesh<FixedArray<int, 2>, 3, DefaultStaticMeshTraits<FixedArray<int, 2>, 3, 3, double>>;
} // namespace itk

#endif
