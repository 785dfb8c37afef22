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
#include "itkLabelHullMeshFilter.h"

#include "base/DisjointSets.h"
#include "output/OrientedTriangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace itk
{
namespace
{
using Triangles = std::vector<mmm::OrientedTriangle>;
using Vector = LabelInterfaceMesh::PointType::VectorType;

/** An edge of a triangle: its points in ascending order, the triangle, and where the points are among its corners. */
struct Edge
{
  std::array<IdentifierType, 2> points;
  std::uint32_t                 triangle;
  std::array<std::uint32_t, 2>  corners;
};

/** The edges of all triangles; those between the same points follow each other. */
std::vector<Edge>
FindEdges(const Triangles & triangles)
{
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    const auto & corners = triangles[t].corners;
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      const std::uint32_t next = (k + 1) % 3;
      const bool          isUp = corners[k] < corners[next];
      const auto          low = isUp ? k : next;
      const auto          high = isUp ? next : k;
      edges.push_back({ { corners[low], corners[high] }, t, { 3 * t + low, 3 * t + high } });
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge & a, const Edge & b) { return a.points < b.points; });
  return edges;
}

/** Calls body(edge, next) for each two that follow each other between the same points. */
template <typename TBody>
void
ForEachPair(const std::vector<Edge> & edges, const TBody & body)
{
  for (std::size_t e = 1; e < edges.size(); ++e)
  {
    if (edges[e - 1].points == edges[e].points)
    {
      body(edges[e - 1], edges[e]);
    }
  }
}

/** What hangs together by edges. */
std::vector<Triangles>
SplitIntoParts(const Triangles & triangles)
{
  mmm::DisjointSets sets(triangles.size());
  ForEachPair(FindEdges(triangles), [&](const Edge & a, const Edge & b) { sets.Unite(a.triangle, b.triangle); });
  std::map<std::uint32_t, std::size_t> places;
  std::vector<Triangles>               parts;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    const std::size_t place = places.emplace(sets.Find(t), parts.size()).first->second;
    parts.resize(std::max(parts.size(), place + 1));
    parts[place].push_back(triangles[t]);
  }
  return parts;
}

std::array<Vector, 3>
CornersFrom(const LabelInterfaceMesh & mesh, const mmm::OrientedTriangle & triangle, const Vector & origin)
{
  std::array<Vector, 3> corners;
  std::transform(triangle.corners.begin(), triangle.corners.end(), corners.begin(), [&](IdentifierType corner) {
    return mesh.GetPoint(corner).GetVectorFromOrigin() - origin;
  });
  return corners;
}

double
Determinant(const std::array<Vector, 3> & vectors)
{
  return vectors[0] * CrossProduct(vectors[1], vectors[2]);
}

/** Negative for the wall of a cavity. */
double
VolumeWithin(const LabelInterfaceMesh & mesh, const Triangles & part)
{
  const Vector origin = mesh.GetPoint(part.front().corners[0]).GetVectorFromOrigin();
  double       volume = 0.0;
  for (const auto & triangle : part)
  {
    volume += Determinant(CornersFrom(mesh, triangle, origin)) / 6.0;
  }
  return volume;
}

/** Whether one part is within another, which it does not cross: a point of it sees the other's triangles all around,
 * under a solid angle of 4 pi, or under one of 0 (Van Oosterom and Strackee 1983). */
bool
IsWithin(const LabelInterfaceMesh & mesh, const Triangles & part, const Triangles & other)
{
  Vector center;
  center.Fill(0.0);
  for (const IdentifierType corner : part.front().corners)
  {
    center += mesh.GetPoint(corner).GetVectorFromOrigin() / 3.0;
  }
  double halfAngle = 0.0;
  for (const auto & triangle : other)
  {
    const auto corners = CornersFrom(mesh, triangle, center);
    const auto & [a, b, c] = corners;
    const double la = a.GetNorm();
    const double lb = b.GetNorm();
    const double lc = c.GetNorm();
    halfAngle += std::atan2(Determinant(corners), la * lb * lc + a * b * lc + b * c * la + c * a * lb);
  }
  return halfAngle > Math::pi;
}

struct Counts
{
  SizeValueType points{ 0 };
  SizeValueType edges{ 0 };
  SizeValueType pinchedPoints{ 0 };
  SizeValueType pinchedEdges{ 0 };
};

Counts
Count(const Triangles & triangles)
{
  const auto        edges = FindEdges(triangles);
  Counts            counts;
  mmm::DisjointSets fans(3 * triangles.size());
  std::size_t       equal = 0;
  ForEachPair(edges, [&](const Edge & a, const Edge & b) {
    fans.Unite(a.corners[0], b.corners[0]);
    fans.Unite(a.corners[1], b.corners[1]);
    ++equal;
  });
  counts.edges = edges.size() - equal;
  for (std::size_t e = 2; e < edges.size(); ++e)
  {
    const bool isThird = edges[e - 2].points == edges[e].points;
    const bool isFourth = e > 2 && edges[e - 3].points == edges[e].points;
    counts.pinchedEdges += isThird && !isFourth;
  }
  std::map<IdentifierType, SizeValueType> fansOfPoints;
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner)
  {
    fansOfPoints[triangles[corner / 3].corners[corner % 3]] += fans.Find(corner) == corner;
  }
  counts.points = fansOfPoints.size();
  counts.pinchedPoints =
    std::count_if(fansOfPoints.begin(), fansOfPoints.end(), [](const auto & entry) { return entry.second > 1; });
  return counts;
}
} // namespace

void
LabelHullMeshFilter::SetLabels(const LabelsType & labels)
{
  if (labels != m_Labels)
  {
    m_Labels = labels;
    this->Modified();
  }
}

void
LabelHullMeshFilter::GenerateData()
{
  const LabelInterfaceMesh & mesh = *this->GetInput();
  const auto                 parts = SplitIntoParts(mmm::FindSurface(mesh, m_Labels));
  if (parts.empty())
  {
    itkExceptionMacro("None of the labels of the hull has a surface.");
  }
  std::vector<double> volumes;
  for (const Triangles & part : parts)
  {
    volumes.push_back(VolumeWithin(mesh, part));
  }
  const auto        largest = std::max_element(volumes.begin(), volumes.end()) - volumes.begin();
  const Triangles & hull = parts[largest];
  m_NumberOfOtherParts = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    m_NumberOfOtherParts += &parts[p] != &hull && volumes[p] > 0.0 && !IsWithin(mesh, parts[p], hull);
  }
  const Counts counts = Count(hull);
  m_NumberOfPinchedEdges = counts.pinchedEdges;
  m_NumberOfPinchedPoints = counts.pinchedPoints;
  const bool isManifold = counts.pinchedEdges + counts.pinchedPoints == 0;
  // points - edges + triangles = 2 - 2 handles
  m_NumberOfHandles = isManifold ? (2 + counts.edges - counts.points - hull.size()) / 2 : 0;
  mmm::SetTriangles(mesh, hull, this->GetOutput());
}

void
LabelHullMeshFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Labels:";
  for (const int label : m_Labels)
  {
    os << ' ' << label;
  }
  os << '\n';
  os << indent << "NumberOfOtherParts: " << m_NumberOfOtherParts << '\n';
  os << indent << "NumberOfPinchedEdges: " << m_NumberOfPinchedEdges << '\n';
  os << indent << "NumberOfPinchedPoints: " << m_NumberOfPinchedPoints << '\n';
  os << indent << "NumberOfHandles: " << m_NumberOfHandles << '\n';
}
} // end namespace itk
