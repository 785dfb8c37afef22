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
#include "report/MeshCut.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace mmm
{
namespace
{
/** The points where edges of a mesh go through a plane, each once. */
class Crossings
{
public:
  Crossings(const std::vector<Vector> & points, const CutPlane & plane, std::vector<PlanarPoint> & crossings)
    : m_Points(points)
    , m_Plane(plane)
    , m_Crossings(crossings)
  {}

  bool
  IsAbove(std::uint32_t point) const
  {
    return m_Points[point][m_Plane.normal] >= m_Plane.position;
  }

  /** By the index among the crossings. The ends of the edge are on different sides. */
  std::uint32_t
  Find(std::uint32_t end, std::uint32_t otherEnd)
  {
    const auto [first, second] = std::minmax(end, otherEnd);
    const std::uint64_t key = (std::uint64_t(first) << 32) | second;
    const auto          found = m_Indices.emplace(key, std::uint32_t(m_Crossings.size()));
    if (found.second)
    {
      const Vector & a = m_Points[first];
      const Vector & b = m_Points[second];
      const double   share = (m_Plane.position - a[m_Plane.normal]) / (b[m_Plane.normal] - a[m_Plane.normal]);
      PlanarPoint    crossing;
      for (int c = 0; c < 2; ++c)
      {
        const int axis = m_Plane.along[c];
        crossing[c] = a[axis] + share * (b[axis] - a[axis]);
      }
      m_Crossings.push_back(crossing);
    }
    return found.first->second;
  }

private:
  const std::vector<Vector> &                      m_Points;
  const CutPlane &                                 m_Plane;
  std::vector<PlanarPoint> &                       m_Crossings;
  std::unordered_map<std::uint64_t, std::uint32_t> m_Indices;
};

/** Calls visit(identifier, corners, above) for the cells that a plane cuts: corners above the plane come first, and
 * `above` is their number. */
template <std::size_t VCorners, typename TMesh, typename TVisitor>
void
ForEachCutCell(const TMesh & mesh, const Crossings & crossings, const TVisitor & visit)
{
  const auto * const cells = mesh.GetCells();
  if (cells == nullptr)
  {
    return;
  }
  for (auto cell = cells->Begin(); cell != cells->End(); ++cell)
  {
    std::array<std::uint32_t, VCorners> corners;
    std::copy_n(cell.Value()->PointIdsBegin(), VCorners, corners.begin());
    const auto middle = std::stable_partition(
      corners.begin(), corners.end(), [&](std::uint32_t point) { return crossings.IsAbove(point); });
    const auto above = std::size_t(middle - corners.begin());
    if (above > 0 && above < VCorners)
    {
      visit(cell.Index(), corners, above);
    }
  }
}
} // namespace

PlanarCells
CutTetrahedra(const itk::LabelTetrahedralMesh & mesh, const std::vector<Vector> & points, const CutPlane & plane)
{
  PlanarCells cut;
  Crossings   crossings(points, plane, cut.points);
  ForEachCutCell<4>(mesh, crossings, [&](auto identifier, const auto & corners, std::size_t above) {
    const auto find = [&](int a, int b) { return crossings.Find(corners[a], corners[b]); };
    PlanarCell cell{ { { 0, 0, 0, PlanarCell::NoCorner } }, mesh.GetCellData()->ElementAt(identifier) };
    if (above == 2)
    {
      cell.corners = { { find(0, 2), find(0, 3), find(1, 3), find(1, 2) } };
    }
    else
    {
      const int lone = above == 1 ? 0 : 3;
      const int other = above == 1 ? 1 : 0;
      for (int c = 0; c < 3; ++c)
      {
        cell.corners[c] = find(lone, other + c);
      }
    }
    if (TwiceArea(cut.points, cell) < 0.0)
    {
      std::reverse(cell.corners.begin(), cell.corners.begin() + cell.CountCorners());
    }
    cut.cells.push_back(cell);
  });
  return cut;
}

PlanarEdges
CutTriangles(const itk::LabelInterfaceMesh & mesh, const std::vector<Vector> & points, const CutPlane & plane)
{
  PlanarEdges cut;
  Crossings   crossings(points, plane, cut.points);
  ForEachCutCell<3>(mesh, crossings, [&](auto, const auto & corners, std::size_t above) {
    const int  lone = above == 1 ? 0 : 2;
    const auto first = crossings.Find(corners[lone], corners[(lone + 1) % 3]);
    const auto second = crossings.Find(corners[lone], corners[(lone + 2) % 3]);
    cut.edges.push_back({ { std::min(first, second), std::max(first, second) } });
  });
  return cut;
}

PlanarCells
CutVoxels(const std::function<int(const itk::Index<3> &)> & labelAt,
          const itk::ImageRegion<3> &                       region,
          const std::set<int> &                             labels,
          const CutPlane &                                  plane)
{
  PlanarCells   cut;
  itk::Index<3> index = region.GetIndex();
  index[plane.normal] = std::lround(plane.position);
  if (!region.IsInside(index))
  {
    return cut;
  }
  const int  right = plane.along[0];
  const int  up = plane.along[1];
  const auto begin = region.GetIndex();
  const auto columns = std::uint32_t(region.GetSize(right));
  const auto rows = std::uint32_t(region.GetSize(up));
  for (std::uint32_t row = 0; row <= rows; ++row)
  {
    for (std::uint32_t column = 0; column <= columns; ++column)
    {
      cut.points.push_back({ { double(begin[right]) + column - 0.5, double(begin[up]) + row - 0.5 } });
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      index[right] = begin[right] + column;
      index[up] = begin[up] + row;
      const int label = labelAt(index);
      if (labels.count(label) > 0)
      {
        const std::uint32_t first = row * (columns + 1) + column;
        cut.cells.push_back({ { { first, first + 1, first + columns + 2, first + columns + 1 } }, label });
      }
    }
  }
  return cut;
}
} // namespace mmm
