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
#include "input/LabelTableText.h"

#include "base/Trimmed.h"
#include "input/GzipFile.h"
#include "input/LabelTableJson.h"

#include "itkMacro.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace mmm
{
namespace
{
using Color = LabelTableSource::Color;
using Words = std::vector<std::string>;

Words
WordsOf(const std::string & text)
{
  std::istringstream stream(text);
  Words              words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

/** The three numbers from 0 to 255 that a list has from `first` on. */
Color
ParseBytes(const LabelTableSource & source, const Words & words, std::size_t first)
{
  Color color;
  for (std::size_t c = 0; c < 3; ++c)
  {
    int value = -1;
    if (first + c >= words.size() || !ParseLabel(words[first + c], value) || value < 0 || value > HighestByte)
    {
      source.Fail("has a color that is not three whole numbers from 0 to 255");
    }
    color[c] = value / HighestByte;
  }
  return color;
}

/** `3 205 62 78 1 1 1 "gray matter"` */
void
ParseSnapLine(LabelTableSource & source, const std::string & line, std::size_t quote)
{
  const Words words = WordsOf(line.substr(0, quote));
  const auto  last = line.rfind('"');
  int         label = 0;
  if (words.size() != 7 || !ParseLabel(words[0], label) || last == quote)
  {
    source.Fail("is not LABEL R G B A VISIBLE MESH \"NAME\", as ITK-SNAP has it");
  }
  source.Add(label, { line.substr(quote + 1, last - quote - 1), ParseBytes(source, words, 1) });
}

/** `3 gray-matter 205 62 78 0`, or without the color, or with blanks in the name. */
void
ParsePlainLine(LabelTableSource & source, const std::string & line, bool hasUnderscores)
{
  const Words words = WordsOf(line);
  int         label = 0;
  if (words.size() < 2 || !ParseLabel(words[0], label))
  {
    source.Fail("is not LABEL NAME, or LABEL NAME R G B A");
  }
  int         ignored = 0;
  std::size_t end = words.size();
  while (end > 2 && words.size() - end < 4 && ParseLabel(words[end - 1], ignored))
  {
    --end;
  }
  // one or two numbers belong to a name: "layer 2"
  end = words.size() - end < 3 ? words.size() : end;
  LabelEntry entry;
  for (std::size_t w = 1; w < end; ++w)
  {
    entry.name += (w == 1 ? "" : " ") + words[w];
  }
  if (end < words.size())
  {
    entry.color = ParseBytes(source, words, end);
  }
  if (hasUnderscores)
  {
    std::replace(entry.name.begin(), entry.name.end(), '_', ' ');
  }
  source.Add(label, entry);
}

Words
Columns(const std::string & line)
{
  Words              columns;
  std::istringstream stream(line);
  for (std::string column; std::getline(stream, column, '\t');)
  {
    column = Trimmed(column);
    columns.push_back(column == "n/a" ? "" : column);
  }
  return columns;
}

/** Which columns of a table have what. */
struct Head
{
  explicit Head(const std::string & line)
  {
    const Words names = Columns(line);
    size = names.size();
    const auto find = [&](const char * name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    index = find("index");
    name = find("name");
    color = find("color");
  }

  bool
  IsThere() const
  {
    return index < size;
  }

  std::size_t size;
  std::size_t index;
  std::size_t name;
  std::size_t color;
};

void
ParseRow(LabelTableSource & source, const Head & head, const std::string & line)
{
  const Words columns = Columns(line);
  int         label = 0;
  if (head.name >= head.size)
  {
    source.line = 1;
    source.Fail("has no column 'name' beside 'index'");
  }
  if (columns.size() <= std::max(head.index, head.name) || !ParseLabel(columns[head.index], label))
  {
    source.Fail("has no whole number in the column 'index', or no 'name'");
  }
  LabelEntry entry{ columns[head.name], {} };
  if (head.color < columns.size() && !columns[head.color].empty())
  {
    entry.color = source.ParseHexadecimal(columns[head.color]);
  }
  source.Add(label, entry);
}

void
ParseLines(LabelTableSource & source, const std::string & text)
{
  const bool         isOfSlicer = HasExtension(source.fileName, { ".ctbl" });
  std::istringstream stream(text);
  Head               head("");
  for (std::string line; std::getline(stream, line);)
  {
    ++source.line;
    line.erase(line.find_last_not_of(" \r\n\t") + 1);
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#')
    {
      continue;
    }
    const auto quote = line.find('"');
    if (head.IsThere())
    {
      ParseRow(source, head, line);
    }
    else if (source.table.empty() && Head(line).IsThere())
    {
      head = Head(line);
    }
    else if (quote != std::string::npos)
    {
      ParseSnapLine(source, line, quote);
    }
    else
    {
      ParsePlainLine(source, line, isOfSlicer);
    }
  }
}

} // namespace

LabelTable
ParseLabelTable(const std::string & fileName, const std::string & text)
{
  const std::string mark = "\xef\xbb\xbf";
  const auto        begin = text.compare(0, mark.size(), mark) == 0 ? mark.size() : std::size_t{ 0 };
  const auto        first = text.find_first_not_of(" \t\r\n", begin);
  LabelTableSource  source{ fileName, 0, {} };
  if (first != std::string::npos && text[first] == '{')
  {
    const JsonValue         value = ParseJson(fileName, text.substr(begin));
    const JsonValue * const map = FindLabelMap(value);
    AddLabels(source, map != nullptr ? *map : value);
  }
  else
  {
    ParseLines(source, text.substr(begin));
  }
  if (source.table.empty())
  {
    itkGenericExceptionMacro(<< fileName << ": the file names no label");
  }
  return source.table;
}

bool
HasLabelMap(const std::string & fileName, const std::string & text)
{
  return FindLabelMap(ParseJson(fileName, text)) != nullptr;
}
} // namespace mmm
