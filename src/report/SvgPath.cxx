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
#include "report/SvgPath.h"

namespace mmm
{
namespace
{
/** Whether both go along the same axis to the same side. */
bool
GoOn(const SvgPoint & step, const SvgPoint & next)
{
  return (step[0] == 0 && next[0] == 0 && (step[1] > 0) == (next[1] > 0)) ||
         (step[1] == 0 && next[1] == 0 && (step[0] > 0) == (next[0] > 0));
}
} // namespace

void
SvgPath::MoveTo(const SvgPoint & point)
{
  this->Flush();
  m_Start = point;
  m_IsToMove = true;
}

void
SvgPath::LineTo(const SvgPoint & point)
{
  if (m_IsToMove)
  {
    if (point == m_Start)
    {
      return;
    }
    this->Write('m', { { m_Start[0] - m_Place[0], m_Start[1] - m_Place[1] } });
    m_Place = m_Start;
    m_IsToMove = false;
  }
  const SvgPoint end{ { m_Place[0] + m_Step[0], m_Place[1] + m_Step[1] } };
  const SvgPoint step{ { point[0] - end[0], point[1] - end[1] } };
  if (step[0] == 0 && step[1] == 0)
  {
    return;
  }
  if ((m_Step[0] != 0 || m_Step[1] != 0) && GoOn(m_Step, step))
  {
    m_Step = { { m_Step[0] + step[0], m_Step[1] + step[1] } };
    return;
  }
  this->Flush();
  m_Step = step;
}

void
SvgPath::Close()
{
  if (m_IsToMove)
  {
    return;
  }
  this->Flush();
  m_Text += 'z';
  m_Command = 'z';
  m_Place = m_Start;
}

const std::string &
SvgPath::GetText()
{
  this->Flush();
  return m_Text;
}

void
SvgPath::Flush()
{
  if (m_Step[0] != 0 || m_Step[1] != 0)
  {
    this->Write(m_Step[1] == 0 ? 'h' : m_Step[0] == 0 ? 'v' : 'l', m_Step);
    m_Place = { { m_Place[0] + m_Step[0], m_Place[1] + m_Step[1] } };
    m_Step = { { 0, 0 } };
  }
}

void
SvgPath::Write(char command, const SvgPoint & difference)
{
  if (command != m_Command || command == 'm')
  {
    m_Text += command;
  }
  if (command != 'v')
  {
    this->WriteNumber(difference[0]);
  }
  if (command != 'h')
  {
    this->WriteNumber(difference[1]);
  }
  // what follows a move without command is a line
  m_Command = command == 'm' ? 'l' : command;
}

void
SvgPath::WriteNumber(long number)
{
  const char last = m_Text.back();
  if (last >= '0' && last <= '9' && number >= 0)
  {
    m_Text += ' ';
  }
  m_Text += std::to_string(number);
}
} // namespace mmm
