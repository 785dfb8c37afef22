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
#ifndef mmmSegmentLayers_h
#define mmmSegmentLayers_h

#include "itkImage.h"
#include "itkImageIOBase.h"
#include "itkVectorImage.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mmm
{
/** \brief A segment of 3D Slicer's files, .seg.nrrd: those that overlap are in other layers. */
struct Segment
{
  std::string  name;
  unsigned int layer{ 0 };
  int          value{ 0 };
  /** What it becomes where layers are made one image. */
  int label{ 0 };
  /** Red, green and blue in [0, 1]. */
  std::optional<std::array<double, 3>> color;
};

/** The segments that a file's header lists, in its order; none if it is another file. Labels are the file's values if
 * no two segments have the same, else they count from 1, as Slicer exports them. */
std::vector<Segment>
FindSegments(const itk::ImageIOBase & io);

/** One label per voxel: where segments overlap, that of the later one. */
itk::Image<int, 3>::Pointer
Flatten(const itk::VectorImage<int, 3> & layers, const std::vector<Segment> & segments);
} // namespace mmm

#endif
