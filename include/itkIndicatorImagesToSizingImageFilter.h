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
#ifndef itkIndicatorImagesToSizingImageFilter_h
#define itkIndicatorImagesToSizingImageFilter_h

#include "itkSizingFilter.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <vector>

namespace itk
{
/** \class IndicatorImagesToSizingImageFilter
 * \brief Computes a sizing image from indicator images: the edge length in mm that a mesh is to have at each voxel.
 *
 * At the interfaces the edge length is Epsilon times the local feature size (the distance to the nearest medial axis of
 * a label) or sqrt(8 ChordTolerance / k), where k is the largest curvature, whichever is smaller, within [MinimumSize,
 * MaximumSize]. From there it grows with distance by GradientLimit: the largest function below those values whose
 * gradient is limited (Persson 2006). Faces of the image's box count as interfaces where they cut a label that is not
 * exterior.
 *
 * Inputs, by number: one indicator image per label, as LabelImageToIndicatorImagesFilter makes them, in mm, with the
 * same origin, spacing and direction, else Update() throws an ExceptionObject. Their regions may differ: where an image
 * ends its indicator is -3 times the smallest voxel spacing. The output covers all of them.
 *
 * Two more inputs are optional; they are on the grid of the output. Neither makes sizes jump: the gradient stays
 * limited.
 * - "SizingImage": edge lengths in mm, all positive, which the output does not exceed, be they below MinimumSize. With
 * SizingImageReplaces they stand in place of the computed ones, within the bounds. Infinity and 1e30 say nothing about
 * a voxel.
 * - "RegionOfInterest": a mask with bounds of its own where it is not 0.
 *
 * Bounds of the region of interest stand in place of those of a label, and these in place of MinimumSize and
 * MaximumSize. A bound that is not given is the one of the next in this order, moved if it contradicts the other bound.
 *
 * The result does not depend on the number of threads.
 *
 * \tparam TIndicatorImage a three-dimensional image of `float`
 * \tparam TSizingImage a three-dimensional image of real numbers
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TIndicatorImage, typename TSizingImage = Image<float, 3>>
class ITK_TEMPLATE_EXPORT IndicatorImagesToSizingImageFilter
  : public SizingFilter<ImageToImageFilter<TIndicatorImage, TSizingImage>, TSizingImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IndicatorImagesToSizingImageFilter);

  using Self = IndicatorImagesToSizingImageFilter;
  using Superclass = SizingFilter<ImageToImageFilter<TIndicatorImage, TSizingImage>, TSizingImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using IndicatorImageType = TIndicatorImage;
  using LabelType = int;
  using LabelsType = std::vector<LabelType>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(IndicatorImagesToSizingImageFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TIndicatorImage::ImageDimension, 3>));
  itkConceptMacro(SameDimensionCheck,
                  (Concept::SameDimension<TIndicatorImage::ImageDimension, TSizingImage::ImageDimension>));
  itkConceptMacro(FloatImageCheck, (Concept::Convertible<TIndicatorImage *, Image<float, 3> *>));
  itkConceptMacro(RealSizesCheck, (Concept::IsFloatingPoint<typename TSizingImage::PixelType>));

  /** The label of each input, by number; LabelSizes are by label. Default: none, the number of an input is its label.
   */
  virtual void
  SetLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(Labels, LabelsType);

  /** The number of the input that is not meshed, or -1 if there is none. Default: -1. */
  itkSetMacro(ExteriorIndex, int);
  itkGetConstMacro(ExteriorIndex, int);

protected:
  IndicatorImagesToSizingImageFilter() = default;
  ~IndicatorImagesToSizingImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  VerifyInputInformation() const override;

  void
  GenerateOutputInformation() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateInputRequestedRegion() override;

  void
  GenerateData() override;

private:
  mmm::IndicatorInputs
  GetIndicatorInputs() const;

  LabelsType m_Labels;
  int        m_ExteriorIndex{ -1 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkIndicatorImagesToSizingImageFilter.hxx"
#endif

#endif
