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
#ifndef mmmHTML_h
#define mmmHTML_h

#include <cstddef>
#include <string>
#include <vector>

namespace mmm
{
/** What a page is put together of: HTML that is also well-formed XML. Numbers do not depend on the locale. */

/** Text for use in an element or an attribute. What is no UTF-8, or a character that XML does not have, is replaced. */
std::string
EscapedHTML(const std::string & text);

/** A number for people, with this many decimals, and for programs as it is; a dash if it is not finite. */
std::string
NumberHTML(double value, int decimals);

/** The same with a sign, for differences. */
std::string
SignedHTML(double value, int decimals);

/** A whole number for people, in groups of three digits, and for programs. */
std::string
CountHTML(std::size_t count);

/** "12.30", without HTML. */
std::string
Decimal(double value, int decimals);

/** \brief A table with a caption and a line of headers. */
class HTMLTable
{
public:
  /** A column of numbers, which stand on the right, or of other things. The name is HTML. */
  struct Column
  {
    std::string name;
    bool        isNumber{ true };
  };

  /** The caption is text. */
  HTMLTable(const std::string & caption, std::vector<Column> columns);

  /** A cell for each column, as HTML. The first one is the header of the row. */
  void
  AddRow(const std::vector<std::string> & cells);

  std::size_t
  CountRows() const
  {
    return m_RowCount;
  }

  std::string
  ToText() const;

private:
  std::string         m_Head;
  std::vector<Column> m_Columns;
  std::string         m_Rows;
  std::size_t         m_RowCount{ 0 };
};

/** A part of the page with a heading, which is text; the content is HTML. */
std::string
SectionHTML(const std::string & id, const std::string & heading, const std::string & content);

/** What is shown on demand. The summary is text; the content is HTML. */
std::string
DetailsHTML(const std::string & summary, const std::string & content);

/** A paragraph of text. */
std::string
ParagraphHTML(const std::string & text);
} // namespace mmm

#endif
