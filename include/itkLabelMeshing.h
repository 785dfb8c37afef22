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
#ifndef itkLabelMeshing_h
#define itkLabelMeshing_h

#include "itkElectrodes.h"
#include "itkIndicatorImageStages.h"
#include "itkLabelImageStages.h"
#include "itkSurfaceStages.h"

/** The compiled part of LabelImageToTetrahedralMeshFilter. */
namespace mmm
{
/** What the filter works on. */
struct LabelMeshingInputs
{
  LabelImage::ConstPointer labels;
  LabelOptions             options;
  /** Whether an image that looks like one of intensities is taken for labels. */
  bool           acceptIntensities{ false };
  SizingInputs   sizing;
  MeshingOptions meshing;
  /** Where the indicators are to follow functions of the materials, on the image's grid, rather than the labels: these
   * and the labels of each. If none is exterior, the exterior's is what they leave. */
  IndicatorInputs functions;
  /** Surfaces on top of the image, and electrodes on top of them; not with functions. */
  SurfaceInputs surfaces;
  Electrodes    electrodes;
};

/** What it tells, besides the state of the meshing. */
struct LabelMeshingResults
{
  std::vector<int>            labels;
  itk::ImageRegion<3>         meshedRegion;
  std::vector<int>            absentExteriorLabels;
  std::map<int, IslandRecord> islandRecords;
  LabelCounts                 vanishedLabels;
  /** In the order of the electrodes. */
  std::vector<ElectrodeReport> electrodes;
  /** In the order of the labels. */
  std::vector<FloatImage::Pointer> indicatorImages;
  FloatImage::Pointer              sizingImage;
};

/** What is wrong with the settings, in a sentence; empty if nothing is. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeError(const LabelMeshingInputs & inputs);

/** What is wrong with the place of an image that goes with the labels; empty if nothing is, or there is none. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeGeometryError(const itk::ImageBase<3> * labels, const SizingInputs & sizing);

/** What LabelImageToTetrahedralMeshFilter makes. Where a stage throws, there is what was made until then. */
MultiMaterialMeshing_EXPORT void
MeshLabels(itk::ProcessObject *   filter,
           LabelMeshingInputs     inputs,
           const MeshingOutputs & outputs,
           MeshingState &         state,
           LabelMeshingResults &  results);
} // namespace mmm

#endif
