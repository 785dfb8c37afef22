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
// The files of second-order elements: which nodes there are, and in what order.
#include "output/SecondOrder.h"

#include "itkGmshMeshIO.h"
#include "itkLabelMeshFileWriter.h"
#include "itkVTUMeshIO.h"
#include "support/TestMeshes.h"
#include "support/TestVTUFiles.h"

#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"

#include <array>
#include <fstream>
#include <set>
#include <sstream>

using mmm::Vector;

namespace
{
using Mesh = itk::LabelTetrahedralMesh;
using Surface = itk::LabelInterfaceMesh;
using Nodes = std::vector<std::size_t>;

using Edges = std::vector<std::array<int, 2>>;
const Edges OrderOfVTK{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } }, { { 0, 3 } }, { { 1, 3 } }, { { 2, 3 } } };
const Edges OrderOfGmsh{ { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } }, { { 3, 0 } }, { { 3, 2 } }, { { 3, 1 } } };

const std::vector<Vector> Points{ Vector(0.1, 0.0, 0.2),
                                  Vector(1.3, 0.1, 0.0),
                                  Vector(0.0, 1.2, 0.1),
                                  Vector(0.2, 0.3, 1.1),
                                  Vector(1.1, 1.2, 1.3) };

template <typename TMesh>
typename TMesh::Pointer
MakeMesh()
{
  const auto mesh = TMesh::New();
  for (std::size_t p = 0; p < Points.size(); ++p)
  {
    typename TMesh::PointType point;
    std::copy_n(Points[p].data(), 3, point.Begin());
    mesh->SetPoint(p, point);
  }
  return mesh;
}

template <typename TCell, typename TMesh>
void
AddCell(TMesh * mesh, const Nodes & corners, const typename TMesh::CellPixelType & value)
{
  typename TMesh::CellAutoPointer cell;
  cell.TakeOwnership(new TCell);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    cell->SetPointId(int(c), corners[c]);
  }
  const auto number = mesh->GetNumberOfCells();
  mesh->SetCell(number, cell);
  mesh->SetCellData(number, value);
}

/** Two tetrahedra with a common face. */
Mesh::Pointer
MakeTetrahedra()
{
  const auto mesh = MakeMesh<Mesh>();
  AddCell<itk::TetrahedronCell<Mesh::CellType>>(mesh.GetPointer(), { 0, 1, 2, 3 }, 1);
  AddCell<itk::TetrahedronCell<Mesh::CellType>>(mesh.GetPointer(), { 3, 1, 2, 4 }, 2);
  return mesh;
}

/** The face between them. */
Surface::Pointer
MakeFace()
{
  const auto             mesh = MakeMesh<Surface>();
  Surface::CellPixelType sides;
  sides[0] = 1;
  sides[1] = 2;
  AddCell<itk::TriangleCell<Surface::CellType>>(mesh.GetPointer(), { 1, 2, 3 }, sides);
  return mesh;
}

/** The edge 1-2 is curved. */
itk::LabelMidNodeMesh::Pointer
MakeMidNodes(int first = 1, int second = 2)
{
  const auto                       mesh = itk::LabelMidNodeMesh::New();
  itk::LabelMidNodeMesh::PixelType ends;
  ends[0] = first;
  ends[1] = second;
  itk::LabelMidNodeMesh::PointType point;
  point[0] = 0.8;
  point[1] = 0.8;
  point[2] = 0.1;
  mesh->SetPoint(0, point);
  mesh->SetPointData(0, ends);
  return mesh;
}

/** A cell's shape functions of second order interpolate any function of second degree exactly, if each node is where
 * the order says. The cell has to be straight. */
void
ExpectExactInterpolation(const std::vector<Vector> & points, const Nodes & nodes, const Edges & order)
{
  const std::size_t corners = nodes.size() == 10 ? 4 : 3;
  const auto        function = [](const Vector & x) { return x[0] * x[0] + 2.0 * x[1] * x[2] - x[2] * x[2]; };
  const double      at[] = { 0.4, 0.1, corners == 4 ? 0.2 : 0.5, 0.3 };
  Vector            place = Vector::Zero();
  double            value = 0.0;
  for (std::size_t c = 0; c < corners; ++c)
  {
    place += at[c] * points[nodes[c]];
    value += at[c] * (2.0 * at[c] - 1.0) * function(points[nodes[c]]);
  }
  for (std::size_t e = 0; corners + e < nodes.size(); ++e)
  {
    value += 4.0 * at[order[e][0]] * at[order[e][1]] * function(points[nodes[corners + e]]);
  }
  EXPECT_NEAR(value, function(place), 1e-12);
}

class SecondOrder : public mmmVTUTest::VTUMeshIOTest
{
protected:
  void
  Write(const std::string &           name,
        const Mesh *                  tetrahedra,
        const itk::LabelMidNodeMesh * midNodes,
        const std::string &           format = "4.1") const
  {
    const auto writer = itk::LabelMeshFileWriter::New();
    writer->SetTetrahedra(tetrahedra);
    writer->SetSurface(MakeFace());
    writer->SetMidNodes(midNodes);
    writer->SetMshFormat(format);
    writer->SetFileName(name);
    writer->Write();
  }
};
} // namespace

TEST_F(SecondOrder, HasVTKsOrderAndOneNodeForEachEdge)
{
  const auto mesh = mmm::MakeSecondOrder(MakeTetrahedra().GetPointer(), itk::LabelMidNodeMesh::New().GetPointer());
  const auto points = mmmtest::PointsOf(mesh.GetPointer());
  const auto cells = mmmtest::CellsOf<10>(mesh.GetPointer());
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(points.size(), 5u + 9u);
  std::set<std::size_t> used;
  for (const auto & cell : cells)
  {
    ExpectExactInterpolation(points, Nodes(cell.begin(), cell.end()), OrderOfVTK);
    used.insert(cell.begin(), cell.end());
  }
  EXPECT_EQ(used.size(), points.size());
  EXPECT_EQ(mmmtest::CellDataOf(mesh.GetPointer()), (std::vector<int>{ 1, 2 }));
}

TEST_F(SecondOrder, PutsMidNodesWhereTheyAreToBe)
{
  const auto mesh = mmm::MakeSecondOrder(MakeTetrahedra().GetPointer(), MakeMidNodes().GetPointer());
  const auto points = mmmtest::PointsOf(mesh.GetPointer());
  for (const auto & cell : mmmtest::CellsOf<10>(mesh.GetPointer()))
  {
    EXPECT_EQ(points[cell[5]], Vector(0.8, 0.8, 0.1));
    EXPECT_EQ(points[cell[6]], Vector(0.5 * (points[cell[0]] + points[cell[2]])));
  }
}

TEST_F(SecondOrder, TrianglesHaveSixNodes)
{
  const auto mesh = mmm::MakeSecondOrder(MakeFace().GetPointer(), MakeMidNodes().GetPointer());
  const auto points = mmmtest::PointsOf(mesh.GetPointer());
  const auto cells = mmmtest::CellsOf<6>(mesh.GetPointer());
  EXPECT_EQ(points[cells[0][3]], Vector(0.8, 0.8, 0.1));
  Write(this->Name("face.vtu"), nullptr, MakeMidNodes());
  const auto reader = itk::MeshFileReader<Surface>::New();
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "label_a", "label_b" });
  reader->SetMeshIO(io);
  reader->SetFileName(this->Name("face.vtu"));
  reader->Update();
  EXPECT_EQ(mmmtest::CellsOf<6>(reader->GetOutput()), cells);
  EXPECT_EQ(mmmtest::PointsOf(reader->GetOutput()), points);
  EXPECT_EQ(reader->GetOutput()->GetCells()->ElementAt(0)->GetType(), itk::CellGeometryEnum::QUADRATIC_TRIANGLE_CELL);
}

TEST_F(SecondOrder, GmshFilesHaveGmshsOrder)
{
  Write(this->Name("mesh.msh"), MakeTetrahedra(), itk::LabelMidNodeMesh::New(), "2.2-ascii");
  std::ifstream       file(this->Name("mesh.msh"));
  std::string         line;
  std::vector<Vector> points;
  std::vector<int>    types;
  while (std::getline(file, line) && line != "$Nodes")
  {
  }
  std::size_t count = 0;
  file >> count;
  for (std::size_t n = 0; n < count; ++n)
  {
    std::size_t number = 0;
    Vector      point;
    file >> number >> point[0] >> point[1] >> point[2];
    points.push_back(point);
  }
  while (std::getline(file, line) && line != "$Elements")
  {
  }
  file >> count;
  std::getline(file, line);
  while (count-- > 0 && std::getline(file, line))
  {
    std::istringstream words(line);
    int                number = 0;
    int                tag = 0;
    types.emplace_back();
    words >> number >> types.back() >> tag >> tag >> tag;
    Nodes nodes;
    for (std::size_t node = 0; words >> node;)
    {
      nodes.push_back(node - 1);
    }
    ASSERT_EQ(nodes.size(), types.back() == 11 ? 10u : 6u);
    ExpectExactInterpolation(points, nodes, OrderOfGmsh);
  }
  EXPECT_EQ(types, (std::vector<int>{ 9, 11, 11 }));
}

TEST_F(SecondOrder, VersionsOfGmshFilesHaveTheSameNodes)
{
  const auto elementsOf = [&](const std::string & format) {
    Write(this->Name("mesh.msh"), MakeTetrahedra(), MakeMidNodes(), format);
    std::ifstream file(this->Name("mesh.msh"));
    std::string   line;
    Nodes         last;
    while (std::getline(file, line) && line != "$EndElements")
    {
      std::istringstream words(line);
      last.clear();
      for (std::size_t node = 0; words >> node;)
      {
        last.push_back(node);
      }
    }
    return Nodes(last.end() - 10, last.end());
  };
  EXPECT_EQ(elementsOf("4.1-ascii"), elementsOf("2.2-ascii"));
}

TEST_F(SecondOrder, TetrahedraOfTenNodesAreRefusedByReaders)
{
  const auto expectRefusal = [&](itk::MeshIOBase * io, const std::string & name, const std::string & message) {
    Write(name, MakeTetrahedra(), MakeMidNodes());
    io->SetFileName(name);
    try
    {
      io->ReadMeshInformation();
      ADD_FAILURE() << name;
    }
    catch (const itk::ExceptionObject & error)
    {
      EXPECT_NE(std::string(error.GetDescription()).find(message), std::string::npos) << error.GetDescription();
    }
  };
  expectRefusal(itk::VTUMeshIO::New(), this->Name("mesh.vtu"), "quadratic tetrahedron (VTK cell type 24)");
  expectRefusal(itk::GmshMeshIO::New(), this->Name("mesh.msh"), "of first order are read");
}

TEST_F(SecondOrder, FormatsOfFirstOrderAreRefused)
{
  for (const std::string name : { "mesh.mesh", "mesh.msh" })
  {
    EXPECT_THROW(Write(this->Name(name), MakeTetrahedra(), MakeMidNodes(), "simnibs"), itk::ExceptionObject);
    EXPECT_FALSE(std::ifstream(this->Name(name)).good());
  }
}

TEST_F(SecondOrder, MidNodesOfAnotherMeshAreRefused)
{
  EXPECT_THROW(Write(this->Name("mesh.vtu"), MakeTetrahedra(), MakeMidNodes(0, 4)), itk::ExceptionObject);
}
