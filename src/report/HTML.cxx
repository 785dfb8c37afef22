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
#include "report/HTML.h"

#include "base/EscapedXML.h"
#include "report/UTF8.h"

#include "itkNumberToString.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace mmm
{
namespace
{
/** <data value="1234.5">1234.5</data>: the one for programs, the other for people. */
std::string
DataHTML(const std::string & value, const std::string & text)
{
  return "<data value=\"" + value + "\">" + text + "</data>";
}

const char * const Dash = "\xE2\x80\x93";
const char * const Minus = "\xE2\x88\x92";
const char * const ThinSpace = "\xE2\x80\xAF";

/** With a true minus. */
std::string
ForPeople(double value, int decimals)
{
  const std::string text = Decimal(std::abs(value), decimals);
  const bool        isZero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !isZero ? Minus : "") + text;
}
} // namespace

std::string
EscapedHTML(const std::string & text)
{
  std::string printable = ToUTF8(text);
  for (char & c : printable)
  {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n')
    {
      c = ' ';
    }
  }
  return EscapedXML(printable);
}

std::string
Decimal(double value, int decimals)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string
NumberHTML(double value, int decimals)
{
  return std::isfinite(value) ? DataHTML(itk::NumberToString<double>()(value), ForPeople(value, decimals)) : Dash;
}

std::string
SignedHTML(double value, int decimals)
{
  if (!std::isfinite(value))
  {
    return Dash;
  }
  const std::string text = ForPeople(value, decimals);
  return DataHTML(itk::NumberToString<double>()(value), (value > 0.0 ? "+" : "") + text);
}

std::string
CountHTML(std::size_t count)
{
  const std::string digits = std::to_string(count);
  std::string       grouped;
  for (std::size_t d = 0; d < digits.size(); ++d)
  {
    grouped += d > 0 && (digits.size() - d) % 3 == 0 ? ThinSpace : "";
    grouped += digits[d];
  }
  return DataHTML(digits, grouped);
}

HTMLTable::HTMLTable(const std::string & caption, std::vector<Column> columns)
  : m_Columns(std::move(columns))
{
  m_Head = "<caption>" + EscapedHTML(caption) + "</caption>\n<thead><tr>";
  for (const Column & column : m_Columns)
  {
    m_Head += std::string("<th scope=\"col\"") + (column.isNumber ? " class=\"n\"" : "") + '>' + column.name + "</th>";
  }
  m_Head += "</tr></thead>\n";
}

void
HTMLTable::AddRow(const std::vector<std::string> & cells)
{
  m_Rows += "<tr>";
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const std::string name = c == 0 ? "th" : "td";
    m_Rows += '<' + name + (c == 0 ? " scope=\"row\"" : "") + (m_Columns[c].isNumber ? " class=\"n\">" : ">") +
              cells[c] + "</" + name + '>';
  }
  m_Rows += "</tr>\n";
  ++m_RowCount;
}

std::string
HTMLTable::ToText() const
{
  return "<div class=\"wide\"><table>" + m_Head + "<tbody>\n" + m_Rows + "</tbody></table></div>\n";
}

std::string
SectionHTML(const std::string & id, const std::string & heading, const std::string & content)
{
  return "<section id=\"" + id + "\" aria-labelledby=\"" + id + "-heading\">\n<h2 id=\"" + id + "-heading\">" +
         EscapedHTML(heading) + "</h2>\n" + content + "</section>\n";
}

std::string
DetailsHTML(const std::string & summary, const std::string & content)
{
  return "<details><summary>" + EscapedHTML(summary) + "</summary>\n" + content + "</details>\n";
}

std::string
ParagraphHTML(const std::string & text)
{
  return "<p>" + EscapedHTML(text) + "</p>\n";
}
} // namespace mmm
