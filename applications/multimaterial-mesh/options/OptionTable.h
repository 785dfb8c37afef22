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
#ifndef OptionTable_h
#define OptionTable_h

#include "options/Settings.h"
#include "itkMultiMaterialMeshTypes.h"

#include "itkImage.h"

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace itk
{
template <typename TLabelImage, typename TOutputMesh>
class LabelImageToTetrahedralMeshFilter;
}

namespace cli
{
using MeshFilter = itk::LabelImageToTetrahedralMeshFilter<itk::Image<int, 3>, itk::LabelTetrahedralMesh>;

/** What an option's value is. A graphical interface offers a file dialog, a spin box and so on accordingly. */
enum class Kind
{
  Flag,
  Integer,
  Real,
  Choice,
  Labels,
  LabelSizes,
  Merges,
  LabelImage,
  ScalarImage,
  ScalarImages,
  Mesh,
  Surface,
  Particles,
  Junctions,
  OutputImage,
  Report,
  FilePrefix,
  Hulls,
  SurfaceLabels,
  TextFile,
  CellData
};

/** Inclusive, but for a minimum that is not `minimumAllowed`. */
struct Range
{
  double minimum{ -std::numeric_limits<double>::infinity() };
  bool   minimumAllowed{ true };
  double maximum{ std::numeric_limits<double>::infinity() };
};

/** The member of Settings that an option fills. */
using Field = std::variant<bool                         Settings::*,
                           double                       Settings::*,
                           std::optional<double>        Settings::*,
                           std::uint64_t                Settings::*,
                           std::optional<std::uint64_t> Settings::*,
                           std::string                  Settings::*,
                           std::vector<int>             Settings::*,
                           mmm::LabelSizeRules          Settings::*,
                           std::vector<Hull>            Settings::*,
                           std::vector<CellDataRequest> Settings::*,
                           std::vector<SurfaceLabel>    Settings::*,
                           std::vector<std::string>     Settings::*>;

/** \brief Where an option's value goes: a member of Settings and, for many, a parameter of the filter. */
struct Target
{
  template <typename T>
  Target(T Settings::* member, const char * name = "", void (*setter)(MeshFilter &, const Settings &) = nullptr)
    : field(member)
    , parameter(name)
    , set(setter)
  {}

  Field field;
  /** "Epsilon", if the filter has Set- and GetEpsilon(); else empty. */
  std::string parameter;
  /** Null if there is more to do than to hand over the setting. */
  void (*set)(MeshFilter & filter, const Settings & settings);
};

/** Whom an option is for. */
enum class Audience
{
  All,
  /** Not for graphical interfaces, which want LABELS in any case. */
  CommandLine,
  /** Graphical interfaces set it without asking their user. */
  Hidden
};

/** \brief All there is to know about an option; the parser, the help, other interfaces, the report's parameters and the
 * table in docs/parameters.md are made from it. */
struct Option
{
  /** Without hyphens before it. Positional arguments are in capitals. */
  std::string name;
  Target      target;
  Kind        kind;
  /** What stands for the value in the help; empty for flags. */
  std::string placeholder;
  /** "mm" and the like, or empty. */
  std::string unit;
  Range       range;
  /** In words, where Settings have no value that tells it. */
  std::string defaultText;
  std::string help;
  /** Of Kind::Choice. */
  std::vector<std::string> choices{};
  Audience                 audience{ Audience::All };

  bool
  IsPositional() const;

  /** Whether it names a file that is written. */
  bool
  IsOutput() const;

  /** Whether a file or its own value is optional: there is no number for "not given". */
  bool
  IsOptionalNumber() const;
};

struct OptionGroup
{
  std::string         name;
  std::string         description;
  std::vector<Option> options;
};

const std::vector<OptionGroup> &
OptionTable();

/** Calls body(option) for all of them. */
template <typename TBody>
void
ForEachOption(const TBody & body)
{
  for (const OptionGroup & group : OptionTable())
  {
    for (const Option & option : group.options)
    {
      body(option);
    }
  }
}

/** As on the command line: "OUTPUT" or "--surface". */
std::string
NameOf(const Option & option);

/** A setting in the form of the command line; empty if there is none, or if it is a flag. */
std::string
ValueText(const Option & option, const Settings & settings);

/** In words: what is taken without the option; empty if that is nothing. */
std::string
DefaultText(const Option & option);
} // namespace cli

#endif
