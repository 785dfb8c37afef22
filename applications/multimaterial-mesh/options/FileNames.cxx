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
#include "options/FileNames.h"

#include "console/Errors.h"
#include "itkLabelMeshFileWriter.h"
#include "itkOutputFile.h"

#include <cctype>
#include <type_traits>

namespace cli
{
namespace
{
/** What stands before the number, and after it. */
using NameParts = std::pair<std::string, std::string>;

NameParts
SurfaceNameParts(const std::string & prefix)
{
  const std::string extension = FindExtension(Kind::Surface, prefix);
  return { prefix.substr(0, prefix.size() - extension.size()), extension.empty() ? ".stl" : extension };
}

NameParts
IndicatorNameParts(const std::string & prefix)
{
  return { prefix, ".nrrd" };
}

/** An option and a file that it names. */
struct NamedFile
{
  std::string option;
  std::string name;
  Kind        kind;
};

/** Those that are not named by label. */
std::vector<NamedFile>
FilesOf(const Settings & settings, bool areOutputs)
{
  std::vector<NamedFile> files;
  ForEachOption([&](const Option & option) {
    const bool isFile = option.kind == Kind::LabelImage || option.kind == Kind::ScalarImage ||
                        option.kind == Kind::ScalarImages || option.kind == Kind::TextFile ||
                        option.kind == Kind::CellData || option.kind == Kind::SurfaceLabels || option.IsOutput();
    if (!isFile || option.kind == Kind::FilePrefix || option.IsOutput() != areOutputs)
    {
      return;
    }
    const auto add = [&](const std::string & name) {
      if (!name.empty())
      {
        files.push_back({ NameOf(option), name, option.kind });
      }
    };
    std::visit(
      [&](auto field) {
        const auto & value = settings.*field;
        using T = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<T, std::string>)
        {
          add(value);
        }
        else if constexpr (std::is_same_v<T, std::vector<std::string>>)
        {
          for (const std::string & name : value)
          {
            add(name);
          }
        }
        else if constexpr (std::is_same_v<T, std::vector<Hull>> || std::is_same_v<T, std::vector<CellDataRequest>> ||
                           std::is_same_v<T, std::vector<SurfaceLabel>>)
        {
          for (const auto & entry : value)
          {
            add(entry.file);
          }
        }
      },
      option.target.field);
  });
  return files;
}

/** Whether a name is that of a label's file. */
bool
IsNameForLabel(const std::string & name, const NameParts & parts)
{
  const auto & [prefix, suffix] = parts;
  if (name.size() <= prefix.size() + suffix.size() || name.compare(0, prefix.size(), prefix) != 0 ||
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
  {
    return false;
  }
  // "-7", or "3-gray_matter"
  const auto part = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  const auto end = part.find_first_not_of("0123456789", part.front() == '-');
  return end == std::string::npos ||
         (end > 0 && std::isdigit(static_cast<unsigned char>(part[end - 1])) && part[end] == '-');
}

/** What all systems take in the name of a file; umlauts and the like stay. */
std::string
ForFileName(const std::string & name)
{
  constexpr std::size_t longest = 60;
  std::string           text;
  for (const char character : name)
  {
    const auto code = static_cast<unsigned char>(character);
    const bool isPlain = std::isalnum(code) || code >= 0x80 || character == '-' || character == '.';
    // a name in UTF-8 is not cut within a character
    if (text.size() >= longest && (code & 0xc0) != 0x80)
    {
      break;
    }
    if (isPlain || (!text.empty() && text.back() != '_'))
    {
      text += isPlain ? character : '_';
    }
  }
  const auto last = text.find_last_not_of("_.");
  return last == std::string::npos ? "" : text.substr(0, last + 1);
}

/** Adds a file of label 0, and checks that those of other labels are not `others`. */
void
AddPrefix(std::vector<NamedFile> &       outputs,
          const std::string &            option,
          const NameParts &              parts,
          const std::vector<NamedFile> & others)
{
  for (const NamedFile & other : others)
  {
    if (IsNameForLabel(other.name, parts))
    {
      throw UsageError(option + " could write to " + other.name + ", which is the file of " + other.option +
                       "; choose another prefix");
    }
  }
  outputs.push_back({ option, parts.first + '0' + parts.second, Kind::FilePrefix });
}
} // namespace

const std::vector<std::string> &
ExtensionsOf(Kind kind)
{
  // Images of a single file, so that it can be renamed once it is complete.
  static const std::vector<std::string> images{ ".nrrd", ".nii", ".nii.gz", ".mha" };
  static const std::vector<std::string> others{ ".vtu" };
  return kind == Kind::Mesh                             ? itk::LabelMeshFileWriter::GetVolumeExtensions()
         : kind == Kind::Surface || kind == Kind::Hulls ? itk::LabelMeshFileWriter::GetSurfaceExtensions()
         : kind == Kind::OutputImage                    ? images
                                                        : others;
}

std::string
FindExtension(Kind kind, const std::string & fileName)
{
  return itk::LabelMeshFileWriter::FindExtension(fileName, ExtensionsOf(kind));
}

std::string
DescribeExtensions(Kind kind)
{
  const auto & extensions = ExtensionsOf(kind);
  std::string  text = extensions.front();
  for (std::size_t i = 1; i < extensions.size(); ++i)
  {
    text += (i + 1 < extensions.size() ? ", " : " or ") + extensions[i];
  }
  return text;
}

std::vector<std::string>
MeshFiles(const Settings & settings)
{
  std::vector<std::string> files{ settings.output };
  for (const std::string & name : { settings.surface, settings.surfacePrefix })
  {
    files.insert(files.end(), !name.empty(), name);
  }
  for (const Hull & hull : settings.hulls)
  {
    files.push_back(hull.file);
  }
  return files;
}

std::string
SurfaceName(const std::string & prefix, int label, const std::string & name)
{
  const auto [stem, extension] = SurfaceNameParts(prefix);
  const std::string part = ForFileName(name);
  return stem + std::to_string(label) + (part.empty() ? "" : '-' + part) + extension;
}

std::string
IndicatorName(const std::string & prefix, int label)
{
  const auto [stem, extension] = IndicatorNameParts(prefix);
  return stem + std::to_string(label) + extension;
}

void
CheckFileFormats(const Settings & settings)
{
  for (const NamedFile & file : FilesOf(settings, true))
  {
    const Kind         kind = file.kind == Kind::Mesh && settings.surfaceOnly ? Kind::Surface : file.kind;
    const char * const what = kind == Kind::Mesh                             ? "meshes"
                              : kind == Kind::Surface || kind == Kind::Hulls ? "surfaces"
                              : kind == Kind::Particles                      ? "particles"
                              : kind == Kind::Junctions                      ? "junctions"
                              : kind == Kind::OutputImage                    ? "images"
                                                                             : nullptr;
    if (what != nullptr && FindExtension(kind, file.name).empty())
    {
      throw UsageError(file.option + " is '" + file.name + "'; " + what + " are written as " +
                       DescribeExtensions(kind));
    }
  }
}

void
CheckOutputs(const Settings & settings)
{
  auto others = FilesOf(settings, false);
  auto outputs = FilesOf(settings, true);
  auto all = others;
  all.insert(all.end(), outputs.begin(), outputs.end());
  if (!settings.indicatorPrefix.empty())
  {
    AddPrefix(outputs, "--save-indicators", IndicatorNameParts(settings.indicatorPrefix), all);
  }
  if (!settings.surfacePrefix.empty())
  {
    AddPrefix(outputs, "--surface-per-label", SurfaceNameParts(settings.surfacePrefix), all);
  }
  for (const NamedFile & output : outputs)
  {
    for (const NamedFile & other : others)
    {
      if (itk::OutputFile::IsSame(output.name, other.name))
      {
        throw UsageError(other.option + " and " + output.option + " are the same file, " + output.name);
      }
    }
    itk::OutputFile::CheckWritable(output.name);
    others.push_back(output);
  }
}
} // namespace cli
