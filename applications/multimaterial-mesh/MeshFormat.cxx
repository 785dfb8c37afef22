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
#include "MeshFormat.h"

#include "Settings.h"

#include <vector>

namespace cli
{
namespace
{
const std::vector<std::string> &
Extensions(MeshKind kind)
{
  static const std::vector<std::string> volume{ ".vtu", ".msh", ".mesh" };
  static const std::vector<std::string> surface{ ".vtu", ".msh", ".mesh", ".stl", ".obj", ".off" };
  static const std::vector<std::string> others{ ".vtu" };
  return kind == MeshKind::Volume ? volume : kind == MeshKind::Surface ? surface : others;
}
} // namespace

std::string
ExtensionFor(MeshKind kind, const std::string & fileName)
{
  for (const std::string & extension : Extensions(kind))
  {
    if (fileName.size() > extension.size() &&
        fileName.compare(fileName.size() - extension.size(), extension.size(), extension) == 0)
    {
      return extension;
    }
  }
  return "";
}

std::string
DescribeExtensions(MeshKind kind)
{
  const auto & extensions = Extensions(kind);
  std::string  text = extensions.front();
  for (std::size_t i = 1; i < extensions.size(); ++i)
  {
    text += (i + 1 < extensions.size() ? ", " : " or ") + extensions[i];
  }
  return text;
}

bool
MeshStyle::IsForSimNIBS() const
{
  return mshFormat == "simnibs";
}

MeshStyle
StyleOf(const Settings & settings, int outside)
{
  return { settings.mshFormat, settings.ras, outside };
}

std::string
NameForLabel(const std::string & prefix, int label)
{
  const std::string extension = ExtensionFor(MeshKind::Surface, prefix);
  return prefix.substr(0, prefix.size() - extension.size()) + std::to_string(label) +
         (extension.empty() ? ".stl" : extension);
}
} // namespace cli
