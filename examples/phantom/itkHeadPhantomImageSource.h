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
#ifndef itkHeadPhantomImageSource_h
#define itkHeadPhantomImageSource_h

#include "itkMultiMaterialMeshCompatibility.h"

#include "itkImageSource.h"

namespace itk
{
/** \class HeadPhantomImageSource
 * \brief Makes a label image of a synthetic human head, for tests and benchmarks that need a head of any resolution.
 *
 * Labels: 0 outside, 1 scalp (all soft tissue, with nose, ears and neck), 2 skull (with jaw and spine), 3 cerebrospinal
 * fluid, 4 gray matter, 5 white matter, 6 air cavities that do not open to the outside. The layers nest: scalp, skull,
 * fluid, gray matter and white matter touch only their neighbours in this order, but for the ventricles, whose fluid
 * also touches white matter and the nuclei within it, and for the air, which lies within scalp and skull. Skull and
 * fluid are down to 2 mm and 1.7 mm thick, so this holds up to a spacing of 1.5 mm; coarser images undersample.
 *
 * The head is a closed-form function of the physical point, in mm and LPS, so neither spacing nor direction change it,
 * only what of it the image shows: the brain surrounds the origin, the vertex is at z = 87, the nose tip at y = -112,
 * the back of the head at y = 102, the ears at x = +/-85, the chin at z = -135 and the neck goes on below. The default
 * image of 181 x 217 x 181 voxels of 1 mm holds the head down to the upper jaw, like common templates.
 *
 * The result does not depend on the number of threads.
 *
 * \ingroup DataSources
 * \ingroup MultiMaterialMeshing
 */
template <typename TOutputImage>
class ITK_TEMPLATE_EXPORT HeadPhantomImageSource : public ImageSource<TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(HeadPhantomImageSource);

  using Self = HeadPhantomImageSource;
  using Superclass = ImageSource<TOutputImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using OutputImageType = TOutputImage;
  using OutputImageRegionType = typename Superclass::OutputImageRegionType;
  using PixelType = typename TOutputImage::PixelType;
  using SizeType = typename TOutputImage::SizeType;
  using SpacingType = typename TOutputImage::SpacingType;
  using PointType = typename TOutputImage::PointType;
  using DirectionType = typename TOutputImage::DirectionType;

  static constexpr unsigned int ImageDimension = TOutputImage::ImageDimension;
  static_assert(ImageDimension == 3, "A head has three dimensions.");

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(HeadPhantomImageSource);

  /** Voxels per axis; default = 181, 217, 181. */
  itkSetMacro(Size, SizeType);
  itkGetConstReferenceMacro(Size, SizeType);

  /** In mm; default = 1. */
  itkSetMacro(Spacing, SpacingType);
  itkGetConstReferenceMacro(Spacing, SpacingType);

  /** Where the centre of the first voxel is, in mm; default = (-90, -114, -92). */
  itkSetMacro(Origin, PointType);
  itkGetConstReferenceMacro(Origin, PointType);

  /** Default = identity. */
  itkSetMacro(Direction, DirectionType);
  itkGetConstReferenceMacro(Direction, DirectionType);

protected:
  HeadPhantomImageSource();
  ~HeadPhantomImageSource() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  GenerateOutputInformation() override;

  void
  DynamicThreadedGenerateData(const OutputImageRegionType & region) override;

private:
  SizeType      m_Size{ { 181, 217, 181 } };
  SpacingType   m_Spacing{ 1.0 };
  PointType     m_Origin;
  DirectionType m_Direction;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkHeadPhantomImageSource.hxx"
#endif

#endif
