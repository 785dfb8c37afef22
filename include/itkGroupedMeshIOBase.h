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
#ifndef itkGroupedMeshIOBase_h
#define itkGroupedMeshIOBase_h

#include "MultiMaterialMeshingExport.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkMeshIOBase.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

namespace mmm
{
struct CellMesh;
}

namespace itk
{
/** \class GroupedMeshIOBase
 * \brief What the mesh IOs have in common whose files number groups of cells: the labels are the numbers.
 *
 * The cells may be vertices, lines, triangles, quadrilaterals, tetrahedra and hexahedra, mixed if need be. The cell
 * pixel is one label, or several, such as the two of a triangle between labels: whole numbers of at most 64 bits. What
 * a file cannot have as number (a pair, or a number out of its range) is numbered anew; a warning says so, and the name
 * of the group says which labels it stands for: "label -7", "labels 0 2". Reading understands these names, so that no
 * label is lost. Groups of other names, and those without, have their number as label.
 *
 * Files have no data of points: a warning says so if a mesh has some.
 *
 * Reading gives coordinates as double, and labels as int, or as 64-bit integers if need be. A file that is damaged or
 * not supported gives an ExceptionObject that says what is wrong with it. No array is allocated before the file was
 * found to be large enough for its data. A file that is written appears under its name only when it is complete.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT GroupedMeshIOBase : public MeshIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(GroupedMeshIOBase);

  /** Standard class type aliases. */
  using Self = GroupedMeshIOBase;
  using Superclass = MeshIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  /** The dimension of its cells and its number, and the name of a group. */
  using GroupNamesType = std::map<std::pair<int, int>, std::string>;

  /** \see LightObject::GetNameOfClass() */
  itkOverrideGetNameOfClassMacro(GroupedMeshIOBase);

  /** The names of groups. Reading: those of the file. Writing: those given here instead of "label 3" and the like;
   * names of groups that the mesh does not have are left out. */
  void
  SetGroupNames(const GroupNamesType & names);
  const GroupNamesType &
  GetGroupNames() const
  {
    return m_GroupNames;
  }

  /** Whether the file's points are in RAS, as NIfTI's are: x and y change their signs when it is read or written. Such
   * files do not say what they are in. Default: false, they are in LPS, as ITK's points are. */
  itkSetMacro(RAS, bool);
  itkGetConstMacro(RAS, bool);
  itkBooleanMacro(RAS);

  /** True for an existing file of this extension. */
  bool
  CanReadFile(const char * fileName) override;

  /** Reads and checks the whole file. */
  void
  ReadMeshInformation() override;

  /** These hand over what ReadMeshInformation() read. */
  void
  ReadPoints(void * buffer) override;
  void
  ReadCells(void * buffer) override;
  void
  ReadPointData(void * buffer) override;
  void
  ReadCellData(void * buffer) override;

  /** True for a file name of this extension. */
  bool
  CanWriteFile(const char * fileName) override;

  /** Starts a new file. */
  void
  WriteMeshInformation() override;

  /** These keep their part of the mesh in memory. Whatever is wrong with it, Write() says. */
  void
  WritePoints(void * buffer) override;
  void
  WriteCells(void * buffer) override;
  void
  WritePointData(void * buffer) override;
  void
  WriteCellData(void * buffer) override;

  /** Writes the file, or throws and leaves none. */
  void
  Write() override;

protected:
  /** The extension has its point: ".msh". */
  explicit GroupedMeshIOBase(const std::string & extension);
  ~GroupedMeshIOBase() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  virtual void
  ReadFile(mmm::CellMesh & mesh) = 0;
  virtual void
  WriteFile(const mmm::CellMesh & mesh) = 0;

  /** The lowest number that a group can have in the file. */
  virtual int
  GetLowestGroup() const = 0;

  /** Whether cells without group have no label. If not, theirs is 0. */
  virtual bool
  HasCellsWithoutGroup() const = 0;

private:
  template <typename TBody>
  void
  ReadPart(TBody body);
  template <typename TBody>
  void
  WritePart(TBody body);

  std::string                    m_Extension;
  GroupNamesType                 m_GroupNames;
  bool                           m_RAS{ false };
  std::unique_ptr<mmm::CellMesh> m_Mesh;
  /** Told by Write(): if the writing of a part throws, itk::MeshFileWriter does not free the part. */
  std::string m_WriteError;
};
} // end namespace itk

#endif
