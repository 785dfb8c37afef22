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
#ifndef itkTriangleSurfaceToDistanceImageFilter_h
#define itkTriangleSurfaceToDistanceImageFilter_h

#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkSurfaceStages.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageSource.h"

#include <limits>

namespace itk
{
/** \class TriangleSurfaceToDistanceImageFilter
 * \brief The signed distance of a closed surface of triangles, in mm, positive inside, at the voxels of a given grid.
 *
 * Input: a mesh of triangles in physical space (LPS). Output: an image with the size, origin, spacing and direction of
 * ReferenceImage, whose values are exact distances to the triangles up to BandWidth, at which they are cut off.
 *
 * Inside is where the generalized winding number (Jacobson 2013) is above a half, in either direction: whether normals
 * point outward or inward does not matter. So a surface with small holes is closed, where that number is a half, and
 * one that overlaps itself encloses what its parts enclose together. Points at the same place count as one; triangles
 * that go round otherwise than their neighbours are turned. What there was of all this is known after Update().
 *
 * Update() throws an ExceptionObject if the mesh has no triangles, or cells of other kinds, or coordinates that are not
 * finite; if the surface lies outside the grid's box; and if it is far from closed: if the winding numbers near it are
 * off whole numbers by more than 0.1 on average, as those of a hemisphere are. The result does not depend on the number
 * of threads.
 *
 * LabelImageToTetrahedralMeshFilter meshes such images together with a label image, see its SetSurfaceDistanceImage().
 *
 * \tparam TInputMesh a mesh of three-dimensional points
 * \tparam TOutputImage a three-dimensional image of `float`
 *
 * \sa SurfaceFileReader
 * \ingroup MultiMaterialMeshing
 */
template <typename TInputMesh = LabelInterfaceMesh, typename TOutputImage = Image<float, 3>>
class ITK_TEMPLATE_EXPORT TriangleSurfaceToDistanceImageFilter : public ImageSource<TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TriangleSurfaceToDistanceImageFilter);

  using Self = TriangleSurfaceToDistanceImageFilter;
  using Superclass = ImageSource<TOutputImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using InputMeshType = TInputMesh;
  using OutputImageType = TOutputImage;
  using ReferenceImageType = ImageBase<3>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(TriangleSurfaceToDistanceImageFilter);

  itkConceptMacro(PointDimensionCheck, (Concept::SameDimension<TInputMesh::PointDimension, 3>));
  itkConceptMacro(FloatImageCheck, (Concept::Convertible<TOutputImage *, Image<float, 3> *>));

  /** The value of a length that follows the grid's smallest voxel spacing. It is not a number: test with std::isnan().
   */
  static constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

  using Superclass::SetInput;
  void
  SetInput(const TInputMesh * mesh);
  const TInputMesh *
  GetInput() const;

  /** The image whose size, origin, spacing and direction the output gets; its pixels are not looked at. Required. */
  itkSetConstObjectMacro(ReferenceImage, ReferenceImageType);
  itkGetConstObjectMacro(ReferenceImage, ReferenceImageType);

  /** The largest magnitude of the values, in mm, positive. Default: Automatic, 3 times the smallest voxel spacing,
   * which is what meshing asks for. */
  itkSetMacro(BandWidth, double);
  itkGetConstMacro(BandWidth, double);

  /** What follows is known after Update(). */

  /** Edges of one triangle only; 0 if the surface is closed. */
  SizeValueType
  GetNumberOfBoundaryEdges() const
  {
    return m_Facts.boundaryEdges;
  }

  /** Triangles that went round otherwise than their neighbours, and were turned. */
  SizeValueType
  GetNumberOfTurnedTriangles() const
  {
    return m_Facts.turnedTriangles;
  }

  /** Whether parts of the surface enclose the same place, or are turned inside out. */
  bool
  GetHasOverlaps() const
  {
    return m_Facts.hasOverlaps;
  }

  /** How far the surface goes beyond the faces of the grid's box, in mm; 0 if it does not. */
  double
  GetOvershoot() const
  {
    return m_Facts.overshoot;
  }

  /** Voxels whose centres are inside. */
  SizeValueType
  GetNumberOfVoxelsInside() const
  {
    return m_Facts.voxelsInside;
  }

protected:
  TriangleSurfaceToDistanceImageFilter();
  ~TriangleSurfaceToDistanceImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  GenerateOutputInformation() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

private:
  /** Throws where a cell is no triangle. */
  mmm::SurfaceTriangles
  GetTriangles() const;

  typename ReferenceImageType::ConstPointer m_ReferenceImage;
  double                                    m_BandWidth{ Automatic };
  mmm::SurfaceFacts                         m_Facts;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkTriangleSurfaceToDistanceImageFilter.hxx"
#endif

#endif
