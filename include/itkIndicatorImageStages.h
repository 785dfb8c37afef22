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
#ifndef itkIndicatorImageStages_h
#define itkIndicatorImageStages_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingOptions.h"
#include "MultiMaterialMeshingReports.h"
#include "itkMultiMaterialMeshTypes.h"
#include "itkTetrahedronArrays.h"

#include "itkImage.h"
#include "itkProcessObject.h"

#include <functional>
#include <string>
#include <vector>

/** The compiled part of the filters of indicator images. What is wrong with inputs comes as a sentence, which is empty
 * if nothing is. */
namespace mmm
{
using FloatImage = itk::Image<float, 3>;
using MaskImage = itk::Image<unsigned char, 3>;

/** Indicator images, one for each material, in mm. */
struct IndicatorInputs
{
  std::vector<const FloatImage *> images;
  /** One for each image. */
  std::vector<int> labels;
  /** The number of the image that is not meshed, or -1. */
  int exterior{ -1 };
};

/** What users add to the computed sizes; images may be missing. */
struct SizingInputs
{
  SizingOptions            options;
  FloatImage::ConstPointer image;
  MaskImage::ConstPointer  region;
};

/** What IndicatorImagesToMeshFilter works on. */
struct MeshingInputs
{
  IndicatorInputs    indicators;
  const FloatImage * sizing{ nullptr };
  MeshingOptions     options;
  /** What the outside is to be called, unless a label is. */
  int  outsideLabel{ 0 };
  bool keepTopology{ false };
  /** Its geometry is that of the outputs; without it, that of the indicators is. */
  itk::ImageBase<3>::ConstPointer reference;
};

/** Where the meshes go. */
struct MeshingOutputs
{
  itk::LabelInterfaceMesh *                           surface;
  itk::LabelParticleMesh *                            particles;
  itk::LabelJunctionMesh *                            junctions;
  itk::LabelMidNodeMesh *                             midNodes;
  std::function<void(const itk::TetrahedronArrays &)> setTetrahedra;
};

/** What is told while meshes are made, and afterwards. */
struct MeshingState
{
  StageLog      log;
  MeshingReport report;
  int           outsideLabel{ 0 };
};

/** The smallest region that holds those of all images. */
MultiMaterialMeshing_EXPORT itk::ImageRegion<3>
                            UnionOfRegions(const std::vector<const FloatImage *> & images);

/** Whether two images have the same spacing, origin and direction, with ITK's tolerances for the inputs of a filter. */
MultiMaterialMeshing_EXPORT bool
HaveSameGeometry(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b);

/** What is wrong with settings and the number of inputs. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeError(const IndicatorInputs & indicators, const SizingInputs & sizing);
MultiMaterialMeshing_EXPORT std::string
                            DescribeError(const MeshingInputs & inputs);

/** What is wrong with the places of images. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeGeometryError(const IndicatorInputs & indicators, const SizingInputs & sizing);
MultiMaterialMeshing_EXPORT std::string
                            DescribeGeometryError(const MeshingInputs & inputs);

/** What IndicatorImagesToSizingImageFilter makes. */
MultiMaterialMeshing_EXPORT FloatImage::Pointer
ComputeSizingImage(itk::ProcessObject * filter, const IndicatorInputs & indicators, const SizingInputs & sizing);

/** What IndicatorImagesToMeshFilter makes. `releaseInputs` is called once their pixels are not needed any more. Where a
 * stage throws, the outputs but the tetrahedra hold what there is. */
MultiMaterialMeshing_EXPORT void
MeshIndicators(itk::ProcessObject *          filter,
               const MeshingInputs &         inputs,
               const std::function<void()> & releaseInputs,
               const MeshingOutputs &        outputs,
               MeshingState &                state);

/** What IndicatorImagesToLabelImageFilter finds, per voxel: the label of the largest function. They are on one grid,
 * and called by their names where their values are wrong. */
MultiMaterialMeshing_EXPORT std::vector<int>
                            LargestFunctions(const IndicatorInputs &          functions,
                                             const std::vector<int> &         exteriorLabels,
                                             const std::vector<std::string> & names);
} // namespace mmm

#endif
