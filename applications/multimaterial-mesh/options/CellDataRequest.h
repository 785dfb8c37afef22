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
#ifndef CellDataRequest_h
#define CellDataRequest_h

#include <string>

namespace cli
{
/** An image that is sampled on the tetrahedra. */
struct CellDataRequest
{
  std::string name;
  std::string file;
  /** One of itk::TetrahedronImageSampler::GetModes(). */
  std::string mode;
  /** Tensors are along the axes of the image's voxels, whatever its header says. */
  bool inVoxelAxes{ false };
};

/** From "NAME=IMAGE", "NAME=IMAGE:MODE" or "NAME=IMAGE:MODE:voxels"; without a mode it is the first one. Throws
 * UsageError, which says what `option` has to be. */
CellDataRequest
ParseCellDataRequest(const std::string & option, const std::string & text);
} // namespace cli

#endif
