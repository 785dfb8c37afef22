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
#ifndef itkVTUMeshIO_h
#define itkVTUMeshIO_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingLabels.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkMeshIOBase.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \class VTUMeshIO
 * \brief Reads and writes meshes as VTK XML unstructured grids (`.vtu`), with their labels.
 *
 * Vertices, lines, triangles, quadrilaterals, polygons, tetrahedra, hexahedra and the quadratic edges and triangles of
 * ITK are supported, mixed if need be. Coordinates are those of ITK (LPS), which is what 3D Slicer takes a file for
 * that says nothing else. A file whose field data array `SPACE`, which is Slicer's, is RAS is converted to LPS.
 *
 * Writing: the file is text if the file type is ASCII, else base64, compressed by zlib if UseCompression is on.
 * itk::MeshFileWriter sets both, to ASCII and off unless told otherwise; an IO on its own starts with compressed
 * base64. Points are Float64 if the mesh's coordinates are double, else Float32; other types are kept. A mesh without
 * cells gets one vertex cell per point, so that viewers show it. The file appears under its name only when it is
 * complete.
 *
 * Reading: files with one piece, with data as text, inline or appended, base64 or raw, zlib-compressed or not, of
 * either byte order. Polylines and poly-vertices are read as single lines and vertices that share the data of the cell.
 * Points have three coordinates: read into meshes of three dimensions. A file that is damaged or not supported gives an
 * ExceptionObject that says what is wrong with it. No array is allocated before the file was found to hold its data.
 *
 * MeshIOBase passes one pixel per cell and per point, a file can hold any number of arrays: CellDataNames and
 * PointDataNames say which arrays belong to the pixel.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT VTUMeshIO : public MeshIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VTUMeshIO);

  /** Standard class type aliases. */
  using Self = VTUMeshIO;
  using Superclass = MeshIOBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using SizeValueType = Superclass::SizeValueType;
  using NamesType = std::vector<std::string>;
  /** Numbers of all cells, one cell after the other, by name. */
  using CellArraysType = std::map<std::string, std::vector<double>>;

  /** Method for creation through the object factory. */
  itkNewMacro(Self);

  /** \see LightObject::GetNameOfClass() */
  itkOverrideGetNameOfClassMacro(VTUMeshIO);

  /** Names of the cell data arrays, one per component of the cell pixel. Default: {"label"}.
   *
   * Writing: if there are as many names as components, each component becomes an array of that name. If not, two
   * components become "label_a" and "label_b", any other number of them one array "CellData".
   *
   * Reading: if the names are not the default ones and the file has them all, these are joined to one pixel; else
   * "label_a", "label_b", ... as far as they go, two at least; else "label"; else the first array. */
  void
  SetCellDataNames(const NamesType & names);
  const NamesType &
  GetCellDataNames() const
  {
    return m_CellDataNames;
  }

  /** Reading: the names of the arrays that the cell pixel was joined from, after ReadMeshInformation(). */
  const NamesType &
  GetReadCellDataNames() const
  {
    return m_ReadCellDataNames;
  }

  /** Names of the point data arrays, one per component of the point pixel. Default: {"point_data"}.
   *
   * Writing: if there are as many names as components, each component becomes an array of that name; if not, they
   * become one array "PointData". Reading: if the file has them all, they are joined to one pixel; else the first
   * array. */
  void
  SetPointDataNames(const NamesType & names);
  const NamesType &
  GetPointDataNames() const
  {
    return m_PointDataNames;
  }

  /** Whether to write the field data array `SPACE`, which says that the points are in LPS. Default: false, as the
   * Python package meshio (5.3), and what uses it, ends at such a string array. 3D Slicer needs it for models of scenes
   * that were saved before Slicer 4.11, which are in RAS unless their file says otherwise. */
  itkSetMacro(WriteSpace, bool);
  itkGetConstMacro(WriteSpace, bool);
  itkBooleanMacro(WriteSpace);

  /** Writing: further cell data arrays, of 1, 3 or 9 numbers per cell. Default: none. */
  void
  SetCellArrays(const CellArraysType & arrays);
  const CellArraysType &
  GetCellArrays() const
  {
    return m_CellArrays;
  }

  /** Writing: what labels are called and how they are drawn, as field data of numbers, as meshio (5.3) cannot read
   * texts. An array that has the label's name holds the label and 3, the dimension of its cells, as meshio has the
   * names of groups; `label_colors` has four columns, the label and its red, green and blue from 0 to 1. Names should
   * differ. Default: none. */
  void
  SetLabelTable(const mmm::LabelTable & table);
  const mmm::LabelTable &
  GetLabelTable() const
  {
    return m_LabelTable;
  }

  /*-------- This part of the interface deals with reading data. ----- */

  /** True for an existing file whose extension is .vtu. */
  bool
  CanReadFile(const char * fileName) override;

  /** Reads and checks the whole file. */
  void
  ReadMeshInformation() override;

  /** These hand over what ReadMeshInformation() read and release it, so that each can be called once. */
  void
  ReadPoints(void * buffer) override;
  void
  ReadCells(void * buffer) override;
  void
  ReadPointData(void * buffer) override;
  void
  ReadCellData(void * buffer) override;

  /*-------- This part of the interface deals with writing data. ----- */

  /** True for a file name whose extension is .vtu. */
  bool
  CanWriteFile(const char * fileName) override;

  /** Starts a new file. */
  void
  WriteMeshInformation() override;

  /** These encode their part of the file in memory. */
  void
  WritePoints(void * buffer) override;
  void
  WriteCells(void * buffer) override;
  void
  WritePointData(void * buffer) override;
  void
  WriteCellData(void * buffer) override;

  /** Writes the file. */
  void
  Write() override;

protected:
  VTUMeshIO();
  ~VTUMeshIO() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  struct ReadState;
  struct WriteState;

  template <typename T>
  void
  HandOver(std::vector<T> ReadState::* part, void * buffer);

  template <typename TBody>
  void
  WritePart(TBody body);

  NamesType m_CellDataNames{ "label" };
  NamesType m_ReadCellDataNames;
  NamesType m_PointDataNames{ "point_data" };
  bool      m_WriteSpace{ false };

  CellArraysType  m_CellArrays;
  mmm::LabelTable m_LabelTable;

  std::unique_ptr<ReadState>  m_Read;
  std::unique_ptr<WriteState> m_Written;
};
} // end namespace itk

#endif
