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
#ifndef mmmTestMeshes_h
#define mmmTestMeshes_h

#include "itkMultiMaterialMeshTypes.h"
#include "base/Grid.h"
#include "mesh/TetrahedronQuality.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

/** The contents of meshes in a form that is easy to test. */
namespace mmmtest
{
template <typename TMesh>
std::vector<mmm::Vector>
PointsOf(const TMesh * mesh)
{
  std::vector<mmm::Vector> points;
  if (mesh->GetPoints())
  {
    for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
    {
      points.emplace_back(it.Value()[0], it.Value()[1], it.Value()[2]);
    }
  }
  return points;
}

/** The corners of the cells, VCorners each. */
template <std::size_t VCorners, typename TMesh>
std::vector<std::array<std::size_t, VCorners>>
CellsOf(const TMesh * mesh)
{
  std::vector<std::array<std::size_t, VCorners>> cells;
  if (mesh->GetCells())
  {
    for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
    {
      const typename TMesh::CellType &  cell = *it.Value();
      std::array<std::size_t, VCorners> corners{ {} };
      std::copy(cell.PointIdsBegin(), cell.PointIdsEnd(), corners.begin());
      cells.push_back(corners);
    }
  }
  return cells;
}

template <typename TMesh>
const std::vector<typename TMesh::CellPixelType> &
CellDataOf(const TMesh * mesh)
{
  return mesh->GetCellData()->CastToSTLConstContainer();
}

template <typename TMesh>
std::map<int, double>
VolumesOf(const TMesh * mesh)
{
  const auto            points = PointsOf(mesh);
  const auto            cells = CellsOf<4>(mesh);
  const auto &          labels = CellDataOf(mesh);
  std::map<int, double> volumes;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    volumes[static_cast<int>(labels[c])] +=
      mmm::TetrahedronVolume(points[cells[c][0]], points[cells[c][1]], points[cells[c][2]], points[cells[c][3]]);
  }
  return volumes;
}

inline mmm::Vector
TriangleNormal(const std::vector<mmm::Vector> & points, const std::array<std::size_t, 3> & corners)
{
  return 0.5 * (points[corners[1]] - points[corners[0]]).cross(points[corners[2]] - points[corners[0]]);
}

/** Faces of tetrahedra, by their sorted corners, and the cells that have them. */
template <typename TMesh>
std::map<std::array<std::size_t, 3>, std::vector<std::size_t>>
FacesOf(const TMesh * mesh)
{
  std::map<std::array<std::size_t, 3>, std::vector<std::size_t>> faces;
  const auto                                                     cells = CellsOf<4>(mesh);
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (std::size_t f = 0; f < 4; ++f)
    {
      std::array<std::size_t, 3> face{ { cells[c][(f + 1) % 4], cells[c][(f + 2) % 4], cells[c][(f + 3) % 4] } };
      std::sort(face.begin(), face.end());
      faces[face].push_back(c);
    }
  }
  return faces;
}

/** The sum of the oriented areas around each label: zero where its boundary is closed and consistently oriented. */
inline std::map<int, mmm::Vector>
OrientedAreas(const itk::LabelInterfaceMesh * surface)
{
  const auto                 points = PointsOf(surface);
  const auto                 cells = CellsOf<3>(surface);
  const auto &               sides = CellDataOf(surface);
  std::map<int, mmm::Vector> sums;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const mmm::Vector normal = TriangleNormal(points, cells[c]);
    for (const int side : { 0, 1 })
    {
      auto & sum = sums.insert({ sides[c][side], mmm::Vector::Zero() }).first->second;
      sum += side ? mmm::Vector(-normal) : normal;
    }
  }
  return sums;
}

/** How many edges of the boundary of each label have an odd number of its triangles. */
inline std::map<int, std::size_t>
OpenEdges(const itk::LabelInterfaceMesh * surface)
{
  using Edge = std::pair<std::size_t, std::size_t>;
  std::map<int, std::map<Edge, int>> uses;
  const auto                         cells = CellsOf<3>(surface);
  const auto &                       sides = CellDataOf(surface);
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (const int side : { 0, 1 })
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        const auto a = cells[c][corner];
        const auto b = cells[c][(corner + 1) % 3];
        ++uses[sides[c][side]][{ std::min(a, b), std::max(a, b) }];
      }
    }
  }
  std::map<int, std::size_t> open;
  for (const auto & entry : uses)
  {
    open[entry.first] = std::count_if(
      entry.second.begin(), entry.second.end(), [](const std::pair<const Edge, int> & use) { return use.second % 2; });
  }
  return open;
}
} // namespace mmmtest

#endif
