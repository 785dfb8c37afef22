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
#include "optimize/TriangulationConstraint.h"

#include "base/DisjointSets.h"
#include "mesh/Incidence.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
Vector
RoundOff(const Vector & chord, const Vector & tangents, double tolerance)
{
  const Vector rise = TriangulationParameters::Roundness * (tangents - chord);
  const double height = rise.norm();
  return chord + (height > tolerance ? tolerance / height : 1.0) * rise;
}

double
ReachOf(double tolerance, double cosine, double longest)
{
  // a facet that is turned by an angle rises by its sine
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return std::min(longest, tolerance / std::max(sine, 1e-9));
}
} // namespace

TriangulationConstraint::TriangulationConstraint(const std::vector<Vector> & points,
                                                 const TetrahedralMesh &     mesh,
                                                 Material                    outside,
                                                 double                      tolerance,
                                                 double                      featureAngle)
  : InterfaceConstraint(std::vector<Cell>(points.size()))
  , m_Outside(outside)
  , m_Tolerance(tolerance)
  , m_LeastCosine(std::cos(featureAngle * itk::Math::pi / 180.0))
  , m_Points(points)
  , m_Interfaces(ExtractInterfaces(mesh, outside))
  , m_Patches(FindSmoothPatches(points, m_Interfaces, m_LeastCosine))
  , m_CornerNormals(m_Interfaces.triangles.size())
  , m_Homes(points.size())
{
  this->MeasureTriangles();
  this->GiveCells(mesh);
  this->ClassifyPoints();
  this->FindCurves();
}

double
TriangulationConstraint::ToleranceAt(double edgeLength) const
{
  return std::isnan(m_Tolerance) ? TriangulationParameters::ToleranceOfEdges * edgeLength : m_Tolerance;
}

/** What closest points are looked up in, and how far from each triangle interfaces may go. */
void
TriangulationConstraint::MeasureTriangles()
{
  std::vector<TriangleTree::Corners> corners;
  for (const auto & triangle : m_Interfaces.triangles)
  {
    const Vector & a = m_Points[triangle[0]];
    const Vector & b = m_Points[triangle[1]];
    const Vector & c = m_Points[triangle[2]];
    corners.push_back({ { a, b, c } });
    double length = 0.0;
    for (const Vector & edge : { Vector(a - b), Vector(b - c), Vector(c - a) })
    {
      length += edge.norm() / 3.0;
    }
    m_Tolerances.push_back(this->ToleranceAt(length));
    m_LargestTolerance = std::max(m_LargestTolerance, m_Tolerances.back());
  }
  m_TriangleTree = std::make_unique<TriangleTree>(std::move(corners));
}

/** The cell of a point of an interface is the materials that meet there. */
void
TriangulationConstraint::GiveCells(const TetrahedralMesh & mesh)
{
  std::vector<char> isOnInterface(m_Points.size(), 0);
  const auto        add = [this](PointId p, Material m) { m_Cells[p].Join(Cell{ m }); };
  for (std::size_t t = 0; t < m_Interfaces.triangles.size(); ++t)
  {
    for (const auto corner : m_Interfaces.triangles[t])
    {
      isOnInterface[corner] = 1;
      add(corner, m_Interfaces.sides[t][0]);
      add(corner, m_Interfaces.sides[t][1]);
    }
  }
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
  {
    for (const auto corner : mesh.tetrahedra[t])
    {
      if (isOnInterface[corner])
      {
        add(corner, mesh.materials[t]);
      }
    }
  }
}

/** Makes a point's cell one of dimension 0. */
void
TriangulationConstraint::Fix(PointId p)
{
  const Cell materials = m_Cells[p];
  for (const Material m : materials)
  {
    if (m_Cells[p].Dimension() > 0)
    {
      m_Cells[p].Join(Cell{ this->CreaseOf(m) });
    }
  }
}

/** Whether triangles are one fan around p. */
bool
TriangulationConstraint::IsSurrounded(PointId p, const std::uint32_t * begin, const std::uint32_t * end) const
{
  std::vector<std::array<PointId, 2>> link;
  for (auto t = begin; t != end; ++t)
  {
    const Triangle & triangle = m_Interfaces.triangles[*t];
    const auto       own = std::find(triangle.begin(), triangle.end(), p) - triangle.begin();
    link.push_back({ { triangle[(own + 1) % 3], triangle[(own + 2) % 3] } });
  }
  PointId     at = link.front()[0];
  std::size_t steps = 0;
  do
  {
    const auto next = std::find_if(link.begin(), link.end(), [at](const auto & edge) { return edge[0] == at; });
    if (next == link.end())
    {
      return false;
    }
    at = (*next)[1];
    ++steps;
  } while (at != link.front()[0] && steps <= link.size());
  return steps == link.size();
}

/** The normal of each patch at p, the mean of its triangles' weighted by area. */
void
TriangulationConstraint::FindCornerNormals(const std::uint32_t * begin, const std::uint32_t * end, PointId p)
{
  for (auto t = begin; t != end; ++t)
  {
    Vector sum = Vector::Zero();
    for (auto other = begin; other != end; ++other)
    {
      if (m_Patches.ofTriangles[*other] == m_Patches.ofTriangles[*t])
      {
        const Triangle & corners = m_Interfaces.triangles[*other];
        sum += (m_Points[corners[1]] - m_Points[corners[0]]).cross(m_Points[corners[2]] - m_Points[corners[0]]);
      }
    }
    const Triangle & corners = m_Interfaces.triangles[*t];
    m_CornerNormals[*t][std::find(corners.begin(), corners.end(), p) - corners.begin()] = sum.normalized();
  }
}

void
TriangulationConstraint::ClassifyPoints()
{
  const auto &    triangles = m_Interfaces.triangles;
  const Incidence trianglesAt(
    m_Points.size(), triangles.size(), [&](std::size_t t) -> const Triangle & { return triangles[t]; });
  const Incidence seamsAt(m_Points.size(),
                          m_Patches.seams.size(),
                          [&](std::size_t s) -> const std::array<PointId, 2> & { return m_Patches.seams[s].points; });
  for (PointId p = 0; p < m_Points.size(); ++p)
  {
    const auto first = trianglesAt.Begin(p);
    const auto last = trianglesAt.End(p);
    if (first == last)
    {
      continue; // on no interface
    }
    this->FindCornerNormals(first, last, p);
    Home & home = m_Homes[p];
    home.place = m_Points[p];
    const auto seams = seamsAt.Begin(p);
    const auto count = seamsAt.End(p) - seams;
    if (count == 0 && m_Cells[p].count == 2 && this->IsSurrounded(p, first, last))
    {
      double lengths = 0.0;
      for (auto t = first; t != last; ++t)
      {
        home.direction += m_Patches.normals[*t];
        for (const auto corner : triangles[*t])
        {
          lengths += 0.5 * (m_Points[corner] - m_Points[p]).norm() / double(last - first);
        }
      }
      home.direction.normalize();
      double cosine = 1.0;
      for (auto t = first; t != last; ++t)
      {
        cosine = std::min(cosine, home.direction.dot(m_Patches.normals[*t]));
      }
      home.part = m_Patches.ofTriangles[*first];
      home.reach = ReachOf(this->ToleranceAt(lengths), cosine, TriangulationParameters::LongestSlide * lengths);
      continue;
    }
    if (count == 2 && m_Patches.seams[seams[0]].triangles == m_Patches.seams[seams[1]].triangles &&
        m_Patches.seams[seams[0]].triangles <= 3)
    {
      const auto along = [&](std::uint32_t s) {
        const auto & ends = m_Patches.seams[s].points;
        return Vector(m_Points[ends[0] == p ? ends[1] : ends[0]] - m_Points[p]);
      };
      const Vector one = along(seams[0]);
      const Vector two = along(seams[1]);
      if (-one.dot(two) > m_LeastCosine * one.norm() * two.norm())
      {
        home.direction = (one.normalized() - two.normalized()).normalized();
        home.part = seams[0];
        const double length = 0.5 * (one.norm() + two.norm());
        home.reach = ReachOf(this->ToleranceAt(length),
                             home.direction.dot(one.normalized()),
                             TriangulationParameters::LongestSlide * length);
        if (m_Cells[p].count == 2)
        {
          m_Cells[p].Join(Cell{ this->CreaseOf(m_Cells[p].materials[0]) });
        }
        continue;
      }
    }
    this->Fix(p);
  }
}

/** Seams that points can slide across are one curve. */
void
TriangulationConstraint::FindCurves()
{
  DisjointSets sets(m_Patches.seams.size());
  for (std::uint32_t s = 0; s < m_Patches.seams.size(); ++s)
  {
    for (const PointId p : m_Patches.seams[s].points)
    {
      if (m_Cells[p].Dimension() == 1)
      {
        sets.Unite(s, m_Homes[p].part);
      }
    }
  }
  std::vector<TriangleTree::Corners> segments;
  for (std::uint32_t s = 0; s < m_Patches.seams.size(); ++s)
  {
    m_Curves.push_back(sets.Find(s));
    const auto & ends = m_Patches.seams[s].points;
    segments.push_back({ { m_Points[ends[0]], m_Points[ends[1]], m_Points[ends[1]] } });
  }
  for (PointId p = 0; p < m_Points.size(); ++p)
  {
    if (m_Cells[p].Dimension() == 1)
    {
      m_Homes[p].part = m_Curves[m_Homes[p].part];
    }
  }
  m_SeamTree = std::make_unique<TriangleTree>(std::move(segments));
}

/** Where a point of a triangle would be if the triangle were as curved as its corners' normals say. */
Vector
TriangulationConstraint::OnCurvedTriangle(std::uint32_t triangle, const Vector & x) const
{
  const Triangle & corners = m_Interfaces.triangles[triangle];
  const Vector &   normal = m_Patches.normals[triangle];
  Vector           curved = Vector::Zero();
  double           total = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const Vector & corner = m_Points[corners[c]];
    const Vector & tangentNormal = m_CornerNormals[triangle][c];
    const double   weight =
      std::max(0.0, normal.dot((m_Points[corners[(c + 1) % 3]] - x).cross(m_Points[corners[(c + 2) % 3]] - x)));
    curved += weight * (x - tangentNormal * tangentNormal.dot(x - corner));
    total += weight;
  }
  return total > 0.0 ? RoundOff(x, curved / total, m_Tolerances[triangle]) : x;
}

Vector
TriangulationConstraint::OnCurvedSeam(std::uint32_t seam, const Vector & x) const
{
  const auto &   ends = m_Patches.seams[seam].points;
  const Vector & a = m_Points[ends[0]];
  const Vector   chord = m_Points[ends[1]] - a;
  const double   share = (x - a).dot(chord) / chord.squaredNorm();
  Vector         curved = Vector::Zero();
  for (int e = 0; e < 2; ++e)
  {
    const PointId p = ends[e];
    const Vector  tangent = m_Cells[p].Dimension() == 1 ? m_Homes[p].direction : Vector(chord.normalized());
    curved += (e == 0 ? 1.0 - share : share) * (m_Points[p] + tangent * tangent.dot(x - m_Points[p]));
  }
  return RoundOff(x, curved, this->ToleranceAt(chord.norm()));
}

bool
TriangulationConstraint::Project(PointId p, Vector & x) const
{
  const Home & home = m_Homes[p];
  const double reach = home.reach + (x - home.place).norm();
  const auto   nearest = m_Cells[p].Dimension() == 2
                           ? m_TriangleTree->FindNearest(x,
                                                       reach,
                                                       [&](std::uint32_t t) {
                                                         return m_Patches.ofTriangles[t] == home.part &&
                                                                m_Patches.normals[t].dot(home.direction) >
                                                                  TriangulationParameters::LeastAlignment;
                                                       })
                           : m_SeamTree->FindNearest(x, reach, [&](std::uint32_t s) { return m_Curves[s] == home.part; });
  if (nearest.triangle == TriangleTree::None || (nearest.point - home.place).norm() > home.reach)
  {
    return false;
  }
  x = m_Cells[p].Dimension() == 2 ? this->OnCurvedTriangle(nearest.triangle, nearest.point)
                                  : this->OnCurvedSeam(nearest.triangle, nearest.point);
  return true;
}

bool
TriangulationConstraint::MayLeaveCell(PointId) const
{
  return false;
}

Vector
TriangulationConstraint::AlongCell(PointId p, const Vector &, const Vector & direction) const
{
  const Vector & own = m_Homes[p].direction;
  const Vector   along = own * own.dot(direction);
  return m_Cells[p].Dimension() == 2 ? Vector(direction - along) : along;
}

double
TriangulationConstraint::DistanceToInterface(Material a, Material b, const Vector & x, PointId) const
{
  const std::array<Material, 2> sides{ { std::min(a, b), std::max(a, b) } };
  const auto                    nearest = m_TriangleTree->FindNearest(x,
                                                   TriangulationParameters::ReachInTolerances * m_LargestTolerance,
                                                   [&](std::uint32_t t) { return m_Interfaces.sides[t] == sides; });
  return nearest.triangle == TriangleTree::None ? NoInterface : nearest.distance / m_Tolerances[nearest.triangle];
}
} // namespace mmm
