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

#include "itkIndicatorImagesToMeshFilter.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itk/FilterMonitor.h"
#include "MultiMaterialMeshingReports.h"
#include "itkMultiMaterialMeshCompatibility.h"
#include "itk/Labels.h"
#include "pipeline/Mesher.h"
#include "itk/SizingOptions.h"

#include "itkConceptChecking.h"
#include "itkImage.h"
#include "itkImageToMeshFilter.h"

#include <cstdint>
#include <limits>
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
class ITK_TEMPLATE_EXPORT LabelImageToTetrahedralMeshFilter : public ImageToMeshFilter<TLabelImage, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelImageToTetrahedralMeshFilter);

  using Self = LabelImageToTetrahedralMeshFilter;
  using Superclass = ImageToMeshFilter<TLabelImage, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using OutputMeshType = TOutputMesh;
  using SurfaceMeshType = LabelInterfaceMesh;
  using ParticleMeshType = LabelParticleMesh;
  using JunctionMeshType = LabelJunctionMesh;
  using IndicatorImageType = Image<float, 3>;
  using SizingImageType = Image<float, 3>;
  using MaskImageType = Image<unsigned char, 3>;

  using LabelType = int;
  using LabelsType = std::vector<LabelType>;
  using RegionType = typename TLabelImage::RegionType;
  using LabelSizesType = mmm::LabelSizeRules;
  using VoxelCountsType = mmm::LabelCounts;
  using IslandRecordsType = std::map<LabelType, mmm::IslandRecord>;
  using StageRecordsType = std::vector<mmm::StageRecord>;

  /** The value of a length that is to follow the image's smallest voxel spacing. It is not a number: test with
   * std::isnan(). */
  static constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();

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

  /** Components of a label (6-connected) with fewer voxels than this go to the neighbour that they touch most. A
   * label's largest component always stays. 0 and 1 keep all. Default: 8. */
  itkSetMacro(MinimumIslandSize, SizeValueType);
  itkGetConstMacro(MinimumIslandSize, SizeValueType);

  /** The radius of tightening, which rounds what is smaller, in mm, at least 0; 0 keeps the voxels' steps. Default:
   * Automatic, 0.5 of the smallest voxel spacing. */
  itkSetMacro(Radius, double);
  itkGetConstMacro(Radius, double);

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

  /** The largest edge length to ask for, in mm, positive and not below MinimumSize. Default: infinity. */
  itkSetMacro(MaximumSize, double);
  itkGetConstMacro(MaximumSize, double);

  /** The volume that no tetrahedron is to exceed, in mm^3, positive. Edge lengths are kept so small that none does;
   * what other bounds say is no excuse. Default: infinity. */
  itkSetMacro(MaximumVolume, double);
  itkGetConstMacro(MaximumVolume, double);

  /** A factor on the edge length at the interfaces of a label, and bounds in it and at its interfaces, in mm, which
   * stand in place of MinimumSize and MaximumSize. Where two labels with sizes meet, the smaller result holds. Labels
   * must be in the image; of several exterior ones, that which stands for all. Also as a text, such as
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
   * elsewhere.
   */
  itkSetMacro(RegionMinimumSize, double);
  itkGetConstMacro(RegionMinimumSize, double);
  itkSetMacro(RegionMaximumSize, double);
  itkGetConstMacro(RegionMaximumSize, double);

  /** The particles' order of insertion. Another seed gives another mesh of the same kind. Default: 1. */
  itkSetMacro(Seed, std::uint64_t);
  itkGetConstMacro(Seed, std::uint64_t);

  /** Leave out the interior: GetOutput() remains empty, and the surface, whose triangles are a little poorer, takes
   * about half the time. Default: false. */
  itkSetMacro(SurfaceOnly, bool);
  itkGetConstMacro(SurfaceOnly, bool);
  itkBooleanMacro(SurfaceOnly);

  /** Compare the components, tunnels and cavities of each label in the mesh with those of the largest indicator's
   * region, see MeshingReport::topology. Default: false. */
  itkSetMacro(CompareTopology, bool);
  itkGetConstMacro(CompareTopology, bool);
  itkBooleanMacro(CompareTopology);

  /** Refuse meshes that are expected to have more tetrahedra, or to need more memory, in GB (2^30 bytes), positive,
   * before the long stages begin: Update() throws an ExceptionObject that says which smallest size would do. See
   * MeshingReport::estimate. Defaults: no limit. */
  itkSetMacro(MaximumNumberOfTetrahedra, SizeValueType);
  itkGetConstMacro(MaximumNumberOfTetrahedra, SizeValueType);
  itkSetMacro(MaximumMemory, double);
  itkGetConstMacro(MaximumMemory, double);

  /** Keep the indicator images and the sizing image, see GetIndicatorImage(). Default: false. */
  itkSetMacro(KeepIntermediates, bool);
  itkGetConstMacro(KeepIntermediates, bool);
  itkBooleanMacro(KeepIntermediates);

  /** An optional image of edge lengths in mm that the mesh is not to exceed, or that it is to have, see
   * SizingImageReplaces. It is on the grid of the label image. All values are positive; infinity and 1e30 say nothing
   * about a voxel. */
  void
  SetSizingImage(const SizingImageType * image);
  const SizingImageType *
  GetSizingImage() const;

  /** An optional mask on the grid of the label image: bounds of its own hold where it is not 0, see RegionMinimumSize.
   * Some of it must be in what is meshed. From its rim edges grow by GradientLimit. */
  void
  SetRegionOfInterest(const MaskImageType * mask);
  const MaskImageType *
  GetRegionOfInterest() const;

  SurfaceMeshType *
  GetSurface();
  ParticleMeshType *
  GetParticles();
  JunctionMeshType *
  GetJunctions();

  /** What follows is known after Update(); after an exception, as far as the work had come. */

  /** The labels of the image that was meshed, sorted: exterior ones merged, the exterior one included. */
  itkGetConstReferenceMacro(Labels, LabelsType);

  /** The voxels that were meshed: those of the image, or with AirMargin those of the box, which may begin before the
   * image and go beyond it. */
  itkGetConstReferenceMacro(MeshedRegion, RegionType);

  /** The label of the outside in GetSurface() and GetParticles(): the exterior label; if the image has none, the first
   * of ExteriorLabels; if there is none, 0 or, if 0 is a label of the image, the smallest label minus 1. */
  itkGetConstMacro(OutsideLabel, LabelType);

  /** Listed exterior labels that the image lacks, in the order of the list. */
  itkGetConstReferenceMacro(AbsentExteriorLabels, LabelsType);

  /** What was merged, for every label of the image. */
  itkGetConstReferenceMacro(IslandRecords, IslandRecordsType);

  /** Labels that were to be meshed but have no tetrahedron (no triangle if SurfaceOnly), and their numbers of voxels.
   */
  itkGetConstReferenceMacro(VanishedLabels, VoxelCountsType);

  /** What was expected, counts of the particles and how their relaxation went. The estimate is there for observers of
   * ProgressEvent as soon as the stage "preparation" has ended. */
  itkGetConstReferenceMacro(Report, mmm::MeshingReport);

  /** The stages that ended, in their order. */
  const StageRecordsType &
  GetStageRecords() const
  {
    return m_StageLog.records;
  }

  /** The stage that is running or ran last, for instance "sizing", and how much of it is done, in [0, 1]. */
  const std::string &
  GetCurrentStage() const
  {
    return m_StageLog.current;
  }
  float
  GetStageProgress() const
  {
    return m_StageLog.progress;
  }

  /** With KeepIntermediates: the signed distance of a label's smoothed boundary, in mm, positive inside, on the label's
   * bounding box and a band around it. Throws an ExceptionObject if there is none for the label. */
  const IndicatorImageType *
  GetIndicatorImage(LabelType label) const;

  /** With KeepIntermediates: the edge length that was asked for, in mm; else a null pointer. */
  const SizingImageType *
  GetComputedSizingImage() const;

  /** Output 0 is GetOutput(), 1 is GetSurface(), 2 is GetParticles(), 3 is GetJunctions(). */
  using DataObjectPointerArraySizeType = ProcessObject::DataObjectPointerArraySizeType;
  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  LabelImageToTetrahedralMeshFilter();
  ~LabelImageToTetrahedralMeshFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() const override;

  void
  VerifyInputInformation() const override;

  void
  GenerateInputRequestedRegion() override;

  void
  GenerateOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  using IndicatorImagesType = std::vector<IndicatorImageType::Pointer>;

  /** The indicators of GetLabels(), in that order. Everything is in the grid's unit and geometry. */
  virtual IndicatorImagesType
  ComputeIndicators(const TLabelImage * labels, const mmm::GridGeometry & geometry, mmm::FilterMonitor & monitor);

private:
  using MeshFilterType = IndicatorImagesToMeshFilter<IndicatorImageType, TOutputMesh>;

  mmm::SizingOptions
  GetSizingOptions() const;

  bool
  IsExterior(LabelType label) const;

  /** Whether the exterior is meshed, too. */
  bool
  IsFilled() const;

  /** The label that stands for all exterior ones. */
  LabelType
  GetExteriorLabel(const VoxelCountsType & counts) const;

  /** What is meshed of the image, or around it: the image itself if there is no margin. */
  typename TLabelImage::ConstPointer
  MakeDomain(const TLabelImage * input, const VoxelCountsType & counts) const;

  /** The place of the label that is not meshed among the labels, or -1 if there is none. */
  int
  GetExteriorIndex() const;

  /** The image in the geometry of its grid, where the stages work: the grid's unit of length, origin 0, no rotation. */
  typename TLabelImage::Pointer
  MakeGridImage(const TLabelImage * domain, const mmm::GridGeometry & geometry) const;

  /** The optional sizing image in that geometry, or a null pointer. */
  SizingImageType::Pointer
  MakeGridSizingImage(const mmm::GridGeometry & geometry) const;

  /** The optional region of interest in that geometry, or a null pointer. */
  MaskImageType::Pointer
  MakeGridRegion(const mmm::GridGeometry & geometry) const;

  /** Gives an image of a stage the geometry of the domain, with values in mm. */
  void
  RestoreGeometry(const TLabelImage * domain, Image<float, 3> * image, double unit) const;

  /** Throws if there is nothing to mesh. */
  void
  VerifyLabels(const TLabelImage * input, const VoxelCountsType & counts) const;

  /** Throws if an image of that size takes more than MaximumMemory for sure. */
  void
  VerifyMemory(const RegionType & region) const;

  /** Throws if sizes are given for labels that will not be there. */
  void
  VerifyLabelSizes(const VoxelCountsType & counts) const;

  /** Throws if the region of interest is in nothing that is meshed. */
  void
  VerifyRegionOfInterest(const TLabelImage * input) const;

  /** The stages, one by one. */
  typename TLabelImage::Pointer
  MergeIslands(const TLabelImage * labels, mmm::FilterMonitor & monitor);
  SizingImageType::Pointer
  ComputeSizing(const IndicatorImagesType & indicators,
                const mmm::GridGeometry &   geometry,
                mmm::FilterMonitor &        monitor);
  void
  BuildMeshes(const TLabelImage *         domain,
              const IndicatorImagesType & indicators,
              const SizingImageType *     sizing,
              mmm::FilterMonitor &        monitor);

  /** Passes a stage's progress on to the monitor, and the order to abort to the stage's filter. */
  void
  Observe(ProcessObject * filter, mmm::FilterMonitor & monitor);

  void
  TakeOutputs(MeshFilterType * filter);

  void
  FindVanishedLabels(const VoxelCountsType & counts);

  LabelsType     m_ExteriorLabels{ 0 };
  bool           m_FillExterior{ false };
  double         m_AirMargin{ Automatic };
  SizeValueType  m_MinimumIslandSize{ 8 };
  double         m_Radius{ Automatic };
  double         m_Epsilon{ 2.5 };
  double         m_ChordTolerance{ Automatic };
  double         m_GradientLimit{ 0.5 };
  double         m_MinimumSize{ Automatic };
  double         m_MaximumSize{ std::numeric_limits<double>::infinity() };
  double         m_MaximumVolume{ std::numeric_limits<double>::infinity() };
  LabelSizesType m_LabelSizes;
  bool           m_SizingImageReplaces{ false };
  double         m_RegionMinimumSize{ Automatic };
  double         m_RegionMaximumSize{ Automatic };
  std::uint64_t  m_Seed{ 1 };
  bool           m_SurfaceOnly{ false };
  bool           m_CompareTopology{ false };
  SizeValueType  m_MaximumNumberOfTetrahedra{ NumericTraits<SizeValueType>::max() };
  double         m_MaximumMemory{ std::numeric_limits<double>::infinity() };
  bool           m_KeepIntermediates{ false };

  LabelsType         m_Labels;
  RegionType         m_MeshedRegion;
  LabelType          m_OutsideLabel{ 0 };
  LabelsType         m_AbsentExteriorLabels;
  IslandRecordsType  m_IslandRecords;
  VoxelCountsType    m_VanishedLabels;
  mmm::MeshingReport m_Report;
  mmm::StageLog      m_StageLog;

  IndicatorImagesType      m_IndicatorImages;
  SizingImageType::Pointer m_ComputedSizingImage;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelImageToTetrahedralMeshFilter.hxx"
#endif

#endif
