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
#include "base/PeakMemory.h"

#include <cstdlib>
#include <fstream>
#include <string>

#if defined(_WIN32)
#  ifndef NOMINMAX
#    define NOMINMAX
#  endif
#  include <windows.h>
#  include <psapi.h>
#elif defined(__unix__) || defined(__APPLE__)
#  include <sys/resource.h>
#endif

namespace mmm
{
double
PeakMemory()
{
#if defined(_WIN32)
  PROCESS_MEMORY_COUNTERS counters;
  return K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof(counters))
           ? static_cast<double>(counters.PeakWorkingSetSize) / (1024.0 * 1024.0)
           : 0.0;
#elif defined(__unix__) || defined(__APPLE__)
#  if defined(__linux__)
  // The other count begins with what the process had been before it started this program.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind("VmHWM:", 0) == 0)
    {
      return std::strtod(line.c_str() + 6, nullptr) / 1024.0; // kilobytes
    }
  }
#  endif
  rusage usage;
  if (getrusage(RUSAGE_SELF, &usage) != 0)
  {
    return 0.0;
  }
#  if defined(__APPLE__)
  constexpr double unitsPerMegabyte = 1024.0 * 1024.0; // bytes
#  else
  constexpr double unitsPerMegabyte = 1024.0; // kilobytes
#  endif
  return static_cast<double>(usage.ru_maxrss) / unitsPerMegabyte;
#else
  return 0.0;
#endif
}
} // namespace mmm
