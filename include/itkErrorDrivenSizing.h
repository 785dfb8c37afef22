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
#ifndef itkErrorDrivenSizing_h
#define itkErrorDrivenSizing_h

#include "MultiMaterialMeshingExport.h"
#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkTetrahedronArrays.h"

#include "itkImage.h"
#include "itkObject.h"
#include "itkObjectFactory.h"

#include <string>
#include <vector>

namespace itk
{
/** \class ErrorDrivenSizing
 * \brief Edge lengths for the next mesh, by the errors of a solution on this one: smaller where the error is large.
 *
 * Each tetrahedron has an error indicator of at least 0, in any unit: its part of the norm of the error, such as the
 * norm over the tetrahedron of the difference between the gradient and a smoother, recovered one (Zienkiewicz and Zhu,
 * 1987). Edges are made shorter so that the tetrahedra of the next mesh have about the same error each: of all meshes
 * with as many, that has the least error. An indicator falls with the edge length to the power of p + 3/2, p the order
 * of the elements. No edge is made longer, as that could lose what the image shows, nor shorter than a quarter: to go
 * further, solve again on the next mesh.
 *
 * \sa LabelImageToTetrahedralMeshFilter::SetSizingImage(), which takes the result
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT ErrorDrivenSizing : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ErrorDrivenSizing);

  using Self = ErrorDrivenSizing;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using ImageType = Image<float, 3>;
  using ReferenceImageType = ImageBase<3>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ErrorDrivenSizing);

  /** The mesh, and one indicator for each of its cells, which have to be tetrahedra. Throws an ExceptionObject if there
   * are not as many, if one is negative or not a number, or if all are 0. */
  void
  SetErrors(const LabelTetrahedralMesh * mesh, const std::vector<double> & errors);

  /** The same from a `.vtu` file with the indicators as cell data. Cells of lower dimension are left out. */
  void
  ReadErrors(const std::string & fileName, const std::string & arrayName = "error");

  /** How many times as many tetrahedra the next mesh is to have, if all else is as it was: above 1, at most 64. What
   * the gradient limit of sizes adds around is not counted. Default: 2. */
  itkSetMacro(Factor, double);
  itkGetConstMacro(Factor, double);

  /** The order of the elements, 1 or 2. Default: 1. */
  itkSetMacro(Order, unsigned int);
  itkGetConstMacro(Order, unsigned int);

  /** Edge lengths in mm on the grid of an image, infinite where they may stay as they are. Throws an ExceptionObject if
   * there are no errors, a parameter is out of its range, or more than a tenth of the tetrahedra are outside of the
   * image. */
  ImageType::Pointer
  Compute(const ReferenceImageType * grid) const;

protected:
  ErrorDrivenSizing() = default;
  ~ErrorDrivenSizing() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  Set(TetrahedronArrays arrays, std::vector<double> errors);

  TetrahedronArrays   m_Mesh;
  std::vector<double> m_Errors;
  double              m_Factor{ 2.0 };
  unsigned int        m_Order{ 1 };
};
} // end namespace itk

#endif
