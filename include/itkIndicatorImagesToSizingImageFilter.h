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

#include "itkMultiMaterialMeshCompatibility.h"
#include "itk/SizingOptions.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <limits>
#include <string>
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
class ITK_TEMPLATE_EXPORT IndicatorImagesToSizingImageFilter : public ImageToImageFilter<TIndicatorImage, TSizingImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IndicatorImagesToSizingImageFilter);

  using Self = IndicatorImagesToSizingImageFilter;
  using Superclass = ImageToImageFilter<TIndicatorImage, TSizingImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using IndicatorImageType = TIndicatorImage;
  using SizingImageType = TSizingImage;
  using MaskImageType = Image<unsigned char, 3>;

  using LabelType = int;
  using LabelsType = std::vector<LabelType>;
  using LabelSizesType = mmm::LabelSizeRules;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(IndicatorImagesToSizingImageFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TIndicatorImage::ImageDimension, 3>));
  itkConceptMacro(SameDimensionCheck,
                  (Concept::SameDimension<TIndicatorImage::ImageDimension, TSizingImage::ImageDimension>));
  itkConceptMacro(FloatPixelsCheck, (Concept::SameType<typename TIndicatorImage::PixelType, float>));
  itkConceptMacro(RealSizesCheck, (Concept::IsFloatingPoint<typename TSizingImage::PixelType>));

  /** The value of a length that follows the image's smallest voxel spacing. It is not a number: test with std::isnan().
   */
  static constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

  /** Edge length per local feature size, positive. Default: 2.5; 1.0 for a high resolution. */
  itkSetMacro(Epsilon, double);
  itkGetConstMacro(Epsilon, double);

  /** The largest distance of a curved interface to the edges that stand for it, in mm, positive. Default: Automatic,
   * 0.1 of the smallest voxel spacing. */
  itkSetMacro(ChordTolerance, double);
  itkGetConstMacro(ChordTolerance, double);

  /** The largest gradient of the edge length, without unit, positive. Default: 0.5. */
  itkSetMacro(GradientLimit, double);
  itkGetConstMacro(GradientLimit, double);

  /** The smallest edge length, in mm, positive. Default: Automatic, the smallest voxel spacing, or MaximumSize where
   * that is smaller. */
  itkSetMacro(MinimumSize, double);
  itkGetConstMacro(MinimumSize, double);

  /** The largest edge length, in mm, positive and not below MinimumSize. Default: infinity. */
  itkSetMacro(MaximumSize, double);
  itkGetConstMacro(MaximumSize, double);

  /** The volume that no tetrahedron is to exceed, in mm^3, positive. Edge lengths are kept so small that none does;
   * what other bounds say is no excuse. Default: infinity. */
  itkSetMacro(MaximumVolume, double);
  itkGetConstMacro(MaximumVolume, double);

  /** The label of each input, by number; LabelSizes are by label. Default: none, the number of an input is its label.
   */
  virtual void
  SetLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(Labels, LabelsType);

  /** A factor on the edge length at the interfaces of a label, and bounds in it and at its interfaces, in mm. Where two
   * labels with sizes meet, the smaller result holds. Also as a text, such as "3:factor=0.5:max=2,7:min=1". Default:
   * none. */
  virtual void
  SetLabelSizes(const LabelSizesType & sizes);
  void
  SetLabelSizes(const std::string & text);
  itkGetConstReferenceMacro(LabelSizes, LabelSizesType);

  /** Whether the sizing image stands in place of the computed edge lengths. Default: false, it is their maximum. */
  itkSetMacro(SizingImageReplaces, bool);
  itkGetConstMacro(SizingImageReplaces, bool);
  itkBooleanMacro(SizingImageReplaces);

  /** The bounds in the region of interest, in mm, positive. One of them is needed with the input, and neither is
   * allowed without. Default: Automatic, which is the bound that holds elsewhere. */
  itkSetMacro(RegionMinimumSize, double);
  itkGetConstMacro(RegionMinimumSize, double);
  itkSetMacro(RegionMaximumSize, double);
  itkGetConstMacro(RegionMaximumSize, double);

  /** The number of the input that is not meshed, or -1 if there is none. Default: -1. */
  itkSetMacro(ExteriorIndex, int);
  itkGetConstMacro(ExteriorIndex, int);

  /** The input "SizingImage". */
  void
  SetSizingImage(const TSizingImage * image);
  const TSizingImage *
  GetSizingImage() const;

  /** The input "RegionOfInterest". Some of it must be in what is meshed. */
  void
  SetRegionOfInterest(const MaskImageType * mask);
  const MaskImageType *
  GetRegionOfInterest() const;

protected:
  IndicatorImagesToSizingImageFilter();
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
  mmm::SizingOptions
  GetOptions() const;

  std::vector<const TIndicatorImage *>
  GetIndicatorImages() const;

  /** The labels of the inputs, by number. */
  LabelsType
  GetInputLabels() const;

  mmm::SizingControl
  MakeControl(const mmm::GridGeometry & geometry, const mmm::IndicatorSet & indicators) const;

  double         m_Epsilon{ 2.5 };
  double         m_ChordTolerance{ Automatic };
  double         m_GradientLimit{ 0.5 };
  double         m_MinimumSize{ Automatic };
  double         m_MaximumSize{ std::numeric_limits<double>::infinity() };
  double         m_MaximumVolume{ std::numeric_limits<double>::infinity() };
  LabelsType     m_Labels;
  LabelSizesType m_LabelSizes;
  bool           m_SizingImageReplaces{ false };
  double         m_RegionMinimumSize{ Automatic };
  double         m_RegionMaximumSize{ Automatic };
  int            m_ExteriorIndex{ -1 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkIndicatorImagesToSizingImageFilter.hxx"
#endif

#endif
