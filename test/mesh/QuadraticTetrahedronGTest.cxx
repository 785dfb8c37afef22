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

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

using mmm::QuadraticTetrahedron;
using mmm::Vector;

namespace
{
const QuadraticTetrahedron Corners{
  { Vector(0.1, 0.2, -0.3), Vector(1.3, 0.1, 0.2), Vector(0.2, 1.1, 0.1), Vector(-0.1, 0.3, 1.2) }
};

double
StraightJacobian(const QuadraticTetrahedron & nodes)
{
  return 6.0 * mmm::TetrahedronVolume(nodes[0], nodes[1], nodes[2], nodes[3]);
}

/** The corners, and the mid-nodes halfway. */
QuadraticTetrahedron
MakeStraight()
{
  QuadraticTetrahedron nodes = Corners;
  for (int e = 0; e < 6; ++e)
  {
    nodes[4 + e] = 0.5 * (nodes[mmm::TetrahedronEdges[e][0]] + nodes[mmm::TetrahedronEdges[e][1]]);
  }
  return nodes;
}

/** The place at barycentric coordinates, by the shape functions of second order. */
Vector
PlaceAt(const QuadraticTetrahedron & nodes, const Eigen::Vector4d & at)
{
  Vector place = Vector::Zero();
  for (int c = 0; c < 4; ++c)
  {
    place += at[c] * (2.0 * at[c] - 1.0) * nodes[c];
  }
  for (int e = 0; e < 6; ++e)
  {
    place += 4.0 * at[mmm::TetrahedronEdges[e][0]] * at[mmm::TetrahedronEdges[e][1]] * nodes[4 + e];
  }
  return place;
}

/** By differences, which are exact for functions of second degree. */
double
JacobianAt(const QuadraticTetrahedron & nodes, const Eigen::Vector4d & at)
{
  constexpr double step = 0.125;
  Eigen::Matrix3d  jacobian;
  for (int axis = 0; axis < 3; ++axis)
  {
    Eigen::Vector4d along = Eigen::Vector4d::Zero();
    along[0] = -step;
    along[axis + 1] = step;
    jacobian.col(axis) = (PlaceAt(nodes, at + along) - PlaceAt(nodes, at - along)) / (2.0 * step);
  }
  return jacobian.determinant();
}
} // namespace

TEST(QuadraticTetrahedron, OfStraightEdgesHasTheSameJacobianEverywhere)
{
  const auto nodes = MakeStraight();
  for (const double coefficient : mmm::ComputeJacobianCoefficients(nodes))
  {
    EXPECT_NEAR(coefficient, StraightJacobian(nodes), 1e-14);
  }
  EXPECT_NEAR(mmm::QuadraticVolume(nodes), StraightJacobian(nodes) / 6.0, 1e-14);
}

TEST(QuadraticTetrahedron, KeepsItsVolumeUnderAShearOfSecondDegree)
{
  auto nodes = MakeStraight();
  for (Vector & node : nodes)
  {
    node[2] += 0.3 * node[0] * node[0] - 0.5 * node[0] * node[1] + 0.2 * node[1];
  }
  EXPECT_NEAR(mmm::QuadraticVolume(nodes), StraightJacobian(MakeStraight()) / 6.0, 1e-14);
  EXPECT_GT(std::abs(StraightJacobian(nodes) / StraightJacobian(MakeStraight()) - 1.0), 0.01);
}

TEST(QuadraticTetrahedron, CoefficientsBoundTheJacobianAndAreItAtTheCorners)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial)
  {
    auto nodes = MakeStraight();
    for (int n = 4; n < 10; ++n)
    {
      nodes[n] += 0.2 * Vector(draw(random) - 0.5, draw(random) - 0.5, draw(random) - 0.5);
    }
    const auto   coefficients = mmm::ComputeJacobianCoefficients(nodes);
    const double smallest = mmm::SmallestJacobian(nodes);
    const double largest = *std::max_element(coefficients.begin(), coefficients.end());
    for (int sample = 0; sample < 100; ++sample)
    {
      Eigen::Vector4d at(
        -std::log(draw(random)), -std::log(draw(random)), -std::log(draw(random)), -std::log(draw(random)));
      at /= at.sum();
      const double jacobian = JacobianAt(nodes, at);
      EXPECT_GE(jacobian, smallest - 1e-12);
      EXPECT_LE(jacobian, largest + 1e-12);
    }
    for (const auto & [coefficient, corner] : { std::make_pair(0, 0), std::make_pair(19, 3) })
    {
      EXPECT_NEAR(coefficients[coefficient], JacobianAt(nodes, Eigen::Vector4d::Unit(corner)), 1e-12);
    }
  }
}

TEST(QuadraticTetrahedron, TurnedInsideOutHasANegativeBound)
{
  auto nodes = MakeStraight();
  nodes[4] += 0.8 * (nodes[3] - nodes[4]); // the middle of the edge 0-1, to the opposite corner
  EXPECT_LT(mmm::SmallestJacobian(nodes), 0.0);
}
