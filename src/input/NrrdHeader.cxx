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
#include "input/NrrdHeader.h"

#include "itkMacro.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <locale>
#include <map>
#include <sstream>

namespace mmm
{
namespace
{
std::string
Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/** The fields of the header by name, in lower case; none if it is not NRRD. */
std::map<std::string, std::string>
ReadFields(const std::string & fileName)
{
  std::map<std::string, std::string> fields;
  std::ifstream                      stream(std::filesystem::u8path(fileName), std::ios::binary);
  char                               magic[4] = {};
  stream.read(magic, 4);
  std::string line;
  std::getline(stream, line);
  if (std::string(magic, 4) != "NRRD")
  {
    return fields;
  }
  while (std::getline(stream, line))
  {
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.empty())
    {
      break;
    }
    const auto colon = line.find(": ");
    if (line.front() != '#' && colon != std::string::npos)
    {
      fields[Lower(line.substr(0, colon))] = line.substr(colon + 2);
    }
  }
  return fields;
}

/** The vectors of "(1,0,0) none (0,1,0)". */
std::vector<std::vector<double>>
ParseVectors(const std::string & text)
{
  std::vector<std::vector<double>> vectors;
  for (auto open = text.find('('); open != std::string::npos; open = text.find('(', open + 1))
  {
    std::istringstream numbers(text.substr(open + 1, text.find(')', open) - open - 1));
    vectors.emplace_back();
    for (std::string number; std::getline(numbers, number, ',');)
    {
      std::istringstream stream(number);
      stream.imbue(std::locale::classic());
      double value = std::numeric_limits<double>::quiet_NaN();
      vectors.back().push_back(stream >> value ? value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return vectors;
}

/** The signs that lead from a space to LPS; nothing for one that says nothing of a patient. */
std::optional<std::array<double, 3>>
SignsOf(const std::string & space)
{
  const auto has = [&](const char * word, char letter, std::size_t place) {
    return space.find(word) != std::string::npos || (space.size() >= 3 && space.size() <= 4 && space[place] == letter);
  };
  const bool isKnown = space.find("superior") != std::string::npos || space == "ras" || space == "las" ||
                       space == "lps" || space == "rast" || space == "last" || space == "lpst";
  if (!isKnown)
  {
    return std::nullopt;
  }
  return std::array<double, 3>{ has("right", 'r', 0) ? -1.0 : 1.0, has("anterior", 'a', 1) ? -1.0 : 1.0, 1.0 };
}

double
UnitOf(const std::string & units, std::vector<std::string> & notes)
{
  const std::map<std::string, double> known{ { "um", 1e-3 },      { "\xc2\xb5m", 1e-3 }, { "micron", 1e-3 },
                                             { "microns", 1e-3 }, { "cm", 10.0 },        { "m", 1e3 },
                                             { "nm", 1e-6 },      { "meter", 1e3 } };
  const auto                          first = units.find('"');
  const std::string                   unit =
    first == std::string::npos ? "" : units.substr(first + 1, units.find('"', first + 1) - first - 1);
  const auto found = known.find(Lower(unit));
  if (found == known.end())
  {
    return 1.0;
  }
  notes.push_back("its unit is " + unit + " (space units); the mesh is in mm");
  return found->second;
}
} // namespace

std::optional<Affine>
ReadNrrdPlace(const std::string & fileName, std::vector<std::string> & notes)
{
  auto       fields = ReadFields(fileName);
  const auto directions = ParseVectors(fields["space directions"]);
  const auto origins = ParseVectors(fields["space origin"]);
  const auto isSpatial = [](const std::vector<double> & vector) { return vector.size() == 3; };
  if (directions.size() != 3 || !std::all_of(directions.begin(), directions.end(), isSpatial))
  {
    return std::nullopt;
  }
  const auto   signs = SignsOf(Lower(fields["space"])).value_or(std::array<double, 3>{ 1.0, 1.0, 1.0 });
  const double unit = UnitOf(fields["space units"], notes);
  Affine       affine;
  for (unsigned int row = 0; row < 3; ++row)
  {
    const double factor = signs[row] * unit;
    affine.origin[row] = origins.size() == 1 && isSpatial(origins.front()) ? origins.front()[row] * factor : 0.0;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      affine.steps[axis][row] = directions[axis][row] * factor;
    }
  }
  return affine;
}

itk::Matrix<double, 3, 3>
ReadNrrdFrame(const std::string & fileName)
{
  auto       fields = ReadFields(fileName);
  const auto vectors = ParseVectors(fields["measurement frame"]);
  const bool hasFrame = vectors.size() == 3 && std::all_of(vectors.begin(), vectors.end(), [](const auto & vector) {
                          return vector.size() == 3;
                        });
  const auto signs = SignsOf(Lower(fields["space"])).value_or(std::array<double, 3>{ 1.0, 1.0, 1.0 });
  itk::Matrix<double, 3, 3> frame;
  frame.SetIdentity();
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      frame[row][axis] = signs[row] * (hasFrame ? vectors[axis][row] : frame[row][axis]);
    }
  }
  return frame;
}
} // namespace mmm
