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
#include "itkSurfaceStages.h"

namespace mmm
{
/** \brief The indicators of a label image with surfaces on top of it.
 *
 * With d_k for the signed distance of surface k, positive inside, and phi_i for the smooth indicator of label i of the
 * image, the indicator of label l is the largest of min(d_k, -d of every later surface of another label) over the
 * surfaces k of label l, and min(phi_l, -d of every surface of another label). So where a surface is visible, the
 * indicator within is d and that of what is around is -d: the interface is where d is 0, whatever the image's voxels
 * say. Away from surfaces the image's interfaces are as without them. */
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
  using Distances = std::vector<std::vector<float>>;

  /** At the nodes of the grid, in its unit. */
  Distances
  GetDistances(const LabelImage * labels, const GridGeometry & geometry) const;
  /** The image below the surfaces: where they hide it, its own labels as far as they are visible elsewhere, else those
   * of the nearest such voxels. */
  LabelImage::Pointer
  MakeImageBelow(const LabelImage *       labels,
                 const std::vector<int> & present,
                 const GridGeometry &     geometry,
                 const Distances &        distances) const;

  SurfaceInputs            m_Surfaces;
  LabelImage::ConstPointer m_Image;
};
} // namespace mmm

#endif
