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
#ifndef itkIndicatorImagesToLabelImageFilter_h
#define itkIndicatorImagesToLabelImageFilter_h

#include "itkIndicatorImageStages.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <string>
#include <vector>

namespace itk
{
/** \class IndicatorImagesToLabelImageFilter
 * \brief Gives each voxel the label of the image with the largest value there.
 *
 * Inputs, by number: one image per material, of probabilities or of any other function that is the larger the further
 * inside, all in the same unit and on the same grid. Where values are equal, exterior comes first, then the image with
 * the lower number.
 *
 * If there are exterior labels, but none of the images has one, the exterior is what the images leave: its value is
 * 1 - sum where they are probabilities, and -max where they are positive inside and negative outside. Which of the two
 * they are, is told by their values: probabilities are from 0 to 1, and interpolated ones not further than 0.25 from
 * that.
 *
 * Output: the label image.
 *
 * Update() throws an ExceptionObject if the images are not on the same grid, if a value is not finite, if an image has
 * the same value everywhere, if labels are not distinct, or if there is nothing to tell apart. It calls images by their
 * object names, if they have one.
 *
 * \tparam TIndicatorImage a three-dimensional image of `float`
 * \tparam TLabelImage a three-dimensional image of integers
 *
 * \sa IndicatorImagesToTetrahedralMeshFilter
 * \ingroup MultiMaterialMeshing
 */
template <typename TIndicatorImage, typename TLabelImage = Image<int, 3>>
class ITK_TEMPLATE_EXPORT IndicatorImagesToLabelImageFilter : public ImageToImageFilter<TIndicatorImage, TLabelImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IndicatorImagesToLabelImageFilter);

  using Self = IndicatorImagesToLabelImageFilter;
  using Superclass = ImageToImageFilter<TIndicatorImage, TLabelImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using IndicatorImageType = TIndicatorImage;
  using LabelImageType = TLabelImage;
  using LabelType = int;
  using LabelsType = std::vector<LabelType>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(IndicatorImagesToLabelImageFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TIndicatorImage::ImageDimension, 3>));
  itkConceptMacro(FloatImageCheck, (Concept::Convertible<TIndicatorImage *, Image<float, 3> *>));
  itkConceptMacro(IntegerPixelsCheck, (Concept::IsInteger<typename TLabelImage::PixelType>));

  /** The label of each image, by number, distinct. Default: none, which stands for 1, 2, 3 and so on. */
  virtual void
  SetIndicatorLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(IndicatorLabels, LabelsType);

  /** Labels of the exterior. If no image has one of them, the exterior is what the images leave and has the first of
   * them. If there are none, every voxel gets an image's label. Default: {0}. */
  virtual void
  SetExteriorLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(ExteriorLabels, LabelsType);

  /** The labels of the images, also if they follow from the images' numbers. */
  LabelsType
  GetUsedLabels() const;

  /** Whether the exterior is what the images leave. */
  bool
  IsExteriorImplicit() const;

protected:
  IndicatorImagesToLabelImageFilter() = default;
  ~IndicatorImagesToLabelImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  VerifyInputInformation() const override;

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

private:
  /** The images and their labels. */
  mmm::IndicatorInputs
  GetFunctions() const;

  bool
  IsExterior(LabelType label) const;

  /** "Indicator image 2 (gm.nii)", counted from 1. */
  std::string
  NameOf(std::size_t number) const;

  LabelsType m_IndicatorLabels;
  LabelsType m_ExteriorLabels{ 0 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkIndicatorImagesToLabelImageFilter.hxx"
#endif

#endif
