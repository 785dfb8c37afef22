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
#include "itkLabelSurfaceMeshFilter.h"

#include "itkTriangleCell.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace
{
using Mesh = itk::LabelInterfaceMesh;
using Voxel = std::array<int, 3>;
/** Labels of cubes of edge 1; all others are 0. */
using Voxels = std::map<Voxel, int>;

int
LabelOf(const Voxels & voxels, const Voxel & voxel)
{
  const auto found = voxels.find(voxel);
  return found == voxels.end() ? 0 : found->second;
}

void
AddBlock(Voxels & voxels, int label, const Voxel & begin, const Voxel & end)
{
  for (int k = begin[2]; k < end[2]; ++k)
  {
    for (int j = begin[1]; j < end[1]; ++j)
    {
      for (int i = begin[0]; i < end[0]; ++i)
      {
        voxels[{ i, j, k }] = label;
      }
    }
  }
}

/** The faces between different labels, two triangles each. */
Mesh::Pointer
MakeSurface(const Voxels & voxels)
{
  const auto mesh = Mesh::New();
  mesh->SetCellsAllocationMethod(itk::MeshEnums::MeshClassCellsAllocationMethod::CellsAllocatedDynamicallyCellByCell);
  std::map<Voxel, itk::IdentifierType> points;
  itk::IdentifierType                  cells = 0;
  for (const auto & entry : voxels)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        Voxel other = entry.first;
        other[axis] += side == 0 ? -1 : 1;
        const int label = LabelOf(voxels, other);
        if (label >= entry.second)
        {
          continue;
        }
        std::array<itk::IdentifierType, 4> corners;
        for (int corner = 0; corner < 4; ++corner)
        {
          Voxel place = entry.first;
          place[axis] += side;
          place[(axis + 1) % 3] += corner == 1 || corner == 2;
          place[(axis + 2) % 3] += corner == 2 || corner == 3;
          corners[corner] = points.emplace(place, points.size()).first->second;
          const double coordinates[] = { double(place[0]), double(place[1]), double(place[2]) };
          mesh->SetPoint(corners[corner], coordinates);
        }
        // the normal points to the larger label, that is into the voxel
        if (side == 1)
        {
          std::swap(corners[1], corners[3]);
        }
        for (int half = 0; half < 2; ++half)
        {
          const itk::IdentifierType ids[] = { corners[0], corners[1 + half], corners[2 + half] };
          Mesh::CellAutoPointer     cell;
          cell.TakeOwnership(new itk::TriangleCell<Mesh::CellType>);
          cell->SetPointIds(ids, ids + 3);
          mesh->SetCell(cells, cell);
          itk::FixedArray<int, 2> sides;
          sides[0] = label;
          sides[1] = entry.second;
          mesh->SetCellData(cells++, sides);
        }
      }
    }
  }
  return mesh;
}

/** By the divergence theorem; negative if normals point inward. */
double
VolumeOf(const Mesh & mesh)
{
  double sixfold = 0.0;
  for (auto cell = mesh.GetCells()->Begin(); cell != mesh.GetCells()->End(); ++cell)
  {
    const auto * const id = cell.Value()->PointIdsBegin();
    const auto         corner = [&](int k) { return mesh.GetPoint(id[k]).GetVectorFromOrigin(); };
    sixfold += corner(0) * itk::CrossProduct(corner(1), corner(2));
  }
  return sixfold / 6.0;
}

itk::LabelHullMeshFilter::Pointer
MakeHull(const Voxels & voxels, const std::vector<int> & labels = { 1 })
{
  const auto filter = itk::LabelHullMeshFilter::New();
  filter->SetInput(MakeSurface(voxels));
  filter->SetLabels(labels);
  filter->Update();
  return filter;
}

void
ExpectCounts(const itk::LabelHullMeshFilter & hull,
             std::size_t                      otherParts,
             std::size_t                      pinchedEdges,
             std::size_t                      pinchedPoints,
             std::size_t                      handles)
{
  EXPECT_EQ(hull.GetNumberOfOtherParts(), otherParts);
  EXPECT_EQ(hull.GetNumberOfPinchedEdges(), pinchedEdges);
  EXPECT_EQ(hull.GetNumberOfPinchedPoints(), pinchedPoints);
  EXPECT_EQ(hull.GetNumberOfHandles(), handles);
}

/** A cube of label 1 in one of label 2, off its center. */
Voxels
MakeNestedCubes()
{
  Voxels voxels;
  AddBlock(voxels, 2, { 0, 0, 0 }, { 5, 5, 5 });
  AddBlock(voxels, 1, { 1, 1, 1 }, { 3, 3, 3 });
  return voxels;
}
} // namespace

TEST(LabelHullMeshFilter, IsAroundTheLabelsWithNormalsOutward)
{
  const auto inner = MakeHull(MakeNestedCubes());
  EXPECT_DOUBLE_EQ(VolumeOf(*inner->GetOutput()), 8.0);
  ExpectCounts(*inner, 0, 0, 0, 0);
  const auto outer = MakeHull(MakeNestedCubes(), { 1, 2 });
  EXPECT_DOUBLE_EQ(VolumeOf(*outer->GetOutput()), 125.0);
  EXPECT_EQ(outer->GetOutput()->GetNumberOfCells(), 6u * 25u * 2u);
  ExpectCounts(*outer, 0, 0, 0, 0);
}

TEST(LabelHullMeshFilter, HasTheLabelInsideFirst)
{
  const auto hull = MakeHull(MakeNestedCubes());
  for (const auto & sides : hull->GetOutput()->GetCellData()->CastToSTLConstContainer())
  {
    EXPECT_EQ(sides[0], 1);
    EXPECT_EQ(sides[1], 2);
  }
}

TEST(LabelHullMeshFilter, NestedOnesDoNotTouch)
{
  const auto                      inner = MakeHull(MakeNestedCubes());
  const auto                      outer = MakeHull(MakeNestedCubes(), { 1, 2 });
  std::set<std::array<double, 3>> points;
  for (const auto & point : inner->GetOutput()->GetPoints()->CastToSTLConstContainer())
  {
    points.insert({ point[0], point[1], point[2] });
  }
  for (const auto & point : outer->GetOutput()->GetPoints()->CastToSTLConstContainer())
  {
    EXPECT_TRUE(points.insert({ point[0], point[1], point[2] }).second);
  }
}

TEST(LabelHullMeshFilter, LeavesOutCavitiesAndWhatIsInThem)
{
  Voxels voxels;
  AddBlock(voxels, 1, { 0, 0, 0 }, { 5, 5, 5 });
  AddBlock(voxels, 0, { 1, 1, 1 }, { 4, 4, 4 });
  AddBlock(voxels, 1, { 2, 2, 2 }, { 3, 3, 3 });
  const auto hull = MakeHull(voxels);
  EXPECT_DOUBLE_EQ(VolumeOf(*hull->GetOutput()), 125.0);
  EXPECT_EQ(hull->GetOutput()->GetNumberOfCells(), 6u * 25u * 2u);
  ExpectCounts(*hull, 0, 0, 0, 0);
}

TEST(LabelHullMeshFilter, LeavesOutAndCountsWhatIsBesideTheLargestPart)
{
  Voxels voxels;
  AddBlock(voxels, 1, { 0, 0, 0 }, { 1, 1, 1 });
  AddBlock(voxels, 1, { 3, 0, 0 }, { 5, 2, 2 });
  AddBlock(voxels, 1, { 7, 0, 0 }, { 8, 1, 1 });
  const auto hull = MakeHull(voxels);
  EXPECT_DOUBLE_EQ(VolumeOf(*hull->GetOutput()), 8.0);
  ExpectCounts(*hull, 2, 0, 0, 0);
}

TEST(LabelHullMeshFilter, CountsHandles)
{
  Voxels voxels;
  AddBlock(voxels, 1, { 0, 0, 0 }, { 5, 3, 1 });
  voxels.erase({ 1, 1, 0 });
  ExpectCounts(*MakeHull(voxels), 0, 0, 0, 1);
  voxels.erase({ 3, 1, 0 });
  ExpectCounts(*MakeHull(voxels), 0, 0, 0, 2);
}

TEST(LabelHullMeshFilter, CountsPinchedEdges)
{
  Voxels voxels;
  AddBlock(voxels, 1, { 0, 0, 0 }, { 1, 1, 2 });
  AddBlock(voxels, 1, { 1, 1, 0 }, { 2, 2, 2 });
  const auto hull = MakeHull(voxels);
  EXPECT_DOUBLE_EQ(VolumeOf(*hull->GetOutput()), 4.0);
  ExpectCounts(*hull, 0, 2, 0, 0);
}

TEST(LabelHullMeshFilter, CountsPinchedPoints)
{
  // a chain of cubes whose ends touch at a corner
  Voxels voxels;
  for (const Voxel & voxel : std::initializer_list<Voxel>{
         { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 }, { 0, 2, 0 }, { 0, 2, 1 }, { 1, 2, 1 }, { 2, 2, 1 }, { 2, 1, 1 } })
  {
    voxels[voxel] = 1;
  }
  const auto hull = MakeHull(voxels);
  EXPECT_DOUBLE_EQ(VolumeOf(*hull->GetOutput()), 8.0);
  ExpectCounts(*hull, 0, 0, 1, 0);
}

TEST(LabelHullMeshFilter, ThrowsWithoutSurface)
{
  EXPECT_THROW(MakeHull(MakeNestedCubes(), { 7 }), itk::ExceptionObject);
}

TEST(LabelHullMeshFilter, PrintsItsCounts)
{
  std::ostringstream printed;
  MakeHull(MakeNestedCubes(), { 1, 2 })->Print(printed);
  EXPECT_NE(printed.str().find("Labels: 1 2\n"), std::string::npos);
  EXPECT_NE(printed.str().find("NumberOfHandles: 0"), std::string::npos);
}

TEST(LabelSurfaceMeshFilter, TakesLabelsAsOneWithTheirCavities)
{
  Voxels voxels = MakeNestedCubes();
  voxels.erase({ 3, 3, 3 });
  const auto filter = itk::LabelSurfaceMeshFilter::New();
  filter->SetInput(MakeSurface(voxels));
  filter->SetLabels({ 1, 2 });
  filter->Update();
  EXPECT_DOUBLE_EQ(VolumeOf(*filter->GetOutput()), 124.0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 2u * (6u * 25u + 6u));
}
