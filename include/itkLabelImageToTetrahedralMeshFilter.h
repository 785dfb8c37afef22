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
#ifndef itkLabelImageToTetrahedralMeshFilter_h
#define itkLabelImageToTetrahedralMeshFilter_h

#include "itkLabelMeshing.h"
#include "itkMeshingFilter.h"
#include "itkSizingFilter.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToMeshFilter.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class LabelImageToTetrahedralMeshFilter
 * \brief Meshes a label image: labelled conforming tetrahedra and the surfaces between the labels.
 *
 * The whole pipeline in one filter: MergeLabelIslandsImageFilter, LabelImageToIndicatorImagesFilter,
 * IndicatorImagesToSizingImageFilter and IndicatorImagesToMeshFilter. Data that is not needed any more is released on
 * the way. The method is that of "Multimaterial Meshing of MRI Head Data for Bioelectric Field Simulations".
 *
 * Input: a three-dimensional image of an integer type with any origin, spacing and direction. Its labels are whole
 * numbers within the range of `int`, which need not be consecutive. Lengths are in mm, that is in the unit of the
 * image's spacing.
 *
 * Outputs, in ITK's physical space:
 * - GetOutput(): the tetrahedra; the cell data is the label of the image. Each has a positive volume.
 * - GetSurface(): the triangles between the labels; the cell data is the two labels, the lower one first. The outside
 * of what is meshed counts as a label, see GetOutsideLabel().
 * - GetParticles(): the points of the surface, with the labels that meet there.
 * - GetJunctions(): the curves and points of the surface where three and more labels meet, as lines and vertices, with
 * these labels; likewise the edges and corners of the image's box.
 * - GetMidNodes(): what makes the elements those of second order, see SetElementOrder().
 *
 * Where the image's border cuts a label the mesh ends at the face of the image's box, flat and with sharp edges.
 *
 * The same labels give the same mesh, transformed, whatever the image's origin, direction and unit of length:
 * everything is computed in units of the smallest voxel spacing, to which the other spacings and all lengths among the
 * parameters are related with a resolution of 1e-6. The mesh does not depend on the number of threads either, which
 * MultiThreaderBase::SetGlobalDefaultNumberOfThreads() sets.
 *
 * Update() throws an ExceptionObject if the image has one value only or nothing but exterior, if a parameter is out of
 * its range or contradicts another, if the sizing image is not positive or not on the grid of the label image, and with
 * TetGen's own words if TetGen fails; GetSurface() and GetParticles() then hold what was to be filled. It throws
 * ProcessAborted if the filter is told to abort.
 *
 * Observers of ProgressEvent may ask GetCurrentStage() and GetStageProgress(), besides GetProgress().
 *
 * \tparam TLabelImage a three-dimensional image of integers
 * \tparam TOutputMesh a mesh of three-dimensional points whose cell data is a number
 *
 * \ingroup MultiMaterialMeshing
 */
template <typename TLabelImage, typename TOutputMesh = LabelTetrahedralMesh>
class ITK_TEMPLATE_EXPORT LabelImageToTetrahedralMeshFilter
  : public SizingFilter<MeshingFilter<ImageToMeshFilter<TLabelImage, TOutputMesh>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelImageToTetrahedralMeshFilter);

  using Self = LabelImageToTetrahedralMeshFilter;
  using Superclass = SizingFilter<MeshingFilter<ImageToMeshFilter<TLabelImage, TOutputMesh>>>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using OutputMeshType = TOutputMesh;
  using IndicatorImageType = Image<float, 3>;
  using SurfaceDistanceImageType = Image<float, 3>;
  using typename Superclass::LabelType;
  using typename Superclass::LabelsType;
  using typename Superclass::SizingImageType;
  using RegionType = typename TLabelImage::RegionType;
  using VoxelCountsType = mmm::LabelCounts;
  using IslandRecordsType = std::map<LabelType, mmm::IslandRecord>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LabelImageToTetrahedralMeshFilter);

  itkConceptMacro(ThreeDimensionsCheck, (Concept::SameDimension<TLabelImage::ImageDimension, 3>));
  itkConceptMacro(PointDimensionCheck, (Concept::SameDimension<TOutputMesh::PointDimension, 3>));
  itkConceptMacro(IntegerPixelsCheck, (Concept::IsInteger<typename TLabelImage::PixelType>));
  itkConceptMacro(LabelConvertibleCheck, (Concept::Convertible<LabelType, typename TOutputMesh::CellPixelType>));

  /** Labels that are not meshed. They are one material, which takes the first of them that the image has. May be empty:
   * everything is meshed. Those that the image lacks are in GetAbsentExteriorLabels(). Default: {0}. */
  virtual void
  SetExteriorLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(ExteriorLabels, LabelsType);

  /** Mesh the exterior as well, as one label that keeps its value: air, up to the faces of the image's box or, with
   * AirMargin, of the box around what else is meshed. Pockets of exterior inside are air, too. Default: false. */
  itkSetMacro(FillExterior, bool);
  itkGetConstMacro(FillExterior, bool);
  itkBooleanMacro(FillExterior);

  /** How far that box is to go beyond what else is meshed, at least, in mm, not negative. The image is extended by
   * exterior (by the first of ExteriorLabels if it has none) or cut; where its border cuts a label, air follows. It
   * says that the exterior is filled, whatever FillExterior is. Default: Automatic, the box is the image's. */
  itkSetMacro(AirMargin, double);
  itkGetConstMacro(AirMargin, double);

  /** Whether an image that looks like one of intensities, of more than 32 values that change from voxel to voxel, is
   * meshed, each value as a label, rather than refused. Default: false. */
  itkSetMacro(AcceptIntensities, bool);
  itkGetConstMacro(AcceptIntensities, bool);
  itkBooleanMacro(AcceptIntensities);

  /** The optional input "SurfaceDistanceImage0" and so on: the signed distance of a closed surface on the grid of the
   * label image, in mm, positive inside and right within 3 times the smallest voxel spacing, as
   * TriangleSurfaceToDistanceImageFilter makes it. What is inside has the label of the same number in SurfaceLabels,
   * whatever the image says and earlier surfaces enclose. The interface is where the distance is 0, not smoothed; where
   * a surface crosses interfaces of the image, it is rounded over about a voxel. Radius is for the rest of the image. A
   * surface without a voxel gives an ExceptionObject. */
  void
  SetSurfaceDistanceImage(unsigned int number, const SurfaceDistanceImageType * image);
  const SurfaceDistanceImageType *
  GetSurfaceDistanceImage(unsigned int number) const;

  /** The label of each surface, by number, in order: a later one wins. It may be one that the image has as well, and
   * that of several surfaces, which are one material then; to take a label's shape from surfaces alone, give its voxels
   * another label first. Default: none. */
  virtual void
  SetSurfaceLabels(const LabelsType & labels);
  itkGetConstReferenceMacro(SurfaceLabels, LabelsType);

  /** Electrodes and implants on top of the image and the surfaces, by their shapes, see docs/electrodes.md: electrodes
   * stand on the skin, which stays as it is below them, and implants hide all that is there. The image is extended by
   * exterior where they go beyond it. What is wrong with one gives an ExceptionObject that begins with its source.
   * Default: none. */
  virtual void
  SetElectrodes(const mmm::Electrodes & electrodes)
  {
    m_Electrodes = electrodes;
    this->Modified();
  }
  /** Those of a JSON file, which is read at once. Throws an ExceptionObject with the place in the file that is wrong.
   */
  void
  SetElectrodes(const std::string & fileName)
  {
    this->SetElectrodes(mmm::ReadElectrodes(fileName));
  }
  const mmm::Electrodes &
  GetElectrodes() const
  {
    return m_Electrodes;
  }
  /** Components of a label (6-connected) with fewer voxels than this go to the neighbour that they touch most. A
   * label's largest component always stays. 0 and 1 keep all. Default: 8. */
  itkSetMacro(MinimumIslandSize, SizeValueType);
  itkGetConstMacro(MinimumIslandSize, SizeValueType);

  /** The radius of tightening, which rounds what is smaller, in mm, at least 0; 0 keeps the voxels' steps. Default:
   * Automatic, 0.5 of the smallest voxel spacing. */
  itkSetMacro(Radius, double);
  itkGetConstMacro(Radius, double);

  /** Which connections of the labels the mesh has: those that the edge lengths resolve, or those of the image, as far
   * as possible, see mmm::TopologyMode; also as a text: "auto", "any" or "keep". Default: Automatic, which keeps them
   * where Epsilon is at most 1. */
  itkSetEnumMacro(TopologyMode, mmm::TopologyMode);
  itkGetEnumMacro(TopologyMode, mmm::TopologyMode);
  void
  SetTopologyMode(const std::string & text)
  {
    this->SetTopologyMode(mmm::ParseTopologyMode(text));
  }

  /** Whether a label of more than 1,000 voxels may be missing in the mesh, see GetVanishedLabels(), as it is thinner
   * than the smoothing or the edge lengths resolve; otherwise the filter throws an ExceptionObject. Default: false. */
  itkSetMacro(AllowVanishedLabels, bool);
  itkGetConstMacro(AllowVanishedLabels, bool);
  itkBooleanMacro(AllowVanishedLabels);

  /** Whether slices that are at least four times as thick as voxels are wide stay as they are. Otherwise each is
   * divided into slices that are at most twice as thick (20 at most), with shapes that change evenly from slice to
   * slice, and images that are kept have these, while regions and numbers of voxels are in terms of the input. Not
   * where there are surfaces or functions. Default: false. */
  itkSetMacro(KeepSlices, bool);
  itkGetConstMacro(KeepSlices, bool);
  itkBooleanMacro(KeepSlices);

  /** Keep the indicator images and the sizing image, see GetIndicatorImage(). Default: false. */
  itkSetMacro(KeepIntermediates, bool);
  itkGetConstMacro(KeepIntermediates, bool);
  itkBooleanMacro(KeepIntermediates);

  /** What follows is known after Update(); after an exception, as far as the work had come. */

  /** The labels of the image that was meshed, sorted: exterior ones merged, the exterior one included. */
  const LabelsType &
  GetLabels() const
  {
    return m_Results.labels;
  }

  /** The voxels that were meshed: those of the image, or with AirMargin those of the box, which may begin before the
   * image and go beyond it. How much exterior that is not meshed is around the others changes neither mesh nor time. */
  const RegionType &
  GetMeshedRegion() const
  {
    return m_Results.meshedRegion;
  }

  /** The label of the outside in GetSurface() and GetParticles(): the exterior label; if the image has none, the first
   * of ExteriorLabels; if there is none, 0 or, if 0 is a label of the image, the smallest label minus 1. */
  LabelType
  GetOutsideLabel() const
  {
    return this->m_State.outsideLabel;
  }

  /** Listed exterior labels that the image lacks, in the order of the list. */
  const LabelsType &
  GetAbsentExteriorLabels() const
  {
    return m_Results.absentExteriorLabels;
  }

  /** What was merged, for every label of the image. */
  const IslandRecordsType &
  GetIslandRecords() const
  {
    return m_Results.islandRecords;
  }

  /** Labels that were to be meshed but have no tetrahedron (no triangle if SurfaceOnly), and their numbers of voxels.
   */
  const VoxelCountsType &
  GetVanishedLabels() const
  {
    return m_Results.vanishedLabels;
  }

  /** Where electrodes are, and their contact areas, in their order. */
  const std::vector<mmm::ElectrodeReport> &
  GetElectrodeReports() const
  {
    return m_Results.electrodes;
  }

  /** With KeepIntermediates: the signed distance of a label's smoothed boundary, in mm, positive inside, on the label's
   * bounding box and a band around it. Throws an ExceptionObject if there is none for the label. */
  const IndicatorImageType *
  GetIndicatorImage(LabelType label) const;

  /** With KeepIntermediates: the edge length that was asked for, in mm; else a null pointer. It covers
   * GetMeshedRegion(); further than 8 voxels from the box of what is meshed, the values at that distance are repeated.
   */
  const SizingImageType *
  GetComputedSizingImage() const
  {
    return m_Results.sizingImage;
  }

  /** Writes what was meshed, with which settings, and what came out: as a page to look at in a browser if the name ends
   * with .html, see MakeMeshPage(), else as JSON, see MakeMeshReport(). The outputs have to be the filter's still. The
   * topology is in it with CompareTopology. Throws an ExceptionObject before Update(), and if it cannot be written. */
  void
  WriteReport(const std::string & fileName);

protected:
  LabelImageToTetrahedralMeshFilter() = default;
  ~LabelImageToTetrahedralMeshFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  VerifyInputInformation() const override;

  void
  GenerateData() override;

  /** Functions of the materials that the indicators are to follow in place of the labels, none by default. */
  virtual mmm::IndicatorInputs
  GetFunctions() const
  {
    return {};
  }

private:
  /** What it works on, but for the labels and functions. */
  mmm::LabelMeshingInputs
  GetInputs() const;

  mmm::SurfaceInputs
  GetSurfaces() const;

  LabelsType        m_ExteriorLabels{ 0 };
  LabelsType        m_SurfaceLabels;
  mmm::Electrodes   m_Electrodes;
  bool              m_FillExterior{ false };
  double            m_AirMargin{ Superclass::Automatic };
  bool              m_AcceptIntensities{ false };
  SizeValueType     m_MinimumIslandSize{ 8 };
  double            m_Radius{ Superclass::Automatic };
  mmm::TopologyMode m_TopologyMode{ mmm::TopologyMode::Automatic };
  bool              m_AllowVanishedLabels{ false };
  bool              m_KeepSlices{ false };
  bool              m_KeepIntermediates{ false };

  mmm::LabelMeshingResults m_Results;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelImageToTetrahedralMeshFilter.hxx"
#endif

#endif
