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

#include "Settings.h"

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace cli
{
/** What an option's value is. A graphical interface offers a file dialog, a spin box and so on accordingly. */
enum class Kind
{
  Flag,
  Integer,
  Real,
  Choice,
  Labels,
  LabelSizes,
  LabelImage,
  ScalarImage,
  ScalarImages,
  Mesh,
  Surface,
  Particles,
  Junctions,
  File,
  FilePrefix
};

enum class Channel
{
  Input,
  Output
};

/** Inclusive, but for a minimum that is not `minimumAllowed`. */
struct Range
{
  double minimum{ -std::numeric_limits<double>::infinity() };
  bool   minimumAllowed{ true };
  double maximum{ std::numeric_limits<double>::infinity() };
};

/** \brief All there is to know about an option; the parser, the help and other interfaces are made from it. */
struct Option
{
  using Field = std::variant<bool                         Settings::*,
                             double                       Settings::*,
                             std::optional<double>        Settings::*,
                             std::uint64_t                Settings::*,
                             std::optional<std::uint64_t> Settings::*,
                             std::string                  Settings::*,
                             std::vector<int>             Settings::*,
                             mmm::LabelSizeRules          Settings::*,
                             std::vector<std::string>     Settings::*>;

  /** Without hyphens before it. Positional arguments are in capitals. */
  std::string name;
  Field       field;
  Kind        kind;
  Channel     channel;
  std::string group;
  /** What stands for the value in the help; empty for flags. */
  std::string placeholder;
  /** "mm" and the like, or empty. */
  std::string unit;
  Range       range;
  /** In words; empty where there is none. */
  std::string defaultValue;
  std::string help;
  /** Of Kind::Choice. */
  std::vector<std::string> choices{};
  /** Set by a graphical interface, without asking its user. */
  bool isHidden{ false };
  /** Not offered by a graphical interface, which wants LABELS in any case. */
  bool isForCommandLine{ false };

  bool
  IsPositional() const;
};

/** As on the command line: "OUTPUT" or "--surface". */
std::string
NameOf(const Option & option);

/** Ordered by group. */
const std::vector<Option> &
OptionTable();
} // namespace cli

#endif
