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
#ifndef itkVolumeFileReader_h
#define itkVolumeFileReader_h

#include "MultiMaterialMeshingExport.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkImage.h"
#include "itkObject.h"
#include "itkObjectFactory.h"
#include "itkSymmetricSecondRankTensor.h"

#include <string>

namespace itk
{
/** \class VolumeFileReader
 * \brief Reads a three-dimensional image of one number per voxel, and refuses what is damaged or has no place.
 *
 * NIfTI (1 and 2, with or without gzip, pairs of .hdr and .img) and FreeSurfer's .mgh and .mgz are read here, other
 * formats by ITK's ImageIO. Labels may be stored as numbers of any type: what is off a whole number by rounding is
 * rounded, all else, and labels beyond the range of int, are refused. A fourth dimension of size 1 is left out.
 *
 * The place is in mm and LPS. Of a NIfTI file, it is that of the sform if its code is above 0, else that of the qform,
 * else that of the spacing alone; its unit is taken into account. The axes need not be at right angles: the direction
 * of the image is as the file says, with columns of length 1. A file whose header gives no place (a spacing of 0 or
 * NaN, axes in a plane) is refused. What a user should know of a doubtful header is a warning.
 *
 * All failures are ExceptionObjects whose description is the file's name, what is wrong with it, and what to do.
 *
 * \ingroup IOFilters
 * \ingroup MultiMaterialMeshing
 */
class MultiMaterialMeshing_EXPORT VolumeFileReader : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeFileReader);

  using Self = VolumeFileReader;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using LabelImageType = Image<int, 3>;
  using ScalarImageType = Image<float, 3>;
  using TensorImageType = Image<SymmetricSecondRankTensor<float, 3>, 3>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(VolumeFileReader);

  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  LabelImageType::Pointer
  ReadLabels();

  ScalarImageType::Pointer
  ReadScalars();

  /** Whether a voxel of the file is a symmetric tensor of six components: NIfTI with the intent of symmetric matrices
   * (1005), or NRRD, MetaImage and so on with six components. */
  bool
  HasTensors() const;

  /** Symmetric tensors, such as those of diffusion, turned to the axes of the physical space, LPS. NRRD says along
   * which axes it has them (its measurement frame; without one, its space). NIfTI does not: they are taken along right,
   * anterior and superior, and a warning says so. With TensorsInVoxelAxes, those of any file are taken along the axes
   * of voxels.
   */
  TensorImageType::Pointer
  ReadTensors();

  /** Default false. */
  itkSetMacro(TensorsInVoxelAxes, bool);
  itkGetConstMacro(TensorsInVoxelAxes, bool);
  itkBooleanMacro(TensorsInVoxelAxes);

protected:
  VolumeFileReader() = default;
  ~VolumeFileReader() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  Note(const std::string & text) const;

  /** Checks the place and gives the image spacing and direction. */
  void
  Place(ImageBase<3> & image) const;

  std::string m_FileName;
  bool        m_TensorsInVoxelAxes{ false };
};
} // end namespace itk

#endif
