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
#include "optimize/SideChanger.h"

#include "optimize/ShapeQuality.h"

#include <algorithm>

namespace mmm
{
using Id = OptimizerState::Id;

bool
SideChanger::GiveToOtherSide(Id t)
{
  Faces faces;
  if (!this->SortFaces(t, faces))
  {
    return false;
  }
  switch (faces.onInterface)
  {
    case 1:
      return this->ChangeOneFace(t, faces);
    case 2:
      return this->ChangeTwoFaces(t, faces);
    case 3:
      return this->ChangeThreeFaces(t, faces);
    default:
      return false;
  }
}

/** False where more than one material lies beyond. What is beyond the convex hull is exterior. */
bool
SideChanger::SortFaces(Id t, Faces & faces) const
{
  const Material own = m_State.complex.MaterialOf(t);
  int            inside = 4;
  faces.onInterface = 0;
  for (int f = 0; f < 4; ++f)
  {
    const Id       other = m_State.complex.Neighbour(t, f);
    const Material m = other == NoTetrahedron ? m_State.exterior : m_State.complex.MaterialOf(other);
    if (m == own)
    {
      faces.numbers[--inside] = f;
      continue;
    }
    if (faces.onInterface > 0 && m != faces.beyond)
    {
      return false;
    }
    faces.beyond = m;
    faces.numbers[faces.onInterface++] = f;
  }
  return faces.onInterface > 0;
}

/** Whether all around an edge, but one tetrahedron, is of one of two materials. */
bool
SideChanger::AllAround(Id t, PointId a, PointId b, Material first, Material second)
{
  m_State.complex.GetRing(t, a, b, m_Ring);
  return (m_Ring.closed || first == m_State.exterior || second == m_State.exterior) &&
         std::all_of(m_Ring.tetrahedra.begin(), m_Ring.tetrahedra.end(), [&](Id other) {
           const Material m = m_State.complex.MaterialOf(other);
           return other == t || m == first || m == second;
         });
}

bool
SideChanger::Give(Id t, Material material)
{
  m_State.complex.SetMaterial(t, material);
  ++m_State.report.relabelled;
  return true;
}

/** Gives t to a material if find(change) finds a change for it there, which is made. */
template <typename TFind>
bool
SideChanger::GiveAndChange(Id t, Material material, const TFind & find)
{
  const Material own = m_State.complex.MaterialOf(t);
  m_State.complex.SetMaterial(t, material);
  ComplexChange change;
  if (!find(change))
  {
    m_State.complex.SetMaterial(t, own);
    return false;
  }
  m_State.Make(change);
  ++m_State.report.relabelled;
  return true;
}

bool
SideChanger::ChangeOneFace(Id t, const Faces & faces)
{
  const auto     corners = m_State.complex.Corners(t);
  const Material own = m_State.complex.MaterialOf(t);
  const PointId  tip = corners[faces.numbers[0]];
  // within the mesh the tetrahedron would stay as it is
  if (faces.beyond != m_State.exterior ||
      m_State.DistanceToInterface(own, faces.beyond, m_State.points[tip], tip) > m_State.parameters.interfaceTolerance)
  {
    return false;
  }
  m_State.complex.GetStar(tip, m_Star);
  for (const Id s : m_Star)
  {
    for (int f = 0; f < 4; ++f)
    {
      if (m_State.complex.MaterialOf(s) != own ||
          (m_State.complex.Corners(s)[f] != tip && m_State.complex.Neighbour(s, f) == NoTetrahedron))
      {
        return false;
      }
    }
  }
  // the tip has to lie above the middle of the face: no fold
  const auto &   face = TetrahedronFaces[faces.numbers[0]];
  const Vector   x[3] = { m_State.points[corners[face[0]]],
                          m_State.points[corners[face[1]]],
                          m_State.points[corners[face[2]]] };
  const Vector   normal = (x[1] - x[0]).cross(x[2] - x[0]);
  const Vector & y = m_State.points[tip];
  for (int n = 0; n < 3; ++n)
  {
    if ((x[n] - y).cross(x[(n + 1) % 3] - y).dot(normal) <= 0.0 ||
        TriangleRadiusRatio(y, x[n], x[(n + 1) % 3]) < OptimizationParameters::TriangleFloorOfSplit)
    {
      return false;
    }
  }
  return this->Give(t, faces.beyond);
}

bool
SideChanger::ChangeTwoFaces(Id t, const Faces & faces)
{
  const auto     corners = m_State.complex.Corners(t);
  const Material own = m_State.complex.MaterialOf(t);
  const Material other = faces.beyond;
  // the two faces on the interface share an edge cd, and the two others share the opposite one, ab
  const PointId a = corners[faces.numbers[0]];
  const PointId b = corners[faces.numbers[1]];
  const PointId c = corners[faces.numbers[2]];
  const PointId d = corners[faces.numbers[3]];
  // others of its own material at cd only touch it there, which is better ended
  if (!this->AllAround(t, c, d, other, own) || !this->AllAround(t, a, b, own, own))
  {
    return false;
  }
  const auto & points = m_State.points;
  const double was = m_State.DistanceToInterface(own, other, 0.5 * (points[c] + points[d]), c);
  const double is = m_State.DistanceToInterface(own, other, 0.5 * (points[a] + points[b]), a);
  if (is > std::max(was, m_State.parameters.interfaceTolerance))
  {
    return false;
  }
  const double worstBefore = std::min(TriangleRadiusRatio(points[c], points[d], points[a]),
                                      TriangleRadiusRatio(points[c], points[d], points[b]));
  const double worstAfter = std::min(TriangleRadiusRatio(points[a], points[b], points[c]),
                                     TriangleRadiusRatio(points[a], points[b], points[d]));
  if (worstAfter < std::min(worstBefore, OptimizerState::TriangleFloor(m_State.Quality(t))))
  {
    return own == m_State.exterior && this->CloseGap(t, a, b, other);
  }
  if (other == m_State.exterior)
  {
    return this->Give(t, other);
  }
  // within the mesh this is but a step towards taking it apart
  return this->GiveAndChange(t, other, [&](ComplexChange & change) {
    return m_EdgeRemover.FindForEdge(t, c, d, change) || m_EdgeRemover.FindAny(t, change);
  });
}

/** A narrow gap with an edge ab across its mouth: filled, and the edge pulled together. */
bool
SideChanger::CloseGap(Id t, PointId a, PointId b, Material material)
{
  const double least = QualityOfAngle(m_State.parameters.angleToKeepBesideTriangles);
  const double radiusRatio = OptimizerState::TriangleFloor(m_State.Quality(t));
  return this->GiveAndChange(t, material, [&](ComplexChange & change) {
    return m_EdgeCollapser.FindForTriangles(t, { a, b }, radiusRatio, least, change);
  });
}

bool
SideChanger::ChangeThreeFaces(Id t, const Faces & faces)
{
  const auto     corners = m_State.complex.Corners(t);
  const Material own = m_State.complex.MaterialOf(t);
  // The tip is opposite the face that is not on the interface. It is inside of the other material then, unless others
  // of its own material touch the tetrahedron there, which is better ended; but no junction may be cut off.
  const PointId tip = corners[faces.numbers[3]];
  m_State.complex.GetStar(tip, m_Star);
  bool touched = false;
  bool junction = false;
  for (const Id s : m_Star)
  {
    const Material m = m_State.complex.MaterialOf(s);
    touched = touched || (s != t && m == own);
    junction = junction || (m != own && m != faces.beyond);
  }
  if (junction && !touched)
  {
    return false;
  }
  Vector centre = Vector::Zero();
  double worstBefore = 1.0;
  for (int f = 0; f < 3; ++f)
  {
    const auto & face = TetrahedronFaces[faces.numbers[f]];
    centre += m_State.points[corners[faces.numbers[f]]] / 3.0;
    worstBefore =
      std::min(worstBefore,
               TriangleRadiusRatio(
                 m_State.points[corners[face[0]]], m_State.points[corners[face[1]]], m_State.points[corners[face[2]]]));
  }
  const PointId a = corners[faces.numbers[0]];
  const PointId b = corners[faces.numbers[1]];
  const PointId c = corners[faces.numbers[2]];
  if (m_State.DistanceToInterface(own, faces.beyond, centre, a) > m_State.parameters.interfaceTolerance ||
      TriangleRadiusRatio(m_State.points[a], m_State.points[b], m_State.points[c]) <
        std::min(worstBefore, OptimizerState::TriangleFloor(m_State.Quality(t))))
  {
    return false;
  }
  return this->Give(t, faces.beyond);
}
} // namespace mmm
