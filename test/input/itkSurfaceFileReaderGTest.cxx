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
#include "itkSurfaceFileReader.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

// registers the formats of meshes that ITK was built with
#include "itkMeshFileReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

namespace
{
using mmm::Vector;

/** A tetrahedron with the corner (1, 2, 3) and three more. */
const double Points[4][3] = { { 1, 2, 3 }, { 5, 2, 3 }, { 1, 7, 3 }, { 1, 2, 9 } };
const int    Triangles[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };

/** The bytes of a number, the highest first or last. */
template <typename T>
std::string
Bytes(T number, bool highestFirst)
{
  std::string bytes(sizeof number, ' ');
  std::memcpy(&bytes[0], &number, sizeof number);
  const std::uint16_t one = 1;
  char                first = 0;
  std::memcpy(&first, &one, 1);
  if ((first == 0) != highestFirst)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

std::string
BinarySTL(std::string header)
{
  header.resize(80, ' ');
  std::string bytes = header + Bytes(std::uint32_t{ 4 }, false);
  for (const auto & triangle : Triangles)
  {
    bytes += std::string(12, '\0');
    for (const int corner : triangle)
    {
      for (const double coordinate : Points[corner])
      {
        bytes += Bytes(float(coordinate), false);
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string
TextSTL()
{
  std::string text = "solid tetrahedron\n";
  for (const auto & triangle : Triangles)
  {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const int corner : triangle)
    {
      const double * x = Points[corner];
      text += "   vertex " + std::to_string(x[0]) + ' ' + std::to_string(x[1]) + ' ' + std::to_string(x[2]) + '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

bool
HasMeshIO(const std::string & extension)
{
  return itk::MeshIOFactory::CreateMeshIO(("a" + extension).c_str(), itk::CommonEnums::IOFileMode::WriteMode) !=
         nullptr;
}

std::string
Lines(const std::string & pointWord, const std::string & cellWord, int first)
{
  std::string text;
  for (const auto & point : Points)
  {
    text +=
      pointWord + std::to_string(point[0]) + ' ' + std::to_string(point[1]) + ' ' + std::to_string(point[2]) + '\n';
  }
  if (cellWord.empty())
  {
    return text;
  }
  for (const auto & corners : Triangles)
  {
    text += cellWord;
    for (const int corner : corners)
    {
      text += std::to_string(corner + first) + ' ';
    }
    text += '\n';
  }
  return text;
}

std::string
FreeSurfer(const std::string & footer)
{
  std::string bytes = "\xFF\xFF\xFE" + std::string("made for a test\n\n") + Bytes(std::int32_t{ 4 }, true) +
                      Bytes(std::int32_t{ 4 }, true);
  for (const auto & point : Points)
  {
    for (const double coordinate : point)
    {
      bytes += Bytes(float(coordinate), true);
    }
  }
  for (const auto & triangle : Triangles)
  {
    for (const int corner : triangle)
    {
      bytes += Bytes(std::int32_t{ corner }, true);
    }
  }
  return bytes + footer;
}

class SurfaceFileReader : public testing::Test
{
public:
  SurfaceFileReader()
    : m_Folder(std::filesystem::temp_directory_path() /
               ("surfaces-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name())))
  {
    std::filesystem::create_directories(m_Folder);
  }
  ~SurfaceFileReader() override { std::filesystem::remove_all(m_Folder); }

  itk::LabelInterfaceMesh::Pointer
  Read(const std::string & name, const std::string & bytes, bool ras = false) const
  {
    const auto path = (m_Folder / name).string();
    std::ofstream(path, std::ios::binary) << bytes;
    const auto reader = itk::SurfaceFileReader::New();
    reader->SetFileName(path);
    reader->SetFilesAreInRAS(ras);
    return reader->Read();
  }

  /** The first corner of the first triangle, and the others' sum, tell the surface. */
  void
  ExpectTetrahedron(const itk::LabelInterfaceMesh * mesh, double sign, const Vector & offset = Vector::Zero()) const
  {
    const auto points = mmmtest::PointsOf(mesh);
    const auto triangles = mmmtest::CellsOf<3>(mesh);
    ASSERT_EQ(triangles.size(), 4u);
    for (int t = 0; t < 4; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double * x = Points[Triangles[t][k]];
        const Vector   known(sign * (x[0] + offset[0]), sign * (x[1] + offset[1]), x[2] + offset[2]);
        EXPECT_LT((points[triangles[t][k]] - known).norm(), 1e-5);
      }
    }
  }

  void
  ExpectError(const std::string & name, const std::string & bytes, const std::string & words) const
  {
    mmmtest::ExpectException([&] { this->Read(name, bytes); }, words);
  }

private:
  std::filesystem::path m_Folder;
};
} // namespace

TEST_F(SurfaceFileReader, ReadsSTL)
{
  this->ExpectTetrahedron(this->Read("binary.stl", BinarySTL("solid as texts begin")), 1.0);
  this->ExpectTetrahedron(this->Read("text.STL", TextSTL()), 1.0);
}

TEST_F(SurfaceFileReader, ReadsOBJAndOFF)
{
  this->ExpectTetrahedron(this->Read("a.obj", "# a\n" + Lines("v ", "f ", 1)), 1.0);
  this->ExpectTetrahedron(
    this->Read("b.obj", Lines("v ", "", 0) + "f 1//1 3//2 2//1\nf 1/1 2/1 4/1\nf -3 -2 -1\nf 1 4 3\n"), 1.0);
  const std::string triangles = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  this->ExpectTetrahedron(this->Read("a.off", "OFF\n4 4 6\n" + Lines("", "", 0) + triangles), 1.0);
}

TEST_F(SurfaceFileReader, ReadsVTKWhereITKDoes)
{
  if (!HasMeshIO(".vtk"))
  {
    GTEST_SKIP() << "ITK was built without its module for .vtk";
  }
  this->ExpectTetrahedron(this->Read("a.vtk",
                                     "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" +
                                       Lines("", "", 0) + "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"),
                          1.0);
}

TEST_F(SurfaceFileReader, ReadsGIFTIWhereITKDoes)
{
  if (!HasMeshIO(".gii"))
  {
    GTEST_SKIP() << "ITK was built without its module for .gii";
  }
  const auto array = [](const std::string & intent, const std::string & type, const std::string & numbers) {
    return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type +
           "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\" Encoding=\"ASCII\" "
           "Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\"><MetaData/><Data>" +
           numbers + "</Data></DataArray>";
  };
  this->ExpectTetrahedron(this->Read("a.gii",
                                     "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<GIFTI Version=\"1.0\" "
                                     "NumberOfDataArrays=\"2\"><MetaData/><LabelTable/>" +
                                       array("POINTSET", "FLOAT32", "1 2 3 5 2 3 1 7 3 1 2 9") +
                                       array("TRIANGLE", "INT32", "0 2 1 0 1 3 1 2 3 0 3 2") + "</GIFTI>"),
                          -1.0);
}

TEST_F(SurfaceFileReader, TakesPointsForRASWhereTheFileOrTheUserSaysSo)
{
  this->ExpectTetrahedron(this->Read("a.stl", BinarySTL("SPACE=RAS")), -1.0);
  this->ExpectTetrahedron(this->Read("b.stl", BinarySTL(""), true), -1.0);
  this->ExpectTetrahedron(this->Read("c.obj", "# SPACE=RAS\n" + Lines("v ", "f ", 1)), -1.0);
}

TEST_F(SurfaceFileReader, PutsFreeSurfersSurfacesIntoTheSpaceOfTheScanner)
{
  const std::string volume = "valid = 1  # volume info valid\nfilename = orig.mgz\nvolume = 256 256 256\n"
                             "voxelsize = 1 1 1\nxras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\n"
                             "cras   = 10 -20 30.5\n";
  const std::string tag = Bytes(std::int32_t{ 20 }, true);
  const auto        mesh = this->Read("lh.pial", FreeSurfer(tag + volume));
  this->ExpectTetrahedron(mesh, -1.0, Vector(10.0, -20.0, 30.5));
  const std::string inScannerSpace = Bytes(std::int32_t{ 2 }, true) + Bytes(std::int32_t{ 1 }, true);
  this->ExpectTetrahedron(this->Read("lh.white", FreeSurfer(inScannerSpace + tag + volume)), -1.0);
  this->ExpectTetrahedron(this->Read("inner_skull.surf", FreeSurfer("")), -1.0);
}

TEST_F(SurfaceFileReader, RefusesWhatIsDamaged)
{
  const auto stl = BinarySTL("");
  this->ExpectError("a.stl", stl.substr(0, stl.size() - 7), "its size is not that of the 4 triangles");
  this->ExpectError("b.stl", TextSTL().substr(0, 200), "its end is missing");
  this->ExpectError("c.stl", "solid\nvertex 1 2 x\nendsolid\n", "line 2 is no corner of a triangle");
  const auto surface = FreeSurfer("");
  this->ExpectError(
    "lh.pial", surface.substr(0, surface.size() - 1), "it is too short for the 4 points and 4 triangles");
  this->ExpectError("a.obj", Lines("v ", "f ", 3), "has a point that is not among its 4 points");
  this->ExpectError("b.obj", Lines("v ", "f ", 1) + "v nan 1 2\nf 1 2 5\n", "line 9 is no point");
  this->ExpectError("a.off", "OFF\n4 4 0\n" + Lines("", "", 0) + "3 0 2 1\n", "its end is missing");
  this->ExpectError("b.off", "OFF\n4 4 0\n0 0\n", "line 3 is no point");
  auto points = BinarySTL("");
  points.replace(84 + 12, 4, Bytes(std::numeric_limits<float>::quiet_NaN(), false));
  this->ExpectError("d.stl", points, "coordinate that is no finite number");
}

TEST_F(SurfaceFileReader, RefusesWhatIsNoSurfaceOfTriangles)
{
  this->ExpectError(
    "a.obj", Lines("v ", "f ", 1) + "f 1 2 3 4\n", "cell 4 has 4 points; triangulate the surface first");
  this->ExpectError("b.obj", "# nothing\n", "the file has no triangles");
  this->ExpectError("a.txt", "text", "this is not a surface of triangles, or one of a format that cannot be read");
}

TEST_F(SurfaceFileReader, RefusesVTKOfVersion5)
{
  if (!HasMeshIO(".vtk"))
  {
    GTEST_SKIP() << "ITK was built without its module for .vtk";
  }
  this->ExpectError(
    "a.vtk",
    "# vtk DataFile Version 5.1\na\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" + Lines("", "", 0) +
      "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 1 2 3 0 3 2\n",
    "this is VTK's format of version 5, which is not read");
}

TEST_F(SurfaceFileReader, SaysThatThereIsNoFile)
{
  const auto reader = itk::SurfaceFileReader::New();
  reader->SetFileName("nowhere.stl");
  mmmtest::ExpectException([&] { reader->Read(); }, "nowhere.stl: there is no such file");
}
