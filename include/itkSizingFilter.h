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
#ifndef itkSizingFilter_h
#define itkSizingFilter_h

#include "itkImageConversion.h"
#include "itkIndicatorImageStages.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include <limits>
#include <string>

namespace itk
{
/** \class SizingFilter
 * \brief What filters have in common that ask for the edge lengths of a mesh: their settings, and two optional inputs.
 *
 * \tparam TSuperclass a filter of images
 * \tparam TSizingImage a three-dimensional image of real numbers, which are computed as `float`
 *
 * \sa LabelImageToTetrahedralMeshFilter, IndicatorImagesToSizingImageFilter
 * \ingroup MultiMaterialMeshing
 */
template <typename TSuperclass, typename TSizingImage = Image<float, 3>>
class ITK_TEMPLATE_EXPORT SizingFilter : public TSuperclass
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SizingFilter);

  using Self = SizingFilter;
  using Superclass = TSuperclass;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using SizingImageType = TSizingImage;
  using MaskImageType = Image<unsigned char, 3>;
  using LabelSizesType = mmm::LabelSizeRules;

  itkOverrideGetNameOfClassMacro(SizingFilter);

  /** The value of a length that is to follow the image's smallest voxel spacing. It is not a number: test with
   * std::isnan(). */
  static constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

  /** The edge length at the interfaces per local feature size, positive. Default: 2.5; 1.0 for a high resolution. */
  itkSetMacro(Epsilon, double);
  itkGetConstMacro(Epsilon, double);

  /** The largest distance of a curved interface to the edges that stand for it, in mm, positive. Default: Automatic,
   * 0.1 of the smallest voxel spacing. */
  itkSetMacro(ChordTolerance, double);
  itkGetConstMacro(ChordTolerance, double);

  /** How fast the edge length may grow with distance, without unit, positive. Default: 0.5. */
  itkSetMacro(GradientLimit, double);
  itkGetConstMacro(GradientLimit, double);

  /** The smallest edge length to ask for, in mm, positive. Default: Automatic, the smallest voxel spacing, or
   * MaximumSize where that is smaller. */
  itkSetMacro(MinimumSize, double);
  itkGetConstMacro(MinimumSize, double);

  /** The largest edge length to ask for, in mm, positive and not below MinimumSize; infinity is no limit. Default:
   * Automatic, a 25th part of the cube root of what is meshed, but at least MinimumSize and three times the smallest
   * voxel spacing; where a sizing image replaces sizes, no limit. */
  itkSetMacro(MaximumSize, double);
  itkGetConstMacro(MaximumSize, double);

  /** The volume that no tetrahedron is to exceed, in mm^3, positive. Edge lengths are kept so small that none does;
   * what other bounds say is no excuse. Default: infinity. */
  itkSetMacro(MaximumVolume, double);
  itkGetConstMacro(MaximumVolume, double);

  /** A factor on the edge length at the interfaces of a label, and bounds in it and at its interfaces, in mm, which
   * stand in place of MinimumSize and MaximumSize. Where two labels with sizes meet, the smaller result holds. Labels
   * must be among those of the input; of several exterior ones, that which stands for all. Also as a text, such as
   * "3:factor=0.5:max=2,7:min=1". Default: none. */
  virtual void
  SetLabelSizes(const LabelSizesType & sizes);
  void
  SetLabelSizes(const std::string & text);
  itkGetConstReferenceMacro(LabelSizes, LabelSizesType);

  /** Whether the sizing image stands in place of the computed edge lengths, within the bounds. Default: false, it is
   * their maximum. */
  itkSetMacro(SizingImageReplaces, bool);
  itkGetConstMacro(SizingImageReplaces, bool);
  itkBooleanMacro(SizingImageReplaces);

  /** The bounds in the region of interest, in mm, positive, which stand in place of all others there. One of them is
   * needed with the region, and neither is allowed without. Default: Automatic, which is the bound that holds
   * elsewhere. */
  itkSetMacro(RegionMinimumSize, double);
  itkGetConstMacro(RegionMinimumSize, double);
  itkSetMacro(RegionMaximumSize, double);
  itkGetConstMacro(RegionMaximumSize, double);

  /** The optional input "SizingImage": edge lengths in mm that the mesh is not to exceed, or that it is to have, see
   * SizingImageReplaces. It is on the grid of the image that is meshed. All values are positive; infinity and 1e30 say
   * nothing about a voxel. */
  void
  SetSizingImage(const TSizingImage * image);
  const TSizingImage *
  GetSizingImage() const;

  /** The optional input "RegionOfInterest", a mask on the same grid: bounds of its own hold where it is not 0, see
   * RegionMinimumSize. Some of it must be in what is meshed. From its rim edges grow by GradientLimit. */
  void
  SetRegionOfInterest(const MaskImageType * mask);
  const MaskImageType *
  GetRegionOfInterest() const;

protected:
  SizingFilter();
  ~SizingFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  mmm::SizingInputs
  GetSizingInputs() const;

private:
  double         m_Epsilon{ 2.5 };
  double         m_ChordTolerance{ Automatic };
  double         m_GradientLimit{ 0.5 };
  double         m_MinimumSize{ Automatic };
  double         m_MaximumSize{ Automatic };
  double         m_MaximumVolume{ std::numeric_limits<double>::infinity() };
  LabelSizesType m_LabelSizes;
  bool           m_SizingImageReplaces{ false };
  double         m_RegionMinimumSize{ Automatic };
  double         m_RegionMaximumSize{ Automatic };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkSizingFilter.hxx"
#endif

#endif
