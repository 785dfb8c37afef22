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
#ifndef itkTetrahedronImageSampler_h
#define itkTetrahedronImageSampler_h

#include "MultiMaterialMeshingExport.h"
#include "itkMultiMaterialMeshCompatibility.h"
#include "itkMultiMaterialMeshTypes.h"

#include "itkImage.h"
#include "itkObject.h"
#include "itkObjectFactory.h"
#include "itkSymmetricSecondRankTensor.h"

#include <string>
#include <vector>

namespace itk
{
/** \class TetrahedronImageSampler
 * \brief What an image is in each of a mesh's tetrahedra: CT numbers, a map of lesions, any image of scalars.
 *
 * The image may have any grid; points of the mesh are in its physical space. Between the centers of voxels it is
 * interpolated linearly, and at the border, up to half a voxel beyond the last centers, it stays as it is there.
 *
 * Modes, of which "mean" is the default:
 * - "mean": the integral of the image over the tetrahedron by its volume. The tetrahedron is cut into smaller ones, as
 *   many along an edge as the longest one has thirds of a voxel, 64 at most, whose centers are sampled.
 * - "linear": the image at the center of the tetrahedron.
 * - "nearest": the voxel in which the center is; for labels and the like.
 *
 * A tetrahedron that has no such point in the image gets NaN; if it has some, the mean is that over these.
 *
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT TetrahedronImageSampler : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TetrahedronImageSampler);

  using Self = TetrahedronImageSampler;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using ImageType = Image<float, 3>;
  using TensorImageType = Image<SymmetricSecondRankTensor<float, 3>, 3>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(TetrahedronImageSampler);

  /** All its cells have to be tetrahedra. */
  itkSetConstObjectMacro(Mesh, LabelTetrahedralMesh);
  itkGetConstObjectMacro(Mesh, LabelTetrahedralMesh);

  /** One of GetModes(). */
  itkSetStringMacro(Mode);
  itkGetStringMacro(Mode);

  /** "mean", "nearest", "linear". */
  static const std::vector<std::string> &
  GetModes();

  /** A number for each tetrahedron. Throws an ExceptionObject if there is no mesh, no image or no such mode. */
  std::vector<double>
  Sample(const ImageType * image);

  /** Nine numbers for each tetrahedron, a matrix row by row: each component is sampled on its own. Tensors keep their
   * axes, which should be those of the physical space, as VolumeFileReader::ReadTensors() has them. */
  std::vector<double>
  SampleTensors(const TensorImageType * image);

  /** Of the last Sample(): tetrahedra that got NaN, and those of which a part is outside of the image. */
  itkGetConstMacro(NumberOutside, SizeValueType);
  itkGetConstMacro(NumberPartlyOutside, SizeValueType);

protected:
  TetrahedronImageSampler() = default;
  ~TetrahedronImageSampler() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  LabelTetrahedralMesh::ConstPointer m_Mesh;
  std::string                        m_Mode{ "mean" };
  SizeValueType                      m_NumberOutside{ 0 };
  SizeValueType                      m_NumberPartlyOutside{ 0 };
};
} // end namespace itk

#endif
