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
#include "console/Errors.h"

#include "itkMacro.h"

#include <new>
#include <regex>

namespace cli
{
std::string
ToOneLine(const std::string & text)
{
  // "itk::ERROR: Class(0x1234): " and "WARNING: In file.cxx, line 5\nClass (0x1234): "
  static const std::regex decoration("(itk::|ITK )(ERROR|WARNING): *([A-Za-z0-9_:<>]+\\([^() ]*\\): *)?|"
                                     "WARNING: In [^\\n]*, line [0-9]+\\s+([A-Za-z0-9_:<>]+ \\([^() ]*\\): )?");
  static const std::regex space("\\s+");
  std::string             line = std::regex_replace(text, decoration, "");
  line = std::regex_replace(line, space, " ");
  const auto first = line.find_first_not_of(' ');
  const auto last = line.find_last_not_of(" .");
  return first == std::string::npos || last == std::string::npos ? "unknown" : line.substr(first, last - first + 1);
}

std::string
DescribeCurrentException()
{
  const std::string outOfMemory = "not enough memory; an image of fewer voxels, or a part of it, needs less";
  try
  {
    throw;
  }
  catch (const std::bad_alloc &)
  {
    return outOfMemory;
  }
  catch (const itk::MemoryAllocationError &)
  {
    return outOfMemory;
  }
  catch (const itk::ExceptionObject & exception)
  {
    // what() would add source file and line.
    return ToOneLine(exception.GetDescription());
  }
  catch (const std::exception & exception)
  {
    return ToOneLine(exception.what());
  }
  catch (...)
  {
    return "unknown exception";
  }
}
} // namespace cli
