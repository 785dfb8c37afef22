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
#ifndef mmmLabelSlices_h
#define mmmLabelSlices_h

#include "itkLabelMeshing.h"

#include <array>
#include <map>
#include <string>

namespace mmm
{
class FilterMonitor;

/** \brief Thick slices, as of clinical images, become thinner ones, so that voxels are about cubes.
 *
 * Islands are merged before that, so that their size counts in voxels of the image. Afterwards, the stages only see the
 * finer image. What is told of voxels and regions is in terms of the image that there was. */
class LabelSlices
{
public:
  /** Replaces the images of the inputs, unless slices are to be kept, or shapes come from functions or surfaces, which
   * are on the grid of the image, or there is something wrong with the labels. */
  LabelSlices(LabelMeshingInputs & inputs, FilterMonitor & monitor);

  bool
  AreDivided() const;

  /** What was done, in a sentence; empty if nothing was. */
  std::string
  Describe() const;

  /** A number of voxels, at least 1, in those of the image. */
  std::size_t
  ToImage(std::size_t voxels) const;

  /** The least region of the image with that region of the finer one. */
  itk::ImageRegion<3>
  ToImage(const itk::ImageRegion<3> & region) const;

  /** Islands as they were in the image. Electrodes came after that. */
  void
  Restore(std::map<int, IslandRecord> & records, std::vector<int> & absentExteriorLabels) const;

private:
  bool                        m_HasElectrodes;
  std::array<int, 3>          m_Parts{ { 1, 1, 1 } };
  itk::Vector<double, 3>      m_Spacing;
  std::map<int, IslandRecord> m_Records;
  std::vector<int>            m_AbsentExteriorLabels;
};
} // namespace mmm

#endif
