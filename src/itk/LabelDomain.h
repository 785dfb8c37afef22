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
#ifndef mmmLabelDomain_h
#define mmmLabelDomain_h

#include "itkLabelMeshing.h"

namespace mmm
{
/** \brief What is meshed of a label image, by the filter's settings. */
class LabelDomain
{
public:
  /** Throws itk::ExceptionObject if there is nothing to mesh, if the image looks like one of intensities, or if what
   * the settings speak of is not there. */
  explicit LabelDomain(const LabelMeshingInputs & inputs);

  /** The image, or with an air margin the part of it, and around it, that is meshed. */
  const LabelImage *
  GetImage() const
  {
    return m_Image;
  }
  /** Its voxels by label. */
  const LabelCounts &
  GetCounts() const
  {
    return m_Counts;
  }

private:
  bool
  IsExterior(int label) const;
  /** The label that stands for all exterior ones. */
  int
  GetExteriorLabel() const;
  void
  VerifyLabels() const;
  void
  VerifyRegionOfInterest(const MaskImage * region) const;
  /** Takes what the air margin adds, in GB of memory at most. */
  void
  Extend(double largestMemory);
  /** Throws if an image of that size takes more than that for sure, in GB. */
  void
  VerifyMemory(const itk::ImageRegion<3> & region, double limit) const;
  void
  VerifyElectrodes(const Electrodes & electrodes) const;
  void
  VerifyLabelSizes(const LabelSizeRules & sizes) const;

  const LabelOptions       m_Options;
  LabelImage::ConstPointer m_Image;
  LabelCounts              m_Counts;
};

/** The least memory that the stages take at a time, for an image of that many voxels, in GB. */
double
LeastMemory(double voxels);

/** Whether the exterior is meshed, too. */
bool
IsFilled(const LabelOptions & options);

/** Whether labels have a label. */
bool
Contains(const std::vector<int> & labels, int label);
} // namespace mmm

#endif
