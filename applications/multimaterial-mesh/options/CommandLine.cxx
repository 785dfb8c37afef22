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
#include "options/CommandLine.h"

#include "console/Errors.h"
#include "options/OptionTable.h"
#include "options/SettingsCheck.h"
#include "options/SlicerDescription.h"

#include "itkMacro.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <locale>
#include <sstream>
#include <type_traits>

namespace cli
{
namespace
{
/** All spellings, as CLI11 takes them: "--min-island,--min_island". */
std::string
SpellingsOf(const Option & option)
{
  const std::string name = NameOf(option);
  const std::string slicerName = "--" + SlicerName(option);
  return option.IsPositional() || slicerName == name ? name : name + ',' + slicerName;
}

std::string
DescribeRange(const Option & option, bool isWhole)
{
  const Range &      range = option.range;
  std::ostringstream text;
  text << (isWhole ? "a whole number" : "a number");
  if (std::isfinite(range.maximum))
  {
    text << " from " << range.minimum << " to " << range.maximum;
  }
  else
  {
    text << (range.minimumAllowed ? " of at least " : " above ") << range.minimum;
  }
  return text.str() + (option.unit.empty() ? "" : " (" + option.unit + ")");
}

template <typename TNumber>
TNumber
ParseNumber(const Option & option, const std::string & text)
{
  constexpr bool isWhole = std::is_integral_v<TNumber>;
  // Streams take a minus for unsigned numbers; they are independent of the locale, unlike strtod().
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  TNumber    value{};
  const bool isNumber = !(stream >> std::noskipws >> value).fail() && stream.eof() && !(isWhole && text.front() == '-');
  const double  number = double(value);
  const Range & range = option.range;
  if (!isNumber || number > range.maximum || number < range.minimum ||
      (number == range.minimum && !range.minimumAllowed))
  {
    throw UsageError("--" + option.name + " is '" + text + "'; it has to be " + DescribeRange(option, isWhole));
  }
  return value;
}

std::vector<int>
ParseLabels(const Option & option, const std::string & text)
{
  std::vector<int> labels;
  if (text == "none")
  {
    return labels;
  }
  const char *       position = text.data();
  const char * const end = position + text.size();
  while (true)
  {
    int        label = 0;
    const auto result = std::from_chars(position, end, label);
    if (result.ec != std::errc() || (result.ptr != end && *result.ptr != ','))
    {
      throw UsageError("--" + option.name + " is '" + text +
                       "'; it has to be integer labels separated by commas, for instance 0,5, or none");
    }
    labels.push_back(label);
    if (result.ptr == end)
    {
      return labels;
    }
    position = result.ptr + 1;
  }
}

mmm::LabelSizeRules
ParseLabelSizes(const Option & option, const std::string & text)
{
  try
  {
    const auto rules = mmm::ParseLabelSizeRules(text);
    for (const auto & [label, rule] : rules)
    {
      const std::string error = mmm::DescribeError(rule, "label " + std::to_string(label));
      if (!error.empty())
      {
        throw UsageError(ToOneLine("--" + option.name + " is '" + text + "'; " + error));
      }
    }
    return rules;
  }
  catch (const itk::ExceptionObject & exception)
  {
    throw UsageError(ToOneLine("--" + option.name + " is '" + text + "'; " + exception.GetDescription()));
  }
}

Hull
ParseHull(const Option & option, const std::string & text)
{
  const auto equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0 || text.substr(equals + 1) == "none")
  {
    throw UsageError("--" + option.name + " is '" + text + "'; it has to be " + option.placeholder +
                     ", for instance brain.surf=3,4,5");
  }
  return { text.substr(0, equals), ParseLabels(option, text.substr(equals + 1)) };
}

SurfaceLabel
ParseSurfaceLabel(const Option & option, const std::string & text)
{
  const auto equals = std::min(text.find('='), text.size());
  const auto labels = equals < text.size() ? ParseLabels(option, text.substr(0, equals)) : std::vector<int>();
  if (labels.size() != 1)
  {
    throw UsageError("--" + option.name + " is '" + text + "'; it has to be L=FILE, for instance 3=lh.pial");
  }
  return { labels.front(), text.substr(equals + 1) };
}

void
CheckChoice(const Option & option, const std::string & text)
{
  if (option.kind == Kind::Choice &&
      std::find(option.choices.begin(), option.choices.end(), text) == option.choices.end())
  {
    std::string all;
    for (const std::string & choice : option.choices)
    {
      all += (all.empty() ? "" : ", ") + choice;
    }
    throw UsageError("--" + option.name + " is '" + text + "'; it has to be one of " + all);
  }
}

void
CheckFileName(const Option & option, const std::string & text)
{
  if (option.kind == Kind::Choice || option.kind == Kind::Merges)
  {
    return;
  }
  if (text.empty())
  {
    throw UsageError(NameOf(option) + " is empty; it has to be a file name");
  }
  // The parser takes what follows an option that needs a value, whatever it is.
  if (text.front() == '-')
  {
    throw UsageError(NameOf(option) + " is '" + text + "', which looks like an option; a file of that name is ./" +
                     text);
  }
}

/** Adds an option to the parser, by the type of the member of Settings that it fills. */
class OptionAdder
{
public:
  OptionAdder(CLI::App & parser, const Option & option, Settings & settings)
    : m_Parser(parser)
    , m_Option(option)
    , m_Settings(settings)
  {}

  void
  operator()(bool Settings::* field) const
  {
    m_Parser.add_flag(SpellingsOf(m_Option), m_Settings.*field);
  }

  void
  operator()(std::vector<int> Settings::* field) const
  {
    this->AddText([this_ = *this, field](const std::string & text) {
      this_.m_Settings.*field = ParseLabels(this_.m_Option, text);
    });
  }

  void
  operator()(mmm::LabelSizeRules Settings::* field) const
  {
    this->AddText([this_ = *this, field](const std::string & text) {
      this_.m_Settings.*field = ParseLabelSizes(this_.m_Option, text);
    });
  }

  void
  operator()(std::vector<std::string> Settings::* field) const
  {
    m_Parser
      .add_option_function<std::vector<std::string>>(SpellingsOf(m_Option),
                                                     [this_ = *this, field](const std::vector<std::string> & texts) {
                                                       for (const std::string & text : texts)
                                                       {
                                                         CheckFileName(this_.m_Option, text);
                                                       }
                                                       this_.m_Settings.*field = texts;
                                                     })
      ->type_name(m_Option.placeholder)
      ->allow_extra_args(m_Option.kind == Kind::ScalarImages);
  }

  void
  operator()(std::vector<Hull> Settings::* field) const
  {
    this->AddRepeated(field, ParseHull);
  }

  void
  operator()(std::vector<SurfaceLabel> Settings::* field) const
  {
    this->AddRepeated(field, ParseSurfaceLabel);
  }

  void
  operator()(std::vector<CellDataRequest> Settings::* field) const
  {
    m_Parser
      .add_option_function<std::vector<std::string>>(
        SpellingsOf(m_Option),
        [this_ = *this, field](const std::vector<std::string> & texts) {
          for (const std::string & text : texts)
          {
            (this_.m_Settings.*field).push_back(ParseCellDataRequest(NameOf(this_.m_Option), text));
          }
        })
      ->type_name(m_Option.placeholder)
      ->allow_extra_args(false);
  }

  void
  operator()(std::string Settings::* field) const
  {
    CLI::Option * const added = this->AddText([this_ = *this, field](const std::string & text) {
      CheckChoice(this_.m_Option, text);
      CheckFileName(this_.m_Option, text);
      this_.m_Settings.*field = text;
    });
    if (m_Option.kind == Kind::Merges)
    {
      added->join(';');
    }
  }

  template <typename T>
  void
  operator()(T Settings::* field) const
  {
    this->AddNumber<T>(field);
  }

  template <typename T>
  void
  operator()(std::optional<T> Settings::* field) const
  {
    this->AddNumber<T>(field);
  }

private:
  /** An option that may be given again, with a file and labels each time. */
  template <typename T>
  void
  AddRepeated(std::vector<T> Settings::* field, T (*parse)(const Option &, const std::string &)) const
  {
    const auto take = [this_ = *this, field, parse](const std::vector<std::string> & texts) {
      for (const std::string & text : texts)
      {
        (this_.m_Settings.*field).push_back(parse(this_.m_Option, text));
        CheckFileName(this_.m_Option, (this_.m_Settings.*field).back().file);
      }
    };
    m_Parser.add_option_function<std::vector<std::string>>(SpellingsOf(m_Option), take)
      ->type_name(m_Option.placeholder)
      ->allow_extra_args(false);
  }

  CLI::Option *
  AddText(const std::function<void(const std::string &)> & take) const
  {
    return m_Parser.add_option_function<std::string>(SpellingsOf(m_Option), take)->type_name(m_Option.placeholder);
  }

  template <typename TNumber, typename TField>
  void
  AddNumber(TField field) const
  {
    this->AddText([this_ = *this, field](const std::string & text) {
      this_.m_Settings.*field = ParseNumber<TNumber>(this_.m_Option, text);
    });
  }

  CLI::App &     m_Parser;
  const Option & m_Option;
  Settings &     m_Settings;
};

/** With --indicators there is one file without option, OUTPUT, which is the last of the list if it comes after it. */
void
AssignFiles(Settings & settings)
{
  const bool hasIndicators = !settings.indicators.empty();
  const bool hasSurfaces = !settings.surfaceLabels.empty();
  if ((hasIndicators || hasSurfaces) && settings.output.empty())
  {
    settings.output.swap(settings.labels);
    if (hasIndicators && settings.output.empty())
    {
      settings.output = settings.indicators.back();
      settings.indicators.pop_back();
    }
  }
  const auto require = [](const std::string & name, bool isThere) {
    if (!isThere)
    {
      throw UsageError(name + " is required; --help lists the options");
    }
  };
  require("LABELS", !settings.labels.empty() || hasIndicators || hasSurfaces);
  require("OUTPUT", !settings.output.empty());
  require("An image after --indicators", !settings.indicators.empty() || !hasIndicators);
  if (hasIndicators && !settings.labels.empty())
  {
    throw UsageError("there are LABELS, " + settings.labels + ", and --indicators; give one of the two");
  }
}
} // namespace

Request
ParseCommandLine(int argc, const char * const * argv, Settings & settings)
{
  CLI::App parser;
  parser.allow_windows_style_options(false);
  parser.set_help_flag("");
  const CLI::Option * const help = parser.add_flag("-h,--help");
  const CLI::Option * const version = parser.add_flag("--version");
  const CLI::Option * const xml = parser.add_flag("--xml");
  const CLI::Option * const logo = parser.add_flag("--logo");
  // Slicer may pass these: an address in its own memory, which is of use to modules in libraries only, and a file for
  // numbers and texts to return, of which there are none.
  std::string ignored;
  parser.add_option("--processinformationaddress", ignored);
  parser.add_option("--returnparameterfile", ignored);
  ForEachOption([&](const Option & option) { std::visit(OptionAdder(parser, option, settings), option.target.field); });

  // Whoever asks for help is not told first what else is wrong.
  const auto isHelp = [&] { return help->count() + version->count() + xml->count() + logo->count() > 0; };
  try
  {
    parser.parse(argc, argv);
  }
  catch (const UsageError &)
  {
    if (!isHelp())
    {
      throw;
    }
  }
  catch (const CLI::ParseError & error)
  {
    if (!isHelp())
    {
      throw UsageError(ToOneLine(error.what()) + "; --help lists the options");
    }
  }
  if (isHelp())
  {
    return help->count() > 0   ? Request::Help
           : xml->count() > 0  ? Request::SlicerDescription
           : logo->count() > 0 ? Request::SlicerLogo
                               : Request::Version;
  }
  settings.exteriorIsListed = parser.get_option("--exterior")->count() > 0;
  AssignFiles(settings);
  CheckSettings(settings);
  return Request::Mesh;
}
} // namespace cli
