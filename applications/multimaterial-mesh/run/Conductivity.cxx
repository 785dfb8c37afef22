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
#include "run/Conductivity.h"

#include "console/Errors.h"
#include "console/Warnings.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <vector>

namespace cli
{
namespace
{
/** A label or a name, its conductivity, and where that is said: "line 3", or "'gray matter'". */
struct Record
{
  std::string key;
  double      value;
  std::string place;
};

std::string
Trimmed(const std::string & text, const char * characters)
{
  const auto first = text.find_first_not_of(characters);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(characters) + 1 - first);
}

std::vector<Record>
ParseLines(const std::string & fileName, const std::string & text)
{
  std::vector<Record> records;
  std::istringstream  stream(text);
  int                 number = 0;
  for (std::string line; std::getline(stream, line);)
  {
    const std::string place = "line " + std::to_string(++number);
    line = Trimmed(line.substr(0, line.find('#')), " \t\r");
    if (line.empty())
    {
      continue;
    }
    const auto         last = line.find_last_of(" \t=:");
    std::istringstream word(last == std::string::npos ? "" : line.substr(last + 1));
    word.imbue(std::locale::classic());
    double            value = 0.0;
    const std::string key = Trimmed(line.substr(0, last), " \t=:\"");
    if (key.empty() || !(word >> value) || word.peek() != std::istringstream::traits_type::eof())
    {
      throw Error(fileName + ": " + place + " is not LABEL S/M or NAME S/M, such as 3 0.33 or gray matter 0.33");
    }
    records.push_back({ key, value, place });
  }
  return records;
}

std::vector<Record>
ParseJSON(const std::string & fileName, const std::string & text)
{
  std::vector<Record> records;
  try
  {
    const auto json = nlohmann::ordered_json::parse(text);
    for (const auto & member : json.items())
    {
      const std::string place = '\'' + member.key() + '\'';
      if (!member.value().is_number())
      {
        throw Error(fileName + ": " + place + " is not followed by a number, its conductivity in S/m");
      }
      records.push_back({ member.key(), member.value().get<double>(), place });
    }
  }
  catch (const nlohmann::json::exception & error)
  {
    throw Error(fileName + ": this is not JSON: " + ToOneLine(error.what()));
  }
  return records;
}

std::vector<Record>
ReadRecords(const std::string & fileName)
{
  std::ifstream stream(std::filesystem::u8path(fileName), std::ios::binary);
  if (!stream)
  {
    throw Error(fileName + ": the file of --conductivity cannot be opened");
  }
  const std::string text{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  const auto        first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '{' ? ParseJSON(fileName, text) : ParseLines(fileName, text);
}

/** The label itself, or those that have the name. */
std::vector<int>
LabelsOf(const std::string & key, const LabelNames & names)
{
  int        label = 0;
  const auto parsed = std::from_chars(key.data(), key.data() + key.size(), label);
  if (parsed.ec == std::errc() && parsed.ptr == key.data() + key.size())
  {
    return { label };
  }
  std::vector<int> labels;
  for (const auto & entry : names.table)
  {
    if (entry.second.name == key)
    {
      labels.push_back(entry.first);
    }
  }
  return labels;
}
} // namespace

std::map<int, double>
ReadConductivity(const std::string & fileName, const LabelNames & names, const std::set<int> & meshed)
{
  std::map<int, double> conductivity;
  for (const Record & record : ReadRecords(fileName))
  {
    if (!(record.value > 0.0) || !std::isfinite(record.value))
    {
      std::ostringstream message;
      message << fileName << ": " << record.place << " has a conductivity of " << record.value
              << " S/m; it has to be above 0 (air: 1e-15)";
      throw Error(message.str());
    }
    const auto labels = LabelsOf(record.key, names);
    if (labels.empty())
    {
      Warn(fileName + ": " + record.place + " is of no label, as none is called '" + record.key + '\'' +
           (names.table.empty() ? "; --names FILE has names" : ""));
    }
    for (const int label : labels)
    {
      const auto [place, isNew] = conductivity.insert({ label, record.value });
      if (!isNew && place->second != record.value)
      {
        throw Error(fileName + ": " + record.place + " gives " + names.Describe(label) + " another conductivity");
      }
    }
  }
  std::string missing;
  for (const int label : meshed)
  {
    if (conductivity.count(label) == 0)
    {
      missing += (missing.empty() ? "" : ", ") + names.Describe(label);
    }
  }
  if (!missing.empty())
  {
    throw Error(fileName + ": there is no conductivity of " + missing);
  }
  return conductivity;
}
} // namespace cli
