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
#ifndef mmmSurfaceOverlay_h
#define mmmSurfaceOverlay_h

#include "base/Monitor.h"
#include "itk/GridGeometry.h"
#include "itk/IndicatorLayers.h"
#include "itkSurfaceStages.h"

namespace mmm
{
/** \brief The indicators of a label image with surfaces on top of it: see PutOnTop().
 *
 * Where a surface is visible, the interface is where its distance is 0, whatever the image's voxels say. Away from
 * surfaces the image's interfaces are as without them. */
class SurfaceOverlay
{
public:
  /** `image` is without the surfaces. */
  SurfaceOverlay(const SurfaceInputs & surfaces, const LabelImage * image)
    : m_Surfaces(surfaces)
    , m_Image(image)
  {}

  /** The indicators of the labels `present` of an image, in its unit, each on a part of it. `labels` is what became of
   * ComposeLabels(), in the geometry of the grid: a region of it, without islands. Where these were merged, the voxel's
   * label is that of `labels`. */
  std::vector<FloatImage::Pointer>
  ComputeIndicators(const LabelImage *       labels,
                    const std::vector<int> & present,
                    const GridGeometry &     geometry,
                    const SmoothingOptions & options,
                    Monitor &                monitor) const;

private:
  using Layers = std::vector<IndicatorLayer>;

  /** The surfaces at the nodes of the grid, in its unit. */
  Layers
  GetLayers(const GridGeometry & geometry) const;
  /** The number of the layer that is visible at each node, or -1. */
  static std::vector<int>
  GetTops(const int * own, const Layers & layers, const Grid & grid);
  /** Islands that were merged are not in surfaces any more. */
  static void
  TakeMergedIslands(const int * labels, const std::vector<int> & tops, const Grid & grid, Layers & layers);
  /** The image below the surfaces: where they hide it, its own labels as far as they are visible elsewhere, else those
   * of the nearest such voxels. */
  LabelImage::Pointer
  MakeImageBelow(const LabelImage *       labels,
                 const std::vector<int> & present,
                 const GridGeometry &     geometry,
                 const int *              own,
                 const std::vector<int> & tops) const;

  SurfaceInputs            m_Surfaces;
  LabelImage::ConstPointer m_Image;
};
} // namespace mmm

#endif
