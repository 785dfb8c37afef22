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
#include "console/ProgressDisplay.h"

#include <algorithm>
#include <cstdio>

#ifdef _WIN32
#  include <io.h>
#else
#  include <unistd.h>
#endif

namespace cli
{
namespace
{
constexpr int NameWidth = 38;
constexpr int BarWidth = 20;
const auto    DrawInterval = std::chrono::milliseconds(100);

bool
StdoutIsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stdout)) != 0;
#else
  return isatty(STDOUT_FILENO) != 0;
#endif
}

double
SecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
} // namespace

ProgressDisplay::ProgressDisplay(Style style)
  : m_Style(style)
  , m_IsTerminal(style == Style::Text && StdoutIsTerminal())
{}

ProgressDisplay::~ProgressDisplay()
{
  if (m_IsTerminal && !m_Stage.empty())
  {
    std::printf("\n");
  }
  std::fflush(stdout);
}

void
ProgressDisplay::Show(const std::string & stage, double fraction, double total)
{
  if (m_Style == Style::None || stage.empty())
  {
    return;
  }
  const auto now = Clock::now();
  const bool isNew = stage != m_Stage;
  if (isNew)
  {
    this->Finish();
    m_Stage = stage;
    m_Start = now;
    if (m_Style == Style::Slicer)
    {
      m_Slicer.Begin(stage);
    }
  }
  if (!isNew && now - m_LastDrawn < DrawInterval)
  {
    return;
  }
  m_LastDrawn = now;
  if (m_Style == Style::Slicer)
  {
    m_Slicer.Update(total, fraction);
  }
  else if (m_IsTerminal)
  {
    this->DrawBar(std::min(std::max(fraction, 0.0), 1.0), SecondsSince(m_Start));
  }
}

void
ProgressDisplay::Note(const std::string & text)
{
  if (m_Style == Style::Text)
  {
    this->Finish();
    std::printf("%s\n", text.c_str());
    std::fflush(stdout);
  }
}

void
ProgressDisplay::Finish()
{
  if (m_Stage.empty())
  {
    return;
  }
  const double seconds = SecondsSince(m_Start);
  if (m_Style == Style::Slicer)
  {
    m_Slicer.End(m_Stage, seconds);
  }
  else if (m_IsTerminal)
  {
    this->DrawBar(1.0, seconds);
    std::printf("\n");
  }
  else
  {
    std::printf("%s ... %.1f s\n", m_Stage.c_str(), seconds);
  }
  std::fflush(stdout);
  m_Stage.clear();
}

void
ProgressDisplay::DrawBar(double fraction, double seconds)
{
  const int         done = int(fraction * BarWidth);
  const std::string bar = std::string(done, '#') + std::string(BarWidth - done, '.');
  std::printf(
    "\r%-*.*s [%s] %3d %% %7.1f s", NameWidth, NameWidth, m_Stage.c_str(), bar.c_str(), int(fraction * 100.0), seconds);
  std::fflush(stdout);
}
} // namespace cli
