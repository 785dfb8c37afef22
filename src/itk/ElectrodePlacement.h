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
#ifndef mmmElectrodePlacement_h
#define mmmElectrodePlacement_h

#include "MultiMaterialMeshingOptions.h"
#include "itkElectrodes.h"
#include "itkSurfaceStages.h"

#include <vector>

namespace mmm
{
/** Electrodes as surfaces on top of a label image, and what is known of them before there is a mesh. */
struct PlacedElectrodes
{
  /** Of electrodes and gels, in order, each on the part of the grid that it is in, which may go beyond the image. */
  SurfaceInputs surfaces;
  /** The image's region, grown to hold them. */
  itk::ImageRegion<3>          region;
  std::vector<ElectrodeReport> reports;
  /** What the edges of round ones are to be, in mm. */
  LabelSizeRules sizes;
};

/** `sizes` are those that users ask for. Throws itk::ExceptionObject with the source of an electrode that cannot be
 * placed, and why. `labels` are those of the image and its surfaces. */
PlacedElectrodes
PlaceElectrodes(const Electrodes &       electrodes,
                const LabelImage *       labels,
                const std::vector<int> & exteriorLabels,
                const LabelSizeRules &   sizes);
} // namespace mmm

#endif
