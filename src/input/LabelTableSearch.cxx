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
#include "input/LabelTableSearch.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <tuple>

namespace mmm
{
namespace
{
namespace fs = std::filesystem;

/** The subject's and the session's folders, that of the type of data, and the data set's. */
constexpr int MostFolders = 4;

/** What a name up to its first dot consists of: "sub-1", "space-T1w", "dseg". */
std::vector<std::string>
PartsOf(const std::string & fileName)
{
  std::vector<std::string> parts;
  std::istringstream       stream(fileName.substr(0, fileName.find('.')));
  for (std::string part; std::getline(stream, part, '_');)
  {
    parts.push_back(part);
  }
  return parts;
}

bool
IsSegmentation(const std::vector<std::string> & parts)
{
  return !parts.empty() && parts.back() == "dseg";
}

/** Those of a folder, the ones with the most entities first, tables before sidecars. */
std::vector<std::string>
TablesIn(const fs::path & folder, const std::set<std::string> & partsOfImage)
{
  using Found = std::tuple<std::ptrdiff_t, bool, std::string>;
  std::vector<Found> found;
  std::error_code    error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    const fs::path    path = entry->path();
    const bool        isTable = path.extension() == ".tsv";
    const std::string name = path.filename().u8string();
    const auto        parts = PartsOf(name);
    const auto        isOfImage = [&](const std::string & part) { return partsOfImage.count(part) != 0; };
    if ((isTable || path.extension() == ".json") && IsSegmentation(parts) &&
        std::all_of(parts.begin(), parts.end(), isOfImage))
    {
      found.emplace_back(-static_cast<std::ptrdiff_t>(parts.size()), !isTable, (folder / path.filename()).u8string());
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> names;
  std::transform(found.begin(), found.end(), std::back_inserter(names), [](const Found & one) {
    return std::get<std::string>(one);
  });
  return names;
}
} // namespace

std::vector<std::string>
FindBIDSTables(const std::string & imageName)
{
  const fs::path           image = fs::u8path(imageName);
  const auto               parts = PartsOf(image.filename().u8string());
  std::vector<std::string> tables;
  if (!IsSegmentation(parts))
  {
    return tables;
  }
  std::error_code error;
  const fs::path  absolute = fs::absolute(image, error);
  fs::path        folder = image.parent_path();
  for (int level = 0; level <= MostFolders && !error; ++level)
  {
    const auto names = TablesIn(folder, { parts.begin(), parts.end() });
    tables.insert(tables.end(), names.begin(), names.end());
    if (fs::exists(folder / "dataset_description.json", error))
    {
      break;
    }
    const fs::path above = level == 0 ? absolute.parent_path().parent_path() : folder.parent_path();
    if (above.empty() || above == folder)
    {
      break;
    }
    folder = above;
  }
  return tables;
}
} // namespace mmm
