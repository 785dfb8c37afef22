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
#ifndef Input_h
#define Input_h

#include "options/Settings.h"
#include "run/LabelNames.h"
#include "itkElectrodes.h"
#include "itkLabelImageStages.h"
#include "itkSurfaceStages.h"
#include "itkVolumeFileReader.h"

#include "itkImage.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cli
{
using LabelImage = itk::Image<int, 3>;
using ScalarImage = itk::Image<float, 3>;

using TensorImage = itk::VolumeFileReader::TensorImageType;

/** An image that is sampled on the tetrahedra; the other one is null. */
struct SampledImage
{
  ScalarImage::Pointer scalars;
  TensorImage::Pointer tensors;
};

/** \brief What is meshed: labels or indicators. With indicators, the labels are the partition that they make. */
struct Input
{
  /** Without the surfaces; all exterior if there is nothing else. */
  LabelImage::Pointer               labels;
  std::vector<ScalarImage::Pointer> indicators;
  mmm::SurfaceInputs                surfaces;
  mmm::Electrodes                   electrodes;
  /** By label, surfaces on top; of electrodes it is known after meshing. */
  mmm::LabelCounts voxels;
  LabelNames       names;
  /** In S/m, of the labels that are meshed; empty without --conductivity. */
  std::map<int, double> conductivity;
  /** In the order of the settings' cellData. */
  std::vector<SampledImage> cellData;
};

/** Read what the settings name and check it. Throw where it cannot be meshed, and warn of what is doubtful. */
Input
ReadInput(const Settings & settings);
LabelImage::Pointer
ReadLabelImage(const std::string & fileName);
ScalarImage::Pointer
ReadScalarImage(const std::string & fileName);

/** The label that air gets, if there is some: --fill-exterior and --air-margin ask for it. */
std::optional<int>
LabelOfAir(const Settings & settings, const mmm::LabelCounts & voxels);
} // namespace cli

#endif
