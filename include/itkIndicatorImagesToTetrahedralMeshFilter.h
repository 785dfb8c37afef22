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
#ifndef itkIndicatorImagesToTetrahedralMeshFilter_h
#define itkIndicatorImagesToTetrahedralMeshFilter_h

#include "itkIndicatorImagesToLabelImageFilter.h"
#include "itkLabelImageToTetrahedralMeshFilter.h"

namespace itk
{
/** \class IndicatorImagesToTetrahedralMeshFilter
 * \brief Meshes the materials that indicator images, for instance tissue probability maps, tell apart.
 *
 * Inputs, by number: one image per material, as IndicatorImagesToLabelImageFilter takes them; that filter makes the
 * label image. Interfaces are where the images of two materials have the same value, between the voxels' centres, and
 * not, as for a label image, where smoothing puts them: Radius has no effect, and noise of the images is noise of the
 * interfaces. Everything else is as in LabelImageToTetrahedralMeshFilter, which documents the other settings, the
 * outputs and the exceptions.
 *
 * Indicators in mm that were made for this purpose, as LabelImageToIndicatorImagesFilter makes them, are meshed as they
 * are by IndicatorImagesToMeshFilter.
 *
 * \tparam TIndicatorImage a three-dimensional image of `float`
 * \tparam TOutputMesh a mesh of three-dimensional points whose cell data is a number
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TIndicatorImage, typename TOutputMesh = LabelTetrahedralMesh>
class ITK_TEMPLATE_EXPORT IndicatorImagesToTetrahedralMeshFilter
  : public LabelImageToTetrahedralMeshFilter<Image<int, 3>, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IndicatorImagesToTetrahedralMeshFilter);

  using Self = IndicatorImagesToTetrahedralMeshFilter;
  using LabelImageType = Image<int, 3>;
  using Superclass = LabelImageToTetrahedralMeshFilter<LabelImageType, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using InputIndicatorImageType = TIndicatorImage;
  using typename Superclass::LabelType;
  using typename Superclass::LabelsType;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(IndicatorImagesToTetrahedralMeshFilter);

  /** The image of a material, by number from 0 on. */
  using Superclass::SetInput;
  virtual void
  SetInput(unsigned int number, const TIndicatorImage * image);
  virtual void
  SetInput(const TIndicatorImage * image)
  {
    this->SetInput(0, image);
  }

  /** The label of each image, by number, distinct. Default: none, which stands for 1, 2, 3 and so on. */
  virtual void
  SetIndicatorLabels(const LabelsType & labels);
  const LabelsType &
  GetIndicatorLabels() const
  {
    return m_LabelFilter->GetIndicatorLabels();
  }

  /** Labels that are not meshed. If no image has one of them, the exterior is what the images leave, and takes the
   * first. May be empty: everything is meshed. Default: {0}. */
  void
  SetExteriorLabels(const LabelsType & labels) override;

protected:
  /** The maps cannot be extended: an air margin is refused. So are surfaces, which are for label images. */
  void
  VerifyPreconditions() const override;
  IndicatorImagesToTetrahedralMeshFilter();
  ~IndicatorImagesToTetrahedralMeshFilter() override = default;

  mmm::IndicatorInputs
  GetFunctions() const override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using LabelFilterType = IndicatorImagesToLabelImageFilter<TIndicatorImage, LabelImageType>;

  typename LabelFilterType::Pointer m_LabelFilter;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkIndicatorImagesToTetrahedralMeshFilter.hxx"
#endif

#endif
