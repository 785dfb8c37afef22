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
#ifndef itkLabelImageStages_h
#define itkLabelImageStages_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingReports.h"

#include "itkImage.h"
#include "itkProcessObject.h"

#include <map>
#include <string>
#include <vector>

/** The compiled part of the filters of label images. */
namespace mmm
{
using LabelImage = itk::Image<int, 3>;
using FloatImage = itk::Image<float, 3>;

/** What MergeLabelIslandsImageFilter makes of an image, for the sake of which filter, and what it has to tell. Labels
 * of `exteriorLabels` that the image lacks are in `absentLabels`, in their order. */
MultiMaterialMeshing_EXPORT void
MergeLabelIslands(itk::ProcessObject *          filter,
                  const std::vector<int> &      exteriorLabels,
                  std::size_t                   minimumIslandSize,
                  LabelImage *                  labels,
                  std::map<int, IslandRecord> & records,
                  std::vector<int> &            absentLabels);

/** The voxels of each label. */
MultiMaterialMeshing_EXPORT LabelCounts
CountLabels(const LabelImage * image);

/** What makes an image look like one of intensities, as a text that goes after "the image "; empty for a label image.
 * Many values that change from voxel to voxel do; many labels of some size do not. `counts` are those of the image. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeIntensities(const LabelImage * image, const LabelCounts & counts);

/** The largest magnitude of indicators in an image's physical space, in mm. */
MultiMaterialMeshing_EXPORT double
IndicatorBandWidthOf(const itk::ImageBase<3> * image);

/** The settings of LabelImageToIndicatorImagesFilter. */
struct SmoothingOptions
{
  /** In mm; not a number where the smallest voxel spacing decides. */
  double radius;
  bool   keepContacts;
  bool   cropToBand;
};

/** The indicators of an image's labels, which are sorted, in mm. */
struct LabelIndicators
{
  std::vector<int>                 labels;
  std::vector<FloatImage::Pointer> images;
};

/** What LabelImageToIndicatorImagesFilter makes of an image. */
MultiMaterialMeshing_EXPORT LabelIndicators
ComputeIndicatorImages(itk::ProcessObject * filter, const SmoothingOptions & options, const LabelImage * labels);
} // namespace mmm

#endif
