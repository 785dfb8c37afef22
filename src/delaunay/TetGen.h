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
#ifndef mmmTetGen_h
#define mmmTetGen_h

#include "mesh/TetrahedralMesh.h"

#include "itkMacro.h"

#include <string>

namespace mmm
{
/** \brief TetGen stopped at what it was given, and may do with other points. That memory runs out is no such failure.
 */
class TetGenFailure : public itk::ExceptionObject
{
public:
  using itk::ExceptionObject::ExceptionObject;
};

/** The Delaunay tetrahedralization of a set of points, positively oriented and sorted by smallest corners. Throws
 * TetGenFailure with TetGen's own words where it fails. */
std::vector<Tetrahedron>
DelaunayTetrahedralization(const std::vector<Vector> & points);

/** \brief The constrained Delaunay tetrahedralization of facets, without Steiner points on them, up to the convex hull.
 *
 * Tetrahedra are oriented and sorted likewise. `points` holds the facets' points and others. Points keep their numbers;
 * those that TetGen had to add between the facets in order to recover them are appended. Throws TetGenFailure
 * with TetGen's own words where it fails. */
std::vector<Tetrahedron>
ConstrainedTetrahedralization(std::vector<Vector> & points, const std::vector<Triangle> & facets);

/** The facets that cross others, by their numbers, in a sentence to follow another one; empty if TetGen finds none. It
 * takes longer than the tetrahedralization: call it only after that has failed. */
std::string
DescribeIntersections(const std::vector<Vector> & points, const std::vector<Triangle> & facets);
} // namespace mmm

#endif
