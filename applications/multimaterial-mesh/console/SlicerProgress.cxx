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
#include "console/SlicerProgress.h"

#include <algorithm>
#include <iostream>
#include <locale>
#include <sstream>

namespace cli
{
namespace
{
std::string
ToText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << std::fixed << value;
  return text.str();
}
} // namespace

void
SlicerProgress::Begin(const std::string & stage)
{
  // Slicer removes a <filter-start> from what it shows as output only if the element has nothing but these two.
  std::cout << "<filter-start>\n<filter-name>" << stage << "</filter-name>\n<filter-comment>" << stage
            << "</filter-comment>\n</filter-start>" << std::endl;
}

void
SlicerProgress::Update(double total, double ofStage)
{
  m_Total = std::max(m_Total, std::min(total, 1.0));
  std::cout << "<filter-progress>" << ToText(m_Total) << "</filter-progress>\n<filter-stage-progress>"
            << ToText(std::min(std::max(ofStage, 0.0), 1.0)) << "</filter-stage-progress>" << std::endl;
}

void
SlicerProgress::End(const std::string & stage, double seconds)
{
  std::cout << "<filter-end>\n<filter-name>" << stage << "</filter-name>\n<filter-time>" << ToText(seconds)
            << "</filter-time>\n</filter-end>" << std::endl;
}
} // namespace cli
