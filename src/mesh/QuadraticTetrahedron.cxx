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
#include "mesh/QuadraticTetrahedron.h"

#include "mesh/TetrahedronQuality.h"

#include <algorithm>
#include <numeric>

namespace mmm
{
JacobianCoefficients
ComputeJacobianCoefficients(const QuadraticTetrahedron & nodes)
{
  // the control points b[i][j] of the same tetrahedron in Bernstein's basis of degree 2
  Vector control[4][4];
  for (int corner = 0; corner < 4; ++corner)
  {
    control[corner][corner] = nodes[corner];
  }
  for (int edge = 0; edge < 6; ++edge)
  {
    const int i = TetrahedronEdges[edge][0];
    const int j = TetrahedronEdges[edge][1];
    control[i][j] = control[j][i] = 2.0 * nodes[4 + edge] - 0.5 * (nodes[i] + nodes[j]);
  }
  // the derivatives along the edges from corner 0, which are linear: their values at the corners
  Vector derivatives[3][4];
  for (int direction = 0; direction < 3; ++direction)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      derivatives[direction][corner] = 2.0 * (control[direction + 1][corner] - control[0][corner]);
    }
  }
  // the product of three linear functions: the mean over all ways to share three corners out among them
  JacobianCoefficients coefficients;
  std::size_t          n = 0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i; j < 4; ++j)
    {
      for (int k = j; k < 4; ++k)
      {
        std::array<int, 3> corners{ { i, j, k } };
        double             sum = 0.0;
        int                count = 0;
        do
        {
          sum += derivatives[0][corners[0]].dot(derivatives[1][corners[1]].cross(derivatives[2][corners[2]]));
          ++count;
        } while (std::next_permutation(corners.begin(), corners.end()));
        coefficients[n++] = sum / count;
      }
    }
  }
  return coefficients;
}

double
SmallestJacobian(const QuadraticTetrahedron & nodes)
{
  const auto coefficients = ComputeJacobianCoefficients(nodes);
  return *std::min_element(coefficients.begin(), coefficients.end());
}

double
QuadraticVolume(const QuadraticTetrahedron & nodes)
{
  const auto coefficients = ComputeJacobianCoefficients(nodes);
  return std::accumulate(coefficients.begin(), coefficients.end(), 0.0) / (6.0 * double(coefficients.size()));
}
} // namespace mmm
