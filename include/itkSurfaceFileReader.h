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
#ifndef itkSurfaceFileReader_h
#define itkSurfaceFileReader_h

#include "MultiMaterialMeshingExport.h"
#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"

#include "itkObject.h"
#include "itkObjectFactory.h"

#include <string>

namespace itk
{
/** \class SurfaceFileReader
 * \brief Reads a surface of triangles, and puts it where its file says.
 *
 * STL (binary and text), Wavefront .obj, .off and FreeSurfer's binary surfaces (such as lh.pial, of any extension) are
 * read here; others by the MeshIO that are registered with ITK, among them those for GIFTI (.gii) and legacy VTK (.vtk,
 * up to version 4.2). In all of them cells are to be triangles.
 *
 * The points of the mesh are in mm and LPS. Those of FreeSurfer and GIFTI files are in RAS, and so are those of other
 * files whose first bytes have the text SPACE=RAS, as 3D Slicer and this module write it; further ones are in LPS, or
 * in RAS if FilesAreInRAS. FreeSurfer's own space is that of a volume, which is in the file; points are moved to the
 * scanner's space by it. Without it they are taken to be there, with a warning.
 *
 * All failures are ExceptionObjects whose description is the file's name, what is wrong with it, and what to do.
 *
 * \sa TriangleSurfaceToDistanceImageFilter
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT SurfaceFileReader : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SurfaceFileReader);

  using Self = SurfaceFileReader;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using MeshType = LabelInterfaceMesh;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(SurfaceFileReader);

  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** Whether points are in RAS in files that do not say. Default: false, they are in LPS. */
  itkSetMacro(FilesAreInRAS, bool);
  itkGetConstMacro(FilesAreInRAS, bool);
  itkBooleanMacro(FilesAreInRAS);

  /** Points and triangles, without data. */
  MeshType::Pointer
  Read();

protected:
  SurfaceFileReader() = default;
  ~SurfaceFileReader() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string m_FileName;
  bool        m_FilesAreInRAS{ false };
};
} // end namespace itk

#endif
