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
#ifndef itkLabelMeshFileWriter_h
#define itkLabelMeshFileWriter_h

#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"
#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingLabels.h"

#include "itkObject.h"
#include "itkObjectFactory.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
class MeshIOBase;

/** \class LabelMeshFileWriter
 * \brief Writes a mesh's tetrahedra or the surface between its labels to a file of the format that its name tells.
 *
 * - `.vtu`: the tetrahedra with the cell array `label`; without tetrahedra, the triangles with `label_a` and `label_b`.
 * - `.msh` (Gmsh) and `.mesh` (Medit): the triangles, a group for each pair of labels, and the tetrahedra, a group for
 *   each label, if there are some.
 * - `.stl`, `.obj`, `.off`, `.surf` (FreeSurfer): the triangles, without labels.
 *
 * Labels can have names, see SetLabelTable(), and tetrahedra further numbers, see AddCellData().
 *
 * The surface's points have to be the first ones of the tetrahedra's, as they are from the filters of this module. A
 * file appears under its name only when it is complete, see OutputFile.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT LabelMeshFileWriter : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelMeshFileWriter);

  using Self = LabelMeshFileWriter;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelMeshFileWriter);

  /** None (null, the default) writes the surface alone. */
  itkSetConstObjectMacro(Tetrahedra, LabelTetrahedralMesh);
  itkGetConstObjectMacro(Tetrahedra, LabelTetrahedralMesh);

  /** Needed for all but tetrahedra in a `.vtu` file. */
  itkSetConstObjectMacro(Surface, LabelInterfaceMesh);
  itkGetConstObjectMacro(Surface, LabelInterfaceMesh);

  /** What the elements of second order have besides their corners, GetMidNodes() of the filters. With it, which may be
   * empty, `.vtu` and `.msh` files have triangles of six nodes and tetrahedra of ten, in the orders of VTK and Gmsh;
   * `.stl`, `.obj`, `.off` and `.surf` have flat triangles nevertheless, and `.mesh` and "simnibs" are refused. None
   * (null, the default) writes elements of first order. */
  itkSetConstObjectMacro(MidNodes, LabelMidNodeMesh);
  itkGetConstObjectMacro(MidNodes, LabelMidNodeMesh);

  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** Of `.msh` files: one of GetMshFormats(). "simnibs" is version 2.2 with points in RAS and the numbers of SimNIBS:
   * labels from 1 to 999, and for a surface 1000 and the label of the tissue inside. Default "4.1". */
  itkSetStringMacro(MshFormat);
  itkGetStringMacro(MshFormat);

  /** Whether points are in RAS, in all files but `.vtu`, which are always in LPS, and `.surf`, which are always in RAS.
   * Default false. */
  itkSetMacro(RAS, bool);
  itkGetConstMacro(RAS, bool);
  itkBooleanMacro(RAS);

  /** Whether `.vtu` files say that they are in LPS, see VTUMeshIO. Default false. */
  itkSetMacro(WriteSpace, bool);
  itkGetConstMacro(WriteSpace, bool);
  itkBooleanMacro(WriteSpace);

  /** The label of what is not meshed, GetOutsideLabel() of the filters. Used by "simnibs". Default 0. */
  itkSetMacro(OutsideLabel, int);
  itkGetConstMacro(OutsideLabel, int);

  /** What labels are called and how they are drawn; entries of labels that the mesh has not are left out. In `.msh` and
   * `.mesh` files the names are those of the groups: "gray matter", and of the triangles between two labels
   * "gray matter|white matter"; what has no name is "label 3" and "labels 0 3" as ever. `.vtu` files have names and
   * colors as field data, see VTUMeshIO. "simnibs" has no names. A name that several labels have is followed by the
   * label: "cortex (3)". Default: none. */
  void
  SetLabelTable(const mmm::LabelTable & table);
  itkGetConstReferenceMacro(LabelTable, mmm::LabelTable);

  /** Adds a name to the table, or changes it. */
  void
  SetLabelName(int label, const std::string & name);

  /** Adds numbers of the tetrahedra, one tetrahedron after the other: 1 each, 3 (a vector in LPS) or 9 (a tensor in
   * LPS, row by row). They are cell data of this name in `.vtu` files and `$ElementData` in `.msh` files, where
   * triangles have NaN; with RAS, vectors and tensors are turned with the points. Other files cannot have them: Write()
   * throws then. The same name again replaces the numbers. */
  void
  AddCellData(const std::string & name, const std::vector<double> & values);

  /** The extensions of files that hold them, with their points. */
  static const std::vector<std::string> &
  GetCellDataExtensions();

  /** Throws an ExceptionObject, and leaves no file, if it cannot. */
  void
  Write() const;

  /** What there is for `.msh` files: "4.1", "4.1-ascii", "2.2", "2.2-ascii", "simnibs". */
  static const std::vector<std::string> &
  GetMshFormats();

  /** The extensions of files for tetrahedra, and of those for surfaces, with their points. */
  static const std::vector<std::string> &
  GetVolumeExtensions();
  static const std::vector<std::string> &
  GetSurfaceExtensions();

  /** The one of these that the file name ends with; an empty text if there is none. */
  static std::string
  FindExtension(const std::string & fileName, const std::vector<std::string> & extensions);

protected:
  LabelMeshFileWriter() = default;
  ~LabelMeshFileWriter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  bool
  IsForSimNIBS() const;
  template <typename TMesh>
  void
  WriteBy(MeshIOBase * io, const TMesh * mesh, bool isText = false) const;
  void
  WriteGroups(const std::string & extension) const;
  void
  CheckCellData(const std::string & extension) const;
  /** Those of the mesh's labels, in the form that files have. */
  mmm::LabelTable
  NamesInUse() const;

  LabelTetrahedralMesh::ConstPointer m_Tetrahedra;
  LabelInterfaceMesh::ConstPointer   m_Surface;
  LabelMidNodeMesh::ConstPointer     m_MidNodes;
  std::string                        m_FileName;
  std::string                        m_MshFormat{ "4.1" };
  bool                               m_RAS{ false };
  bool                               m_WriteSpace{ false };
  int                                m_OutsideLabel{ 0 };
  mmm::LabelTable                    m_LabelTable;

  std::map<std::string, std::vector<double>> m_CellData;
};
} // end namespace itk

#endif
