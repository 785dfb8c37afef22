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
#ifndef LabelChanges_h
#define LabelChanges_h

#include "options/Settings.h"

#include "itkImage.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cli
{
/** \brief Other labels for those of the image: by --map, then --merge, then --labels. */
class LabelChanges
{
public:
  /** Throws UsageError for what cannot be understood, Error for a file that cannot be read. */
  explicit LabelChanges(const Settings & settings);

  /** Warns of labels that an option names and no voxel has. Returns what each label of the image has become; nothing if
   * no option changes labels. */
  std::map<int, int>
  Apply(itk::Image<int, 3> & image) const;

private:
  void
  ReadMap(const std::string & fileName);
  void
  ParseMerge(const std::string & text);
  int
  operator()(int label) const;

  std::map<int, int> m_Map;
  std::optional<int> m_MapOfOthers;
  std::map<int, int> m_Merge;
  /** Empty if all are meshed. */
  std::set<int>    m_Only;
  std::vector<int> m_Exterior;
};
} // namespace cli

#endif
