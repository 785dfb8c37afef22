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
#include "output/GroupedMesh.h"

#include "output/LabelNames.h"

#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace mmm
{
namespace
{
using Mesh = itk::LabelTetrahedralMesh;
using Pair = std::pair<int, int>;

constexpr int FirstSurface = 1000;

Pair
PairOf(const itk::FixedArray<int, 2> & sides)
{
  return { sides[0], sides[1] };
}

/** A cell's number, and whether its normal is to point the other way. */
struct Numbered
{
  int  number;
  bool isTurned{ false };
};

/** Appends cells to the mesh, with their numbers. */
template <typename TCell, typename TSource>
void
AppendCells(Mesh * mesh, const TSource * source, const std::function<Numbered(std::size_t)> & numberOf)
{
  if (source->GetCells() == nullptr)
  {
    return;
  }
  auto & cells = mesh->GetCells()->CastToSTLContainer();
  auto & numbers = mesh->GetCellData()->CastToSTLContainer();
  for (auto it = source->GetCells()->Begin(); it != source->GetCells()->End(); ++it)
  {
    const Numbered numbered = numberOf(it.Index());
    auto * const   cell = new TCell;
    cell->SetPointIds(it.Value()->PointIdsBegin(), it.Value()->PointIdsEnd());
    if (numbered.isTurned)
    {
      std::swap(cell->PointIdsBegin()[1], cell->PointIdsBegin()[2]);
    }
    cells.push_back(cell);
    numbers.push_back(numbered.number);
  }
}

/** A mesh with the points of the tetrahedra, or of the surface if there are none. */
Mesh::Pointer
MakeMesh(const Mesh * tetrahedra, const itk::LabelInterfaceMesh * surface)
{
  const auto mesh = Mesh::New();
  const auto points = Mesh::PointsContainer::New();
  const auto copyPoints = [&](const auto * source) {
    for (auto it = source->GetPoints()->Begin(); it != source->GetPoints()->End(); ++it)
    {
      points->CastToSTLContainer().push_back(it.Value());
    }
  };
  if (tetrahedra)
  {
    copyPoints(tetrahedra);
    const auto & all = points->CastToSTLContainer();
    const auto & first = surface->GetPoints()->CastToSTLConstContainer();
    if (first.size() > all.size() || !std::equal(first.begin(), first.end(), all.begin()))
    {
      itkGenericExceptionMacro("The points of the surface are not the first ones of the tetrahedra.");
    }
  }
  else
  {
    copyPoints(surface);
  }
  mesh->SetPoints(points);
  mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  mesh->SetCells(Mesh::CellsContainer::New());
  mesh->SetCellData(Mesh::CellDataContainer::New());
  return mesh;
}

Mesh::Pointer
Combine(const Mesh *                                       tetrahedra,
        const itk::LabelInterfaceMesh *                    surface,
        const std::function<Numbered(const Pair & pair)> & numberOfPair)
{
  const auto mesh = MakeMesh(tetrahedra, surface);
  AppendCells<itk::TriangleCell<Mesh::CellType>>(mesh.GetPointer(), surface, [&](std::size_t i) {
    return numberOfPair(PairOf(surface->GetCellData()->ElementAt(i)));
  });
  if (tetrahedra)
  {
    AppendCells<itk::TetrahedronCell<Mesh::CellType>>(mesh.GetPointer(), tetrahedra, [&](std::size_t i) {
      return Numbered{ tetrahedra->GetCellData()->ElementAt(i) };
    });
  }
  return mesh;
}

/** The surface between two tissues is that of the one with the lower rank; so SimNIBS has it. */
int
RankInSimNIBS(int label)
{
  constexpr int order[] = { 1, 2, 9, 3, 4, 8, 7, 6, 10, 5 };
  const auto    place = std::find(std::begin(order), std::end(order), label);
  return place == std::end(order) ? static_cast<int>(std::size(order)) + label : static_cast<int>(place - order);
}

std::map<Pair, int>
NumberPairs(const Mesh * tetrahedra, const itk::LabelInterfaceMesh * surface)
{
  std::map<Pair, int> numbers;
  int                 highest = FirstSurface;
  for (const auto & sides : surface->GetCellData()->CastToSTLConstContainer())
  {
    numbers[PairOf(sides)] = 0;
    highest = std::max({ highest, sides[0], sides[1] });
  }
  if (tetrahedra && tetrahedra->GetCellData())
  {
    for (const int label : tetrahedra->GetCellData()->CastToSTLConstContainer())
    {
      highest = std::max(highest, label);
    }
  }
  // Labels at the end of what an int holds leave room below.
  const int last = std::numeric_limits<int>::max() - static_cast<int>(numbers.size());
  int       number = highest <= last ? highest : FirstSurface;
  for (auto & entry : numbers)
  {
    entry.second = ++number;
  }
  return numbers;
}
} // namespace

GroupedMesh
MakeGroupedMesh(const itk::LabelTetrahedralMesh * tetrahedra,
                const itk::LabelInterfaceMesh *   surface,
                const LabelTable &                names)
{
  GroupedMesh grouped;
  const auto  numbers = NumberPairs(tetrahedra, surface);
  grouped.mesh = Combine(tetrahedra, surface, [&](const Pair & pair) { return Numbered{ numbers.at(pair) }; });
  for (const auto & [pair, number] : numbers)
  {
    const std::string name = NameOfPair(names, pair);
    grouped.names[{ 2, number }] =
      name.empty() ? "labels " + std::to_string(pair.first) + ' ' + std::to_string(pair.second) : name;
  }
  for (const auto & [label, entry] : names)
  {
    grouped.names[{ 3, label }] = entry.name;
  }
  return grouped;
}

GroupedMesh
MakeGroupedMeshForSimNIBS(const itk::LabelTetrahedralMesh * tetrahedra,
                          const itk::LabelInterfaceMesh *   surface,
                          int                               outside)
{
  const auto mesh = Combine(tetrahedra, surface, [&](const Pair & pair) {
    const bool isSecond =
      pair.first == outside || (pair.second != outside && RankInSimNIBS(pair.second) < RankInSimNIBS(pair.first));
    return Numbered{ FirstSurface + (isSecond ? pair.second : pair.first), isSecond };
  });
  return { mesh, {} };
}
} // namespace mmm
