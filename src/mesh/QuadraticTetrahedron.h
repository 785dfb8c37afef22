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
#ifndef mmmQuadraticTetrahedron_h
#define mmmQuadraticTetrahedron_h

#include "base/Grid.h"

#include <array>

namespace mmm
{
/** The places of the ten nodes of a second-order tetrahedron: the corners, then the mid-nodes in the order of
 * TetrahedronEdges. */
using QuadraticTetrahedron = std::array<Vector, 10>;

/** The coefficients, in Bernstein's basis of degree 3, of a tetrahedron's Jacobian. */
using JacobianCoefficients = std::array<double, 20>;

/** \brief The determinant of the Jacobian of the way from the unit tetrahedron to a second-order one, as a polynomial.
 *
 * The determinant lies between the smallest and the largest coefficient all over the tetrahedron, and its integral is
 * the mean of them / 6. All are six times the volume, with its sign, where the edges are straight. */
JacobianCoefficients
ComputeJacobianCoefficients(const QuadraticTetrahedron & nodes);

/** A lower bound of the determinant all over the tetrahedron. */
double
SmallestJacobian(const QuadraticTetrahedron & nodes);

/** The volume, in which parts that are turned inside out count negative. */
double
QuadraticVolume(const QuadraticTetrahedron & nodes);
} // namespace mmm

#endif
