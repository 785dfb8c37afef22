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
// Names of labels and numbers of tetrahedra in the files that hold them.
#include "itkLabelMeshFileWriter.h"

#include "itkGmshMeshIO.h"
#include "itkMeditMeshIO.h"
#include "itkTetrahedronCell.h"
#include "itkTriangleCell.h"
#include "itkVTUMeshIO.h"
// Readers get their IO from the tests; ITK may not have generated the header that registers mesh IOs.
#undef ITK_IO_FACTORY_REGISTER_MANAGER
#include "itkMeshFileReader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{
namespace fs = std::filesystem;
using GroupNames = itk::GroupedMeshIOBase::GroupNamesType;

/** Two tetrahedra, of the labels 0 and 3, with the triangle between them and one at the outside, -1. */
class LabelMeshFileWriter : public testing::Test
{
public:
  LabelMeshFileWriter()
    : m_Folder(fs::temp_directory_path() /
               ("writer-" + std::to_string(
                              std::hash<std::string>()(testing::UnitTest::GetInstance()->current_test_info()->name()))))
  {
    fs::create_directories(m_Folder);
    const double points[][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    for (std::size_t n = 0; n < std::size(points); ++n)
    {
      m_Tetrahedra->SetPoint(n, itk::Point<double, 3>(points[n]));
      m_Surface->SetPoint(n, itk::Point<double, 3>(points[n]));
    }
    this->AddTetrahedron({ { 0, 1, 2, 3 } }, 3);
    this->AddTetrahedron({ { 0, 2, 1, 4 } }, 0);
    this->AddTriangle({ { 0, 1, 2 } }, 0, 3);
    this->AddTriangle({ { 1, 2, 3 } }, -1, 3);
    m_Writer->SetTetrahedra(m_Tetrahedra);
    m_Writer->SetSurface(m_Surface);
  }

  ~LabelMeshFileWriter() override { fs::remove_all(m_Folder); }

  std::string
  Write(const std::string & name) const
  {
    const std::string file = (m_Folder / name).string();
    m_Writer->SetFileName(file);
    m_Writer->Write();
    return file;
  }

  static std::string
  Contents(const std::string & file)
  {
    std::ifstream stream(file, std::ios::binary);
    return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  }

  template <typename TIO>
  static GroupNames
  NamesIn(const std::string & file)
  {
    const auto io = TIO::New();
    io->SetFileName(file);
    io->ReadMeshInformation();
    return io->GetGroupNames();
  }

  template <typename TIO>
  static std::vector<int>
  LabelsIn(const std::string & file)
  {
    const auto reader = itk::MeshFileReader<itk::LabelTetrahedralMesh>::New();
    reader->SetMeshIO(TIO::New());
    reader->SetFileName(file);
    reader->Update();
    return reader->GetOutput()->GetCellData()->CastToSTLConstContainer();
  }

  std::string
  ErrorOf(const std::string & name) const
  {
    try
    {
      this->Write(name);
    }
    catch (const itk::ExceptionObject & exception)
    {
      return exception.GetDescription();
    }
    return "";
  }

private:
  void
  AddTetrahedron(const std::array<int, 4> & corners, int label)
  {
    itk::LabelTetrahedralMesh::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TetrahedronCell<itk::LabelTetrahedralMesh::CellType>);
    std::copy(corners.begin(), corners.end(), cell->PointIdsBegin());
    const auto place = m_Tetrahedra->GetNumberOfCells();
    m_Tetrahedra->SetCell(place, cell);
    m_Tetrahedra->SetCellData(place, label);
  }

  void
  AddTriangle(const std::array<int, 3> & corners, int a, int b)
  {
    itk::LabelInterfaceMesh::CellAutoPointer cell;
    cell.TakeOwnership(new itk::TriangleCell<itk::LabelInterfaceMesh::CellType>);
    std::copy(corners.begin(), corners.end(), cell->PointIdsBegin());
    const auto              place = m_Surface->GetNumberOfCells();
    itk::FixedArray<int, 2> sides;
    sides[0] = a;
    sides[1] = b;
    m_Surface->SetCell(place, cell);
    m_Surface->SetCellData(place, sides);
  }

protected:
  fs::path                           m_Folder;
  itk::LabelTetrahedralMesh::Pointer m_Tetrahedra{ itk::LabelTetrahedralMesh::New() };
  itk::LabelInterfaceMesh::Pointer   m_Surface{ itk::LabelInterfaceMesh::New() };
  itk::LabelMeshFileWriter::Pointer  m_Writer{ itk::LabelMeshFileWriter::New() };
};
} // namespace

TEST_F(LabelMeshFileWriter, NamesOfGroupsAreThoseOfTheLabels)
{
  m_Writer->SetLabelTable({ { 3, { "gray matter", {} } }, { 0, { "air", {} } }, { 77, { "not there", {} } } });
  for (const char * const format : { "4.1", "4.1-ascii", "2.2", "2.2-ascii" })
  {
    m_Writer->SetMshFormat(format);
    const auto file = this->Write("mesh.msh");
    // the number of label 0 is none that Gmsh has
    const auto names = NamesIn<itk::GmshMeshIO>(file);
    EXPECT_EQ(names.at({ 3, 3 }), "gray matter") << format;
    EXPECT_EQ(names.at({ 2, 1001 }), "label -1|gray matter") << format;
    EXPECT_EQ(names.at({ 2, 1002 }), "air|gray matter") << format;
    EXPECT_EQ(names.at({ 3, 1003 }), "air (label 0)") << format;
    EXPECT_EQ(names.size(), 4u) << format;
    EXPECT_EQ(LabelsIn<itk::GmshMeshIO>(file), (std::vector<int>{ 1002, 1001, 3, 0 })) << format;
  }
  const auto medit = this->Write("mesh.mesh");
  EXPECT_EQ(NamesIn<itk::MeditMeshIO>(medit).at({ 3, 0 }), "air");
  EXPECT_EQ(LabelsIn<itk::MeditMeshIO>(medit), (std::vector<int>{ 1002, 1001, 3, 0 }));
}

TEST_F(LabelMeshFileWriter, NamesAreUniqueAndNoOtherThing)
{
  m_Writer->SetLabelTable({ { 3, { "cortex", {} } }, { 0, { "cor\"tex\n", {} } }, { -1, { "label 4", {} } } });
  auto names = NamesIn<itk::GmshMeshIO>(this->Write("mesh.msh"));
  EXPECT_EQ(names.at({ 3, 3 }), "cortex");
  EXPECT_EQ(names.at({ 2, 1001 }), "label 4 (-1)|cortex");
  EXPECT_EQ(names.at({ 2, 1002 }), "cor'tex|cortex");
  m_Writer->SetLabelName(0, "cortex");
  names = NamesIn<itk::GmshMeshIO>(this->Write("mesh.msh"));
  EXPECT_EQ(names.at({ 3, 3 }), "cortex (3)");
  EXPECT_EQ(names.at({ 2, 1002 }), "cortex (0)|cortex (3)");
}

TEST_F(LabelMeshFileWriter, VTUHasNamesAndColorsAsNumbers)
{
  m_Writer->SetLabelTable({ { 3, { "gray & white", { { 0.5, 0.25, 1.0 } } } }, { 77, { "not there", {} } } });
  m_Writer->WriteSpaceOn();
  const auto file = this->Write("mesh.vtu");
  const auto text = Contents(file);
  EXPECT_NE(text.find("<DataArray type=\"Int32\" Name=\"gray &amp; white\" NumberOfTuples=\"2\" format=\"ascii\">\n"
                      "        3 3\n"),
            std::string::npos)
    << text;
  EXPECT_NE(text.find("<DataArray type=\"Float64\" Name=\"label_colors\" NumberOfComponents=\"4\" NumberOfTuples=\"1\" "
                      "format=\"ascii\">\n        3 0.5 0.25 1\n"),
            std::string::npos)
    << text;
  EXPECT_EQ(text.find("not there"), std::string::npos);
  EXPECT_EQ(LabelsIn<itk::VTUMeshIO>(file), (std::vector<int>{ 3, 0 }));
}

TEST_F(LabelMeshFileWriter, CellDataAreThoseOfTheTetrahedra)
{
  m_Writer->AddCellData("conductivity", { 0.25, 1e-15 });
  m_Writer->AddCellData("axis", { 1, 2, 3, 4, 5, 6 });
  const auto vtu = this->Write("mesh.vtu");
  EXPECT_EQ(LabelsIn<itk::VTUMeshIO>(vtu), (std::vector<int>{ 3, 0 }));
  const auto reader = itk::MeshFileReader<itk::Mesh<double, 3>>::New();
  const auto io = itk::VTUMeshIO::New();
  io->SetCellDataNames({ "conductivity" });
  reader->SetMeshIO(io);
  reader->SetFileName(vtu);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellData()->CastToSTLConstContainer(), (std::vector<double>{ 0.25, 1e-15 }));

  m_Writer->SetMshFormat("2.2-ascii");
  auto text = Contents(this->Write("mesh.msh"));
  EXPECT_NE(text.find("$ElementData\n1\n\"conductivity\"\n1\n0\n3\n0\n1\n4\n1 nan\n2 nan\n3 0.25\n4 1e-15\n"
                      "$EndElementData\n"),
            std::string::npos)
    << text;
  // elements are numbered as they come: group by group
  m_Writer->SetMshFormat("4.1-ascii");
  text = Contents(this->Write("mesh.msh"));
  EXPECT_NE(text.find("1\n4\n1 nan\n2 nan\n3 0.25\n4 1e-15\n$EndElementData\n"), std::string::npos) << text;
  EXPECT_NE(text.find("3\n4\n1 nan nan nan\n2 nan nan nan\n3 1 2 3\n4 4 5 6\n"), std::string::npos) << text;
  m_Writer->SetMshFormat("4.1");
  EXPECT_EQ(LabelsIn<itk::GmshMeshIO>(this->Write("mesh.msh")), (std::vector<int>{ 1001, 1002, 3, 0 }));
}

TEST_F(LabelMeshFileWriter, VectorsAndTensorsTurnWithThePoints)
{
  m_Writer->AddCellData("axis", { 1, 2, 3, 4, 5, 6 });
  m_Writer->AddCellData("tensor", { 1, 2, 3, 2, 5, 6, 3, 6, 9, 1, 0, 0, 0, 1, 0, 0, 0, 1 });
  m_Writer->SetMshFormat("2.2-ascii");
  m_Writer->RASOn();
  const auto text = Contents(this->Write("mesh.msh"));
  EXPECT_NE(text.find("3 -1 -2 3\n4 -4 -5 6\n"), std::string::npos) << text;
  EXPECT_NE(text.find("3 1 2 -3 2 5 -6 -3 -6 9\n"), std::string::npos) << text;
}

TEST_F(LabelMeshFileWriter, CellDataThatAFileCannotHaveAreRefused)
{
  m_Writer->AddCellData("a", { 1, 2 });
  EXPECT_NE(this->ErrorOf("mesh.mesh").find("cannot have data of tetrahedra, 'a'"), std::string::npos);
  m_Writer->AddCellData("b", { 1, 2, 3 });
  EXPECT_NE(this->ErrorOf("mesh.vtu").find("The data 'b' are 3 numbers for 2 tetrahedra"), std::string::npos);
  m_Writer->SetTetrahedra(nullptr);
  EXPECT_NE(this->ErrorOf("mesh.vtu").find("but no tetrahedra"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(m_Folder));
}
