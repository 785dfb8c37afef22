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
#ifndef itkIndicatorImagesToMeshFilter_h
#define itkIndicatorImagesToMeshFilter_h

#include "itkMeshingFilter.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToMeshFilter.h"

#include <vector>

namespace itk
{
/** \class IndicatorImagesToMeshFilter
 * \brief Makes conforming meshes of the materials that indicator images describe: tetrahedra and the surfaces between.
 *
 * The method is that of "Multimaterial Meshing of MRI Head Data for Bioelectric Field Simulations". The material at a
 * point is the one with the largest indicator. Particles on the interfaces (where two indicators are the largest), on
 * their junctions (three) and corners (four) move apart until their distance is what the sizing image asks for. A
 * Delaunay tetrahedralization of them, labelled by the indicators, gives the interfaces. Particles in the interior
 * follow, and TetGen tetrahedralizes all, with the interfaces as constraints.
 *
 * Inputs, by number: one indicator image per material, as LabelImageToIndicatorImagesFilter makes them, in mm, and the
 * input "SizingImage", which is required: edge lengths in mm, all positive, as IndicatorImagesToSizingImageFilter makes
 * it. All have the same origin, spacing and direction; the sizing image covers the largest possible regions of the
 * others, which may differ. Where an image ends its indicator is -3 times the smallest voxel spacing.
 *
 * Outputs, in ITK's physical space:
 * - 0, GetOutput(): tetrahedra of positive volume, the label as cell data; empty if SurfaceOnly.
 * - 1, GetSurface(): triangles between different labels, the two labels as cell data, the lower one first. The normal
 *   points from the first to the second.
 * - 2, GetParticles(): the points of the surface, with the dimension of the cell that each lies on and the labels that
 *   meet there as point data.
 * - 3, GetJunctions(): lines and vertices, the curves and points of the surface where three and more labels meet, with
 *   these labels as cell data. The faces of the image's box count as well, so that the edges and corners of cuts are
 *   among them; their label is that of the outside.
 * - 4, GetMidNodes(): what makes the elements those of second order, see SetElementOrder().
 *
 * Points of the surface are the first ones of the tetrahedra, in the same order. The image's box cuts the materials
 * flat, with sharp edges; what is beyond counts as outside, like the exterior material.
 *
 * Update() throws an ExceptionObject if an input is missing, does not fit the others or is not positive where it must
 * be, if labels are missing or not distinct, and with TetGen's own words if TetGen fails; then GetSurface() and
 * GetParticles() hold what was to be filled. It throws ProcessAborted if the filter is told to abort.
 *
 * The result depends neither on the number of threads nor on origin and direction of the images, to which the points
 * are transformed at the end.
 *
 * \tparam TIndicatorImage a three-dimensional image of `float`
 * \tparam TOutputMesh a mesh of three-dimensional points whose cell data is a number
 *
 * \sa LabelImageToTetrahedralMeshFilter
 * \ingroup MultiMaterialMeshing
 */
template <typename TIndicatorImage, typename TOutputMesh = LabelTetrahedralMesh>
class ITK_TEMPLATE_EXPORT IndicatorImagesToMeshFilter
  : public MeshingFilter<ImageToMeshFilter<TIndicatorImage, TOutputMesh>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(IndicatorImagesToMeshFilter);

  using Self = IndicatorImagesToMeshFilter;
  using Superclass = MeshingFilter<ImageToMeshFilter<TIndicatorImage, TOutputMesh>>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using IndicatorImageType = TIndicatorImage;
  using SizingImageType = Image<float, 3>;
  using ReferenceImageType = ImageBase<3>;
  using OutputMeshType = TOutputMesh;
  using typename Superclass::LabelType;
  using typename Superclass::LabelsType;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(IndicatorImagesToMeshFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TIndicatorImage::ImageDimension, 3>));
  itkConceptMacro(PointDimensionCheck, (Concept::SameDimension<TOutputMesh::PointDimension, 3>));
  itkConceptMacro(FloatImageCheck, (Concept::Convertible<TIndicatorImage *, Image<float, 3> *>));
  itkConceptMacro(LabelConvertibleCheck, (Concept::Convertible<LabelType, typename TOutputMesh::CellPixelType>));

  /** The label of each indicator image, by number. They must be distinct. No default. */
  virtual void
  SetLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(Labels, LabelsType);

  /** The number of the input that is not meshed, or -1 if there is none. Default: -1. */
  itkSetMacro(ExteriorIndex, int);
  itkGetConstMacro(ExteriorIndex, int);

  /** The label of the outside where no input is exterior. If it is the label of an input, 0 is taken instead and, if
   * that is one, too, the smallest label minus 1; see GetUsedOutsideLabel(). Default: 0. */
  itkSetMacro(OutsideLabel, LabelType);
  itkGetConstMacro(OutsideLabel, LabelType);

  /** Sample the interfaces more finely until each label is connected as its indicator says, as far as possible.
   * Otherwise that is done once only. Default: false. */
  itkSetMacro(KeepTopology, bool);
  itkGetConstMacro(KeepTopology, bool);
  itkBooleanMacro(KeepTopology);

  /** The input "SizingImage". */
  void
  SetSizingImage(const SizingImageType * image);
  const SizingImageType *
  GetSizingImage() const;

  /** An image of as many voxels as the sizing image whose origin, spacing, direction and index give the place of the
   * outputs, instead of those of the inputs. Default: none. */
  itkSetConstObjectMacro(ReferenceImage, ReferenceImageType);
  itkGetConstObjectMacro(ReferenceImage, ReferenceImageType);

  /** The label that the outside has in the outputs, known after Update(). */
  LabelType
  GetUsedOutsideLabel() const
  {
    return this->m_State.outsideLabel;
  }

protected:
  IndicatorImagesToMeshFilter();
  ~IndicatorImagesToMeshFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  VerifyInputInformation() const override;

  void
  GenerateData() override;

private:
  mmm::MeshingInputs
  GetInputs() const;

  LabelsType                                m_Labels;
  int                                       m_ExteriorIndex{ -1 };
  LabelType                                 m_OutsideLabel{ 0 };
  bool                                      m_KeepTopology{ false };
  typename ReferenceImageType::ConstPointer m_ReferenceImage;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkIndicatorImagesToMeshFilter.hxx"
#endif

#endif
