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
#ifndef itkGmshMeshIO_h
#define itkGmshMeshIO_h

#include "itkGroupedMeshIOBase.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class GmshMeshIO
 * \brief Reads and writes meshes as Gmsh files (`.msh`), versions 2.2 and 4.1, text and binary, labels as physical
 * groups.
 *
 * Groups are numbered from 1: a label of 0 or below is numbered anew, and its group's name has it. A mesh may have
 * tetrahedra and, as cells of the same mesh, the triangles between them; groups of different dimension may have the
 * same number. Cells keep their order. See GroupedMeshIOBase for the rest.
 *
 * Writing: text if the file type is ASCII, which itk::MeshFileWriter sets unless told otherwise, else binary, which an
 * IO on its own starts with. In version 4.1, each group is an entity of its number, without shape and borders.
 *
 * Besides the labels, cells can have numbers, see SetCellArrays().
 *
 * Reading: either version and byte order; elements of first order. Other sections, such as those of post-processing,
 * are skipped. If an entity belongs to several physical groups, the first one counts, and a warning says so. A mesh
 * without physical groups has no cell data.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT GmshMeshIO : public GroupedMeshIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(GmshMeshIO);

  /** Standard class type aliases. */
  using Self = GmshMeshIO;
  using Superclass = GroupedMeshIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  /** Numbers of all cells, one cell after the other, by name. */
  using CellArraysType = std::map<std::string, std::vector<double>>;

  /** Method for creation through the object factory. */
  itkNewMacro(Self);

  /** \see LightObject::GetNameOfClass() */
  itkOverrideGetNameOfClassMacro(GmshMeshIO);

  /** Whether to write version 2.2, which some programs ask for, instead of 4.1. Default: false. */
  itkSetMacro(Version2, bool);
  itkGetConstMacro(Version2, bool);
  itkBooleanMacro(Version2);

  /** Whether to write the names of physical groups. Without, labels that are numbered anew are lost. Default: true. */
  itkSetMacro(WriteGroupNames, bool);
  itkGetConstMacro(WriteGroupNames, bool);
  itkBooleanMacro(WriteGroupNames);

  /** Writing: sections `$ElementData`, each with 1, 3 or 9 numbers per cell: scalars, vectors, tensors row by row. With
   * RAS, the latter two are turned as the points are. What is no number is written as such. In version 4.1, elements
   * are then numbered group by group, as meshio (5.3) wants it, and read back in this order. Default: none. */
  void
  SetCellArrays(const CellArraysType & arrays);
  const CellArraysType &
  GetCellArrays() const
  {
    return m_CellArrays;
  }

protected:
  GmshMeshIO();
  ~GmshMeshIO() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  ReadFile(mmm::CellMesh & mesh) override;
  void
  WriteFile(const mmm::CellMesh & mesh) override;

  int
  GetLowestGroup() const override
  {
    return 1;
  }

  bool
  HasCellsWithoutGroup() const override
  {
    return true;
  }

private:
  bool m_Version2{ false };
  bool m_WriteGroupNames{ true };

  CellArraysType m_CellArrays;
};
} // end namespace itk

#endif
