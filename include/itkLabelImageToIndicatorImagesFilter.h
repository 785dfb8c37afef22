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
#ifndef itkLabelImageToIndicatorImagesFilter_h
#define itkLabelImageToIndicatorImagesFilter_h

#include "itkImageConversion.h"
#include "itkLabelImageStages.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <limits>
#include <vector>

namespace itk
{
/** \class LabelImageToIndicatorImagesFilter
 * \brief Turns a label image into one smooth indicator image per label: the signed distance of its smoothed boundary.
 *
 * An indicator is in mm (the unit of the image's spacing), positive within the label, and known up to GetBandWidth()
 * from its zero level, beyond which it is cut off. The material at a point is the one whose indicator is the largest
 * there: between the labels a and b, the interface is where their indicators are equal.
 *
 * The boundary, first on the faces of the voxels, is anti-aliased (Whitaker 2000: mean curvature flow that leaves every
 * voxel centre on its side) and then tightened (Williams and Rossignac 2005: within what closing by a ball of Radius
 * adds and opening takes away, it moves by mean curvature to the shortest one). Then each connected part of a label
 * gets the volume of its voxels back, within half a percent, where smoothing changed it. What is left of passages that
 * are narrower than half a voxel becomes that wide, or is closed: where labels touch in edges or corners of voxels,
 * what is connected and what is not is no chance then. At the image's border labels are continued outwards. With a
 * Radius of 0 none of this is done.
 *
 * There are as many outputs as the image has labels, in the labels' order, all with the origin, spacing and direction
 * of the input. Output n, the indicator of GetLabels()[n], covers the label's bounding box and the band around it, so
 * its largest possible region need not start at index 0; beyond it the indicator is -GetBandWidth(). With CropToBand
 * off, all outputs cover the whole image.
 *
 * The number of outputs and their regions follow from the input's pixels, which are read by Update(): outputs beyond
 * the first exist after it only. What filters are connected to the outputs have to know their regions: update this
 * filter first, or switch CropToBand off. Before it has run, and when its input has changed since, the outputs are said
 * to cover the whole image.
 *
 * Labels are whole numbers in the range of `int`. An image that has only one, or more than 65,530, gives an
 * ExceptionObject. The result does not depend on the number of threads.
 *
 * \tparam TLabelImage a three-dimensional image of integers
 * \tparam TIndicatorImage a three-dimensional image of `float`
 *
 * \sa IndicatorImagesToSizingImageFilter, IndicatorImagesToMeshFilter
 * \ingroup MultiMaterialMeshing
 */
template <typename TLabelImage, typename TIndicatorImage = Image<float, 3>>
class ITK_TEMPLATE_EXPORT LabelImageToIndicatorImagesFilter : public ImageToImageFilter<TLabelImage, TIndicatorImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelImageToIndicatorImagesFilter);

  using Self = LabelImageToIndicatorImagesFilter;
  using Superclass = ImageToImageFilter<TLabelImage, TIndicatorImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using IndicatorImageType = TIndicatorImage;
  using RegionType = typename TIndicatorImage::RegionType;
  using LabelType = int;
  using LabelsType = std::vector<LabelType>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelImageToIndicatorImagesFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TLabelImage::ImageDimension, 3>));
  itkConceptMacro(SameDimensionCheck,
                  (Concept::SameDimension<TLabelImage::ImageDimension, TIndicatorImage::ImageDimension>));
  itkConceptMacro(IntegerPixelsCheck, (Concept::IsInteger<typename TLabelImage::PixelType>));
  itkConceptMacro(FloatImageCheck, (Concept::Convertible<TIndicatorImage *, Image<float, 3> *>));

  /** The value of a length that follows the image's smallest voxel spacing. It is not a number: test with std::isnan().
   */
  static constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

  /** The radius of tightening in mm, at least 0; 0 leaves the boundary on the faces of the voxels. Default: Automatic,
   * 0.5 of the smallest voxel spacing. */
  itkSetMacro(Radius, double);
  itkGetConstMacro(Radius, double);

  /** Widen the small places where two labels, voxels of which share a face there, touch through a thin sheet of a third
   * one, rather than close them, and look between samples for what else is narrow. They take small triangles.
   * Default: false. */
  itkSetMacro(KeepContacts, bool);
  itkGetConstMacro(KeepContacts, bool);
  itkBooleanMacro(KeepContacts);

  /** Whether each output covers only its label's bounding box and the band around it. Default: true. */
  itkSetMacro(CropToBand, bool);
  itkGetConstMacro(CropToBand, bool);
  itkBooleanMacro(CropToBand);

  /** The labels of the image, sorted; known after Update(). */
  itkGetConstReferenceMacro(Labels, LabelsType);

  /** The largest magnitude of the values, 3 times the smallest voxel spacing, in mm; known after
   * UpdateOutputInformation(). */
  itkGetConstMacro(BandWidth, double);

  /** The indicator of a label. Throws an ExceptionObject if the image does not have the label. */
  TIndicatorImage *
  GetOutputForLabel(LabelType label);

protected:
  LabelImageToIndicatorImagesFilter() = default;
  ~LabelImageToIndicatorImagesFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  GenerateOutputInformation() override;

  void
  GenerateOutputRequestedRegion(DataObject * output) override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateInputRequestedRegion() override;

  void
  GenerateData() override;

private:
  double     m_Radius{ Automatic };
  bool       m_KeepContacts{ false };
  bool       m_CropToBand{ true };
  LabelsType m_Labels;
  double     m_BandWidth{ 0.0 };

  /** Of the labels, where they are cropped, and when they were found. */
  std::vector<RegionType> m_Regions;
  TimeStamp               m_RegionsTime;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelImageToIndicatorImagesFilter.hxx"
#endif

#endif
