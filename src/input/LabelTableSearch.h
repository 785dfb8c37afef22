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
#ifndef mmmLabelTableSearch_h
#define mmmLabelTableSearch_h

#include <string>
#include <vector>

namespace mmm
{
/** \brief Files beside an image of BIDS that may have the names of its labels, the nearest first.
 *
 * For sub-1_space-T1w_dseg.nii.gz these are tables and sidecars, .tsv and .json, whose name ends with dseg and has no
 * entity, such as space-T1w, that the image's has not: in its folder and in those above it, up to the one that has a
 * dataset_description.json, but no further than four. Empty if the image's name does not end with dseg. */
std::vector<std::string>
FindBIDSTables(const std::string & imageName);
} // namespace mmm

#endif
