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
#ifndef MeshFormat_h
#define MeshFormat_h

#include <string>

namespace cli
{
struct Settings;

/** The extensions of the files that meshes can be written to, with their points: ".msh". */
enum class MeshKind
{
  Volume,
  Surface,
  Points,
  Curves
};

/** The extension of a file name, if such meshes can be written to such files; else an empty text. */
std::string
ExtensionFor(MeshKind kind, const std::string & fileName);

/** ".vtu, .msh or .mesh" */
std::string
DescribeExtensions(MeshKind kind);

/** How meshes are written to files of formats that leave a choice. */
struct MeshStyle
{
  /** One of MshFormats(). */
  std::string mshFormat;
  /** Where the file cannot say that its points are in LPS, they are in RAS. */
  bool ras{ false };
  /** The label that stands for what is not meshed. */
  int outside{ 0 };

  bool
  IsForSimNIBS() const;
};

MeshStyle
StyleOf(const Settings & settings, int outside);

/** What --msh-format can be. */
constexpr const char * MshFormats[] = { "4.1", "4.1-ascii", "2.2", "2.2-ascii", "simnibs" };

/** The name of a label's own surface: before the extension, if there is one that surfaces can be written to, else with
 * ".stl". */
std::string
NameForLabel(const std::string & prefix, int label);
} // namespace cli

#endif
