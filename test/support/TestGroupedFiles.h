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
#ifndef mmmTestGroupedFiles_h
#define mmmTestGroupedFiles_h

#include "support/TestVTUFiles.h"

#include "itkGroupedMeshIOBase.h"

#include "itkOutputWindow.h"
#include "itkTriangleCell.h"

/** What the tests of GmshMeshIO and MeditMeshIO share. */
namespace mmmGroupedTest
{
using namespace mmmVTUTest;
using BaseIO = itk::GroupedMeshIOBase;

/** Catches ITK's warnings while it is there. */
class Warnings : public itk::OutputWindow
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(Warnings);

  using Self = Warnings;
  using Superclass = itk::OutputWindow;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

  static Pointer
  Catch()
  {
    const auto warnings = New();
    SetInstance(warnings);
    return warnings;
  }

  /** What was said; from here on, ITK prints warnings again. */
  std::string
  Release()
  {
    SetInstance(nullptr);
    return m_Text;
  }

  void
  DisplayText(const char * text) override
  {
    m_Text += text;
  }

protected:
  Warnings() = default;
  ~Warnings() override = default;

private:
  std::string m_Text;
};

template <typename TMesh>
void
WriteBy(BaseIO * io, const TMesh * mesh, const std::string & name, bool isText)
{
  const auto writer = itk::MeshFileWriter<TMesh>::New();
  writer->SetInput(mesh);
  writer->SetFileName(name);
  writer->SetMeshIO(io);
  if (isText)
  {
    writer->SetFileTypeAsASCII();
  }
  else
  {
    writer->SetFileTypeAsBINARY();
  }
  writer->Update();
}

template <typename TMesh = MeshType>
typename TMesh::Pointer
ReadBy(BaseIO * io, const std::string & name)
{
  const auto reader = itk::MeshFileReader<TMesh>::New();
  reader->SetFileName(name);
  reader->SetMeshIO(io);
  reader->Update();
  return reader->GetOutput();
}

/** What reading says of the file, or an empty text if it is read. */
inline std::string
ErrorBy(BaseIO * io, const std::string & name)
{
  try
  {
    ReadBy(io, name);
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return {};
}

/** The labels of a file's cells, as 64-bit integers, component by component. */
inline std::vector<std::int64_t>
LabelsBy(BaseIO * io, const std::string & name)
{
  io->SetFileName(name);
  io->ReadMeshInformation();
  const std::size_t         count = io->GetNumberOfCellPixels() * io->GetNumberOfCellPixelComponents();
  std::vector<std::int64_t> labels(count);
  if (io->GetCellPixelComponentType() == itk::IOComponentEnum::INT)
  {
    std::vector<int> values(count);
    io->ReadCellData(values.data());
    labels.assign(values.begin(), values.end());
  }
  else
  {
    io->ReadCellData(labels.data());
  }
  return labels;
}

/** A triangle and a tetrahedron by turns, with the labels given. */
template <typename TPixel>
typename MeshOf<TPixel>::Pointer
MakeMixed(const std::vector<TPixel> & labels)
{
  using Mesh = MeshOf<TPixel>;
  const auto mesh = Mesh::New();
  AddPoints(mesh.GetPointer());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (i % 2 == 0)
    {
      AddCell<itk::TriangleCell<typename Mesh::CellType>>(mesh.GetPointer(), { 2, 1, 4 });
    }
    else
    {
      AddCell<itk::TetrahedronCell<typename Mesh::CellType>>(mesh.GetPointer(), { 3, 1, 0, 2 });
    }
    mesh->SetCellData(i, labels[i]);
  }
  return mesh;
}

/** Two meshes of one kind have the same points and cells, in the same order. */
template <typename TMesh>
void
ExpectSame(const TMesh * mesh, const TMesh * expected)
{
  ASSERT_EQ(mesh->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (itk::IdentifierType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(mesh->GetPoint(i), expected->GetPoint(i));
  }
  ASSERT_EQ(mesh->GetNumberOfCells(), expected->GetNumberOfCells());
  for (itk::IdentifierType i = 0; i < expected->GetNumberOfCells(); ++i)
  {
    typename TMesh::CellAutoPointer cell;
    typename TMesh::CellAutoPointer expectedCell;
    ASSERT_TRUE(mesh->GetCell(i, cell));
    ASSERT_TRUE(expected->GetCell(i, expectedCell));
    EXPECT_EQ(cell->GetType(), expectedCell->GetType());
    EXPECT_EQ(std::vector<itk::IdentifierType>(cell->PointIdsBegin(), cell->PointIdsEnd()),
              std::vector<itk::IdentifierType>(expectedCell->PointIdsBegin(), expectedCell->PointIdsEnd()));
    EXPECT_EQ(mesh->GetCellData()->ElementAt(i), expected->GetCellData()->ElementAt(i));
  }
}

/** A damage of a file, and a part of what reading has to say of it. */
struct GroupedDamage
{
  const char * part;
  const char * by;
  const char * error;
};

/** How many of the damaged files were rejected, and how many there were. */
template <typename TIO>
std::pair<std::size_t, std::size_t>
ReadDamaged(const std::vector<std::string> & files, const std::string & name, std::size_t trials)
{
  return CountRejected(files, trials, [&](const std::string & damaged) {
    Save(name, damaged);
    return !ErrorBy(TIO::New(), name).empty();
  });
}
} // namespace mmmGroupedTest

#endif
