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
// The formats of meshes, and the surfaces of one label and of several.
#include "CommandLineTest.h"

#include "itkGmshMeshIO.h"
#include "itkMeditMeshIO.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkVTUMeshIO.h"

// Readers get their IO from the tests; ITK may not have generated the header that registers mesh IOs.
#undef ITK_IO_FACTORY_REGISTER_MANAGER
#include "itkMeshFileReader.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>

namespace
{
using Volume = itk::LabelTetrahedralMesh;
using Surface = itk::LabelInterfaceMesh;
using Corners = std::vector<itk::IdentifierType>;

class CommandLineFormat : public CommandLine
{
public:
  void
  Mesh(std::vector<std::string> options) const
  {
    options.insert(options.begin(), this->WriteBalls());
    const auto result = Run(options);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.error, "");
  }

  template <typename TMesh, typename TIO>
  typename TMesh::Pointer
  Read(const std::string & name, TIO io) const
  {
    const auto reader = itk::MeshFileReader<TMesh>::New();
    reader->SetMeshIO(io);
    reader->SetFileName(this->Path(name));
    reader->Update();
    typename TMesh::Pointer mesh = reader->GetOutput();
    mesh->DisconnectPipeline();
    return mesh;
  }

  template <typename TMesh>
  static Corners
  CornersOf(const TMesh * mesh, itk::IdentifierType cell)
  {
    const auto * const c = mesh->GetCells()->ElementAt(cell);
    return { c->PointIdsBegin(), c->PointIdsEnd() };
  }

  /** The tetrahedra of out.vtu and the triangles of surface.vtu are the cells of the mesh, triangles first. */
  template <typename TNumber>
  void
  ExpectBoth(const Volume * both, const TNumber & numberOf, double sign = 1.0) const
  {
    const auto tetrahedra = this->Read<Volume>("out.vtu", itk::VTUMeshIO::New());
    const auto triangles = this->Read<Surface>("surface.vtu", itk::VTUMeshIO::New());
    ASSERT_EQ(both->GetNumberOfPoints(), tetrahedra->GetNumberOfPoints());
    for (itk::IdentifierType i = 0; i < both->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(both->GetPoint(i)[0], sign * tetrahedra->GetPoint(i)[0]);
      EXPECT_EQ(both->GetPoint(i)[1], sign * tetrahedra->GetPoint(i)[1]);
      EXPECT_EQ(both->GetPoint(i)[2], tetrahedra->GetPoint(i)[2]);
    }
    const auto offset = triangles->GetNumberOfCells();
    ASSERT_EQ(both->GetNumberOfCells(), offset + tetrahedra->GetNumberOfCells());
    for (itk::IdentifierType i = 0; i < offset; ++i)
    {
      EXPECT_EQ(CornersOf(both, i), CornersOf(triangles.GetPointer(), i));
      const auto sides = triangles->GetCellData()->ElementAt(i);
      EXPECT_EQ(both->GetCellData()->ElementAt(i), numberOf(sides[0], sides[1]));
    }
    for (itk::IdentifierType i = offset; i < both->GetNumberOfCells(); ++i)
    {
      EXPECT_EQ(CornersOf(both, i), CornersOf(tetrahedra.GetPointer(), i - offset));
      EXPECT_EQ(both->GetCellData()->ElementAt(i), tetrahedra->GetCellData()->ElementAt(i - offset));
    }
  }

  static int
  NumberOf(int a, int b)
  {
    return a == 0 && b == 2 ? 1001 : a == 2 && b == 5 ? 1002 : -1;
  }

  /** Of a closed surface, by the divergence theorem: positive if normals point outward. */
  static double
  EnclosedVolume(const Surface * surface)
  {
    double volume = 0.0;
    for (itk::IdentifierType i = 0; i < surface->GetNumberOfCells(); ++i)
    {
      const auto corners = CornersOf(surface, i);
      volume += surface->GetPoint(corners[0]).GetVectorFromOrigin() *
                itk::CrossProduct(surface->GetPoint(corners[1]).GetVectorFromOrigin(),
                                  surface->GetPoint(corners[2]).GetVectorFromOrigin()) /
                6.0;
    }
    return volume;
  }

  /** Edges that are not passed as often in one direction as in the other. */
  static std::size_t
  OpenEdges(const Surface * surface)
  {
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (itk::IdentifierType i = 0; i < surface->GetNumberOfCells(); ++i)
    {
      const auto corners = CornersOf(surface, i);
      for (int k = 0; k < 3; ++k)
      {
        const auto a = corners[k];
        const auto b = corners[(k + 1) % 3];
        edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
      }
    }
    std::size_t open = 0;
    for (const auto & edge : edges)
    {
      open += edge.second != 0 ? 1 : 0;
    }
    return open;
  }
};

double
VolumeOf(const Volume * mesh, int label)
{
  double volume = 0.0;
  for (itk::IdentifierType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (mesh->GetCellData()->ElementAt(i) == label)
    {
      const auto corners = CommandLineFormat::CornersOf(mesh, i);
      const auto origin = mesh->GetPoint(corners[0]);
      volume += (mesh->GetPoint(corners[1]) - origin) *
                itk::CrossProduct(mesh->GetPoint(corners[2]) - origin, mesh->GetPoint(corners[3]) - origin) / 6.0;
    }
  }
  return volume;
}
} // namespace

TEST_F(CommandLineFormat, GmshFilesHaveTetrahedraAndTriangles)
{
  this->Mesh({ this->Path("out.vtu"), "--surface", this->Path("surface.vtu") });
  const std::map<std::string, std::string> headers{
    { "4.1", "4.1 1 8" }, { "4.1-ascii", "4.1 0 8" }, { "2.2", "2.2 1 8" }, { "2.2-ascii", "2.2 0 8" }
  };
  for (const auto & [format, header] : headers)
  {
    this->Mesh({ this->Path("out.msh"), "--msh-format", format });
    EXPECT_EQ(this->Contents("out.msh").rfind("$MeshFormat\n" + header + '\n', 0), 0u);
    const auto io = itk::GmshMeshIO::New();
    this->ExpectBoth(this->Read<Volume>("out.msh", io).GetPointer(), NumberOf);
    const itk::GmshMeshIO::GroupNamesType names{
      { { 2, 1001 }, "labels 0 2" }, { { 2, 1002 }, "labels 2 5" }, { { 3, 2 }, "label 2" }, { { 3, 5 }, "label 5" }
    };
    EXPECT_EQ(io->GetGroupNames(), names);
  }
}

TEST_F(CommandLineFormat, MeditFilesHaveTetrahedraAndTriangles)
{
  this->Mesh({ this->Path("out.vtu"), "--surface", this->Path("surface.vtu") });
  this->Mesh({ this->Path("out.mesh") });
  this->ExpectBoth(this->Read<Volume>("out.mesh", itk::MeditMeshIO::New()).GetPointer(), NumberOf);
}

TEST_F(CommandLineFormat, SimNIBSHasItsNumbersAndRAS)
{
  this->Mesh({ this->Path("out.vtu"), "--surface", this->Path("surface.vtu") });
  this->Mesh({ this->Path("out.msh"), "--msh-format", "simnibs" });
  // Its reader wants the nodes right after the format.
  EXPECT_NE(this->Contents("out.msh").find("\n$EndMeshFormat\n$Nodes\n"), std::string::npos);
  const auto both = this->Read<Volume>("out.msh", itk::GmshMeshIO::New());
  const auto straight = this->Read<Volume>("out.vtu", itk::VTUMeshIO::New());
  const auto surface = this->Read<Surface>("surface.vtu", itk::VTUMeshIO::New());
  EXPECT_EQ(both->GetPoint(7)[0], -straight->GetPoint(7)[0]);
  EXPECT_EQ(both->GetPoint(7)[1], -straight->GetPoint(7)[1]);
  EXPECT_EQ(both->GetPoint(7)[2], straight->GetPoint(7)[2]);
  for (itk::IdentifierType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    // The ball's surface and that of its core, which SimNIBS takes for the scalp, are both those of label 2.
    EXPECT_EQ(both->GetCellData()->ElementAt(i), 1002);
    // Normals point away from it.
    auto corners = CornersOf(surface.GetPointer(), i);
    if (surface->GetCellData()->ElementAt(i)[0] == 0)
    {
      std::swap(corners[1], corners[2]);
    }
    EXPECT_EQ(CornersOf(both.GetPointer(), i), corners);
  }
}

TEST_F(CommandLineFormat, RASTurnsWhatDoesNotSayWhatItIsIn)
{
  this->Mesh({ this->Path("out.vtu"), "--surface", this->Path("surface.vtu") });
  const auto vtu = this->Contents("surface.vtu");
  for (const std::string name : { "out.msh", "out.mesh" })
  {
    this->Mesh({ this->Path(name), "--ras", "--surface", this->Path("surface.vtu") });
    const itk::GroupedMeshIOBase::Pointer io = name == "out.msh"
                                                 ? itk::GroupedMeshIOBase::Pointer(itk::GmshMeshIO::New())
                                                 : itk::GroupedMeshIOBase::Pointer(itk::MeditMeshIO::New());
    this->ExpectBoth(this->Read<Volume>(name, io).GetPointer(), NumberOf, -1.0);
    EXPECT_TRUE(this->Contents("surface.vtu") == vtu);
  }
}

TEST_F(CommandLineFormat, SurfacesKeepTheirPairsOfLabels)
{
  this->Mesh({ this->Path("out.vtu"), "--surface", this->Path("surface.vtu") });
  const auto expected = this->Read<Surface>("surface.vtu", itk::VTUMeshIO::New());
  this->Mesh({ this->Path("out.vtu"), "--surface", this->Path("surface.msh") });
  const auto read = this->Read<Surface>("surface.msh", itk::GmshMeshIO::New());
  ASSERT_EQ(read->GetNumberOfCells(), expected->GetNumberOfCells());
  for (itk::IdentifierType i = 0; i < read->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(read->GetCellData()->ElementAt(i), expected->GetCellData()->ElementAt(i));
    EXPECT_EQ(CornersOf(read.GetPointer(), i), CornersOf(expected.GetPointer(), i));
  }
}

TEST_F(CommandLineFormat, LabelsThatAreNoGroupsAreNumberedWithAWarning)
{
  const auto result =
    Run({ this->WriteBalls(), this->Path("out.msh"), "--exterior", "none", "--min-size", "3", "--quiet" });
  EXPECT_EQ(result.exitCode, 0);
  ASSERT_EQ(result.ErrorLines().size(), 1u) << result.error;
  EXPECT_EQ(result.error.rfind("multimaterial-mesh: warning: Groups of cells in", 0), 0u) << result.error;
  EXPECT_NE(result.error.find("label 0 is 1004"), std::string::npos) << result.error;
}

TEST_F(CommandLineFormat, TrianglesWithoutLabels)
{
  this->Mesh({ this->Path("surface.vtu"), "--surface-only" });
  const auto surface = this->Read<Surface>("surface.vtu", itk::VTUMeshIO::New());
  const auto points = surface->GetNumberOfPoints();
  const auto cells = surface->GetNumberOfCells();

  this->Mesh({ this->Path("surface.stl"), "--surface-only" });
  const auto stl = this->Contents("surface.stl");
  EXPECT_EQ(stl.rfind("multimaterial-mesh SPACE=LPS", 0), 0u);
  ASSERT_EQ(stl.size(), 84 + 50 * cells);
  std::array<float, 12> numbers;
  std::memcpy(numbers.data(), stl.data() + 84, sizeof numbers);
  const auto corners = CornersOf(surface.GetPointer(), 0);
  for (int k = 0; k < 9; ++k)
  {
    EXPECT_EQ(numbers[3 + k], float(surface->GetPoint(corners[k / 3])[k % 3]));
  }

  this->Mesh({ this->Path("surface.obj"), "--surface-only", "--ras" });
  EXPECT_EQ(this->Contents("surface.obj").rfind("# multimaterial-mesh SPACE=RAS\nv ", 0), 0u);
  this->Mesh({ this->Path("surface.off"), "--surface-only" });
  const auto counts = std::to_string(points) + ' ' + std::to_string(cells) + " 0\n";
  EXPECT_EQ(this->Contents("surface.off").rfind("OFF\n" + counts, 0), 0u);
}

TEST_F(CommandLineFormat, SurfacesPerLabelAreClosedAndPointOutward)
{
  this->Mesh({ this->Path("out.vtu"), "--surface-per-label", this->Path("tissue-.vtu") });
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu", "tissue-2.vtu", "tissue-5.vtu" }));
  const auto tetrahedra = this->Read<Volume>("out.vtu", itk::VTUMeshIO::New());
  for (const int label : { 2, 5 })
  {
    const auto surface = this->Read<Surface>("tissue-" + std::to_string(label) + ".vtu", itk::VTUMeshIO::New());
    EXPECT_EQ(OpenEdges(surface), 0u);
    const double volume = VolumeOf(tetrahedra, label);
    EXPECT_GT(volume, 50.0);
    EXPECT_NEAR(EnclosedVolume(surface), volume, 1e-9 * volume);
    for (const auto & sides : surface->GetCellData()->CastToSTLConstContainer())
    {
      EXPECT_EQ(sides[0], label);
      EXPECT_TRUE(label == 5 ? sides[1] == 2 : sides[1] == 0 || sides[1] == 5);
    }
  }
}

TEST_F(CommandLineFormat, SurfacesPerLabelAreSTLUnlessToldOtherwise)
{
  this->Mesh({ this->Path("out.vtu"), "--surface-per-label", this->Path("tissue") });
  EXPECT_EQ(this->Files(), (std::set<std::string>{ "labels.nrrd", "out.vtu", "tissue2.stl", "tissue5.stl" }));
}

TEST_F(CommandLineFormat, HullsAreClosedAroundTheirLabels)
{
  this->Mesh({ "--hull",
               this->Path("inner.vtu") + "=5",
               "--hull",
               this->Path("outer.vtu") + "=2,5",
               this->Path("out.vtu"),
               "--report",
               this->Path("report.json") });
  const auto tetrahedra = this->Read<Volume>("out.vtu", itk::VTUMeshIO::New());
  const auto inner = this->Read<Surface>("inner.vtu", itk::VTUMeshIO::New());
  const auto outer = this->Read<Surface>("outer.vtu", itk::VTUMeshIO::New());
  EXPECT_EQ(OpenEdges(inner) + OpenEdges(outer), 0u);
  const double core = VolumeOf(tetrahedra, 5);
  const double all = core + VolumeOf(tetrahedra, 2);
  EXPECT_NEAR(EnclosedVolume(inner), core, 1e-9 * core);
  EXPECT_NEAR(EnclosedVolume(outer), all, 1e-9 * all);
  const auto hulls = nlohmann::json::parse(this->Contents("report.json"))["hulls"];
  ASSERT_EQ(hulls.size(), 2u);
  EXPECT_EQ(hulls[1]["file"], this->Path("outer.vtu"));
  EXPECT_EQ(hulls[1]["labels"], (std::vector<int>{ 2, 5 }));
  EXPECT_EQ(hulls[1]["triangles"], outer->GetNumberOfCells());
  EXPECT_EQ(hulls[1]["handles"], 0);
}

TEST_F(CommandLineFormat, HullsThatTouchAreAWarning)
{
  const auto result = Run({ this->WriteBalls(),
                            this->Path("out.vtu"),
                            "--quiet",
                            "--hull",
                            this->Path("a.stl") + "=2,5",
                            "--hull",
                            this->Path("b.stl") + "=2,77" });
  EXPECT_EQ(result.exitCode, 0);
  ASSERT_EQ(result.ErrorLines().size(), 2u) << result.error;
  EXPECT_NE(result.error.find("no voxel has the label 77 that --hull names"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find("b.stl touch in "), std::string::npos) << result.error;
  EXPECT_EQ(this->Contents("a.stl"), this->Contents("b.stl"));
}

TEST_F(CommandLineFormat, FreeSurferHasPointsInRAS)
{
  this->Mesh({ this->Path("surface.vtu"), "--surface-only", "--hull", this->Path("hull.surf") + "=2,5" });
  this->Mesh({ this->Path("surface.vtu"), "--surface-only", "--hull", this->Path("hull.vtu") + "=2,5" });
  const auto hull = this->Read<Surface>("hull.vtu", itk::VTUMeshIO::New());
  const auto surf = this->Contents("hull.surf");
  const auto text = surf.find("\n\n");
  EXPECT_EQ(surf.rfind("\xFF\xFF\xFE", 0), 0u);
  ASSERT_NE(text, std::string::npos);
  const auto numberAt = [&](std::size_t index) {
    std::uint32_t number = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
    {
      number = number << 8 | static_cast<unsigned char>(surf.at(text + 2 + 4 * index + byte));
    }
    return number;
  };
  const auto points = hull->GetNumberOfPoints();
  const auto cells = hull->GetNumberOfCells();
  ASSERT_EQ(surf.size(), text + 2 + 4 * (2 + 3 * points + 3 * cells));
  EXPECT_EQ(numberAt(0), points);
  EXPECT_EQ(numberAt(1), cells);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::uint32_t bits = numberAt(2 + axis);
    float               coordinate = 0.0f;
    std::memcpy(&coordinate, &bits, sizeof coordinate);
    EXPECT_EQ(coordinate, float((axis < 2 ? -1.0 : 1.0) * hull->GetPoint(0)[axis]));
    EXPECT_EQ(numberAt(2 + 3 * points + axis), CornersOf(hull.GetPointer(), 0)[axis]);
  }
}
