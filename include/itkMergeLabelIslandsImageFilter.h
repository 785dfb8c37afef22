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
#ifndef itkMergeLabelIslandsImageFilter_h
#define itkMergeLabelIslandsImageFilter_h

#include "itkImageConversion.h"
#include "itkLabelImageStages.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkConceptChecking.h"
#include "itkImageToImageFilter.h"

#include <map>
#include <vector>

namespace itk
{
/** \class MergeLabelIslandsImageFilter
 * \brief Merges exterior labels into one, and small connected components into their neighbours.
 *
 * Segmentations are speckled: thousands of components of a voxel or two, which would cost a mesh elements and quality.
 *
 * First, the voxels of all ExteriorLabels get the first of these labels that the image has. Then the 6-connected
 * components of fewer than MinimumIslandSize voxels go to the label that most of their voxels' faces touch, the lowest
 * label if there are several. All are decided on the image as it was before, at once. A label's largest component
 * always stays, so that no label gets lost; of components of the same size it is the first in the order of the buffer.
 * So do threads: small components that touch in edges and corners, are MinimumIslandSize voxels long together, and have
 * at most two voxels for each of their length; and, of a label that would lose more than a twentieth of its voxels, all
 * that are so long or link larger parts. What was merged is in GetRecords().
 *
 * The labels are whole numbers in the range of `int`, else Update() throws an ExceptionObject. The whole image is
 * processed at once, on one thread.
 *
 * \tparam TLabelImage a three-dimensional image of integers
 *
 * \sa LabelImageToTetrahedralMeshFilter
 * \ingroup MultiMaterialMeshing
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT MergeLabelIslandsImageFilter : public ImageToImageFilter<TLabelImage, TLabelImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MergeLabelIslandsImageFilter);

  using Self = MergeLabelIslandsImageFilter;
  using Superclass = ImageToImageFilter<TLabelImage, TLabelImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using LabelType = int;
  using LabelsType = std::vector<LabelType>;
  using RecordsType = std::map<LabelType, mmm::IslandRecord>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(MergeLabelIslandsImageFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TLabelImage::ImageDimension, 3>));
  itkConceptMacro(IntegerPixelsCheck, (Concept::IsInteger<typename TLabelImage::PixelType>));

  /** Labels that become the first one of them that the image has. May be empty. Default: {0}. */
  virtual void
  SetExteriorLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(ExteriorLabels, LabelsType);

  /** Components of fewer voxels than this are merged into their neighbours; 0 and 1 keep all. Default: 8. */
  itkSetMacro(MinimumIslandSize, SizeValueType);
  itkGetConstMacro(MinimumIslandSize, SizeValueType);

  /** What happened to each label of the input, known after Update(). */
  itkGetConstReferenceMacro(Records, RecordsType);

  /** Labels of ExteriorLabels that the image lacks, in the order of that list, known after Update(). */
  itkGetConstReferenceMacro(AbsentExteriorLabels, LabelsType);

protected:
  MergeLabelIslandsImageFilter() = default;
  ~MergeLabelIslandsImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

private:
  LabelsType    m_ExteriorLabels{ 0 };
  SizeValueType m_MinimumIslandSize{ 8 };
  RecordsType   m_Records;
  LabelsType    m_AbsentExteriorLabels;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMergeLabelIslandsImageFilter.hxx"
#endif

#endif
