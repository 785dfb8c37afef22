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
#ifndef mmmCellLabels_h
#define mmmCellLabels_h

#include "io/CellMesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mmm
{
/** Far more than meet anywhere. A name that lists more is not one of ours. */
constexpr std::size_t maximumLabelsOfACell = 16;

/** The labels of cells, `components` each. */
struct CellLabels
{
  std::size_t               components{ 0 };
  std::vector<std::int64_t> values;
};

/** Takes labels as itk::MeshIOBase passes them. Throws MeshFileError unless they are whole numbers of 64 bits. */
CellLabels
TakeLabels(const void * buffer, itk::IOComponentEnum type, std::size_t numberOfValues, std::size_t components);

/** \brief Gives each cell the tag of its labels' group, and each group without name one: "label 3", or "labels 0 2".
 *
 * A single label is its own tag if that is at least `lowestTag` and no larger than an int. All others, and pairs of
 * labels and so on, are numbered in ascending order from `lowestTag` or from the largest other tag. Their names tell
 * which labels they stand for, after the label's own name if it has one: "air (label 0)". Returns them: for messages.
 */
std::vector<std::pair<std::string, int>>
SetTags(CellMesh & mesh, const CellLabels & labels, int lowestTag);

/** The inverse: labels by the names of the groups where these are of that form, else the tags. Labels have as many
 * components as the names of all groups say, or one. */
CellLabels
GetLabels(const CellMesh & mesh);

/** What SetTags() calls a group: "label 3" or "labels 0 2". */
std::string
GroupName(const std::int64_t * labels, std::size_t components);
} // namespace mmm

#endif
