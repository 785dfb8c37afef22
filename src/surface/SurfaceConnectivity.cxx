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
#include "surface/SurfaceConnectivity.h"

#include "mesh/TetrahedronQuality.h"
#include "surface/SurfaceParameters.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace mmm
{
namespace
{
using Parameters = SurfaceRelaxationParameters;
} // namespace

SurfaceConnectivity::SurfaceConnectivity(const InterfaceMesh & interfaces, const std::vector<Vector> & points)
  : m_Triangles(interfaces.triangles)
{
  this->FindNeighbours(interfaces.sides);
  this->NumberSheetPoints(interfaces.sides);
  this->CountValences(points);
}

void
SurfaceConnectivity::FindNeighbours(const std::vector<std::array<Material, 2>> & sides)
{
  struct Side
  {
    PointId                 low;
    PointId                 high;
    std::array<Material, 2> sheet;
    Id                      triangle;
    int                     corner;
  };
  std::vector<Side> edges;
  edges.reserve(3 * m_Triangles.size());
  for (Id t = 0; t < m_Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const PointId a = m_Triangles[t][(c + 1) % 3];
      const PointId b = m_Triangles[t][(c + 2) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), sides[t], t, c });
    }
  }
  const auto isSame = [](const Side & x, const Side & y) {
    return x.low == y.low && x.high == y.high && x.sheet == y.sheet;
  };
  std::sort(edges.begin(), edges.end(), [](const Side & x, const Side & y) {
    return std::tie(x.low, x.high, x.sheet, x.triangle) < std::tie(y.low, y.high, y.sheet, y.triangle);
  });
  m_Neighbours.assign(m_Triangles.size(), { { None, None, None } });
  for (std::size_t first = 0; first < edges.size();)
  {
    std::size_t last = first + 1;
    while (last < edges.size() && isSame(edges[first], edges[last]))
    {
      ++last;
    }
    // where a sheet touches itself along an edge there are four: none is its neighbour's then
    if (last == first + 2)
    {
      m_Neighbours[edges[first].triangle][edges[first].corner] = edges[first + 1].triangle;
      m_Neighbours[edges[first + 1].triangle][edges[first + 1].corner] = edges[first].triangle;
    }
    first = last;
  }
}

void
SurfaceConnectivity::NumberSheetPoints(const std::vector<std::array<Material, 2>> & sides)
{
  struct Corner
  {
    PointId                 point;
    std::array<Material, 2> sheet;
    Id                      triangle;
    int                     corner;
  };
  std::vector<Corner> corners;
  corners.reserve(3 * m_Triangles.size());
  for (Id t = 0; t < m_Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      corners.push_back({ m_Triangles[t][c], sides[t], t, c });
    }
  }
  std::sort(corners.begin(), corners.end(), [](const Corner & x, const Corner & y) {
    return std::tie(x.point, x.sheet, x.triangle) < std::tie(y.point, y.sheet, y.triangle);
  });
  m_SheetPoints.resize(m_Triangles.size());
  Id number = 0;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    number += n > 0 && (corners[n].point != corners[n - 1].point || corners[n].sheet != corners[n - 1].sheet);
    m_SheetPoints[corners[n].triangle][corners[n].corner] = number;
  }
  m_Excess.assign(corners.empty() ? 0 : number + 1, 0);
}

void
SurfaceConnectivity::CountValences(const std::vector<Vector> & points)
{
  std::vector<double> angles(m_Excess.size(), 0.0);
  for (std::size_t t = 0; t < m_Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Vector & x = points[m_Triangles[t][c]];
      const Vector   u = points[m_Triangles[t][(c + 1) % 3]] - x;
      const Vector   v = points[m_Triangles[t][(c + 2) % 3]] - x;
      angles[m_SheetPoints[t][c]] += std::atan2(u.cross(v).norm(), u.dot(v));
      ++m_Excess[m_SheetPoints[t][c]];
    }
  }
  for (std::size_t p = 0; p < m_Excess.size(); ++p)
  {
    m_Excess[p] -= std::max(1, int(std::lround(angles[p] / (itk::Math::pi / 3.0))));
  }
}

std::size_t
SurfaceConnectivity::EqualizeValences(const std::vector<Vector> & points)
{
  std::size_t flips = 0;
  for (Id t = 0; t < m_Triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      flips += this->FlipForValence(t, c, points);
    }
  }
  return flips;
}

int
SurfaceConnectivity::CornerAcross(Id t, Id neighbour) const
{
  return int(std::find(m_Neighbours[t].begin(), m_Neighbours[t].end(), neighbour) - m_Neighbours[t].begin());
}

/** Whether a corner of triangle t shares an edge of the sheet with another point; looks both ways around it. */
bool
SurfaceConnectivity::AreNeighbours(Id t, int corner, PointId other) const
{
  const PointId point = m_Triangles[t][corner];
  for (const int way : { 1, 2 })
  {
    Id  current = t;
    int at = corner;
    int steps = 0;
    do
    {
      const auto & corners = m_Triangles[current];
      if (corners[0] == other || corners[1] == other || corners[2] == other)
      {
        return true;
      }
      current = m_Neighbours[current][(at + way) % 3];
      if (current != None)
      {
        at = int(std::find(m_Triangles[current].begin(), m_Triangles[current].end(), point) -
                 m_Triangles[current].begin());
      }
    } while (current != None && current != t && ++steps < Parameters::LargestFan);
  }
  return false;
}

void
SurfaceConnectivity::Relink(Id t, Id from, Id to)
{
  if (t != None)
  {
    std::replace(m_Neighbours[t].begin(), m_Neighbours[t].end(), from, to);
  }
}

/** Flips the edge opposite a corner. */
bool
SurfaceConnectivity::FlipForValence(Id t, int corner, const std::vector<Vector> & points)
{
  const Id u = m_Neighbours[t][corner];
  if (u == None)
  {
    return false;
  }
  const int  across = this->CornerAcross(u, t);
  const auto at = [](const auto & three, int n) { return three[n % 3]; };
  // the edge ab between triangles cab and dba
  const Id sheetA = at(m_SheetPoints[t], corner + 1);
  const Id sheetB = at(m_SheetPoints[t], corner + 2);
  const Id sheetC = m_SheetPoints[t][corner];
  const Id sheetD = m_SheetPoints[u][across];
  // (e - 1)^2 and (e + 1)^2 against e^2
  if (m_Excess[sheetC] + m_Excess[sheetD] - m_Excess[sheetA] - m_Excess[sheetB] + 2 >= 0)
  {
    return false;
  }
  const PointId a = at(m_Triangles[t], corner + 1);
  const PointId b = at(m_Triangles[t], corner + 2);
  const PointId c = m_Triangles[t][corner];
  const PointId d = m_Triangles[u][across];
  const Vector  before =
    (points[a] - points[c]).cross(points[b] - points[c]) + (points[b] - points[d]).cross(points[a] - points[d]);
  const Vector first = (points[a] - points[c]).cross(points[d] - points[c]);
  const Vector second = (points[d] - points[c]).cross(points[b] - points[c]);
  if (c == d || first.dot(before) <= 0.0 || second.dot(before) <= 0.0 || first.dot(second) <= 0.0 ||
      TriangleRadiusRatio(points[c], points[a], points[d]) < Parameters::LeastRadiusRatio ||
      TriangleRadiusRatio(points[c], points[d], points[b]) < Parameters::LeastRadiusRatio ||
      this->AreNeighbours(t, corner, d))
  {
    return false;
  }
  const Id beyondBC = at(m_Neighbours[t], corner + 1);
  const Id beyondCA = at(m_Neighbours[t], corner + 2);
  const Id beyondAD = at(m_Neighbours[u], across + 1);
  const Id beyondDB = at(m_Neighbours[u], across + 2);
  m_Triangles[t] = { { c, a, d } };
  m_SheetPoints[t] = { { sheetC, sheetA, sheetD } };
  m_Neighbours[t] = { { beyondAD, u, beyondCA } };
  m_Triangles[u] = { { c, d, b } };
  m_SheetPoints[u] = { { sheetC, sheetD, sheetB } };
  m_Neighbours[u] = { { beyondDB, beyondBC, t } };
  this->Relink(beyondAD, u, t);
  this->Relink(beyondBC, t, u);
  --m_Excess[sheetA];
  --m_Excess[sheetB];
  ++m_Excess[sheetC];
  ++m_Excess[sheetD];
  return true;
}
} // namespace mmm
