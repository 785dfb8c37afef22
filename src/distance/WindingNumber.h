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
#ifndef mmmWindingNumber_h
#define mmmWindingNumber_h

#include "distance/TriangleTree.h"

namespace mmm
{
/** \brief How often triangles wind around a point (Jacobson 2013): 1 inside a closed surface whose normals point
 * outward and 0 outside, and something between where the surface has holes.
 *
 * It is the sum of the solid angles of the triangles over 4 pi; the sum over triangles that are far away is that of
 * their areas' dipole (Barill 2018), which is right within about a hundredth. */
class WindingNumber
{
public:
  /** The tree must outlive this object. */
  explicit WindingNumber(const TriangleTree & tree);

  double
  At(const Vector & x) const;

private:
  /** Of a node: the sum of area times normal, the middle of the area, and how far triangles go from there. */
  struct Dipole
  {
    Vector area{ Vector::Zero() };
    Vector middle{ Vector::Zero() };
    double radius{ 0.0 };
  };

  Dipole
  MakeDipole(const TriangleTree::Node & node) const;

  const TriangleTree & m_Tree;
  std::vector<Dipole>  m_Dipoles;
};
} // namespace mmm

#endif
