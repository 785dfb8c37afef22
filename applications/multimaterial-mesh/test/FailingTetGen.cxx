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
// Stands before the real TetGen where LD_PRELOAD says so. It fails from the call with the number FAIL_AT on, which
// counts from 1; with TIMES in the environment in as many calls. With OUT_OF_MEMORY there is no memory. The number of
// calls goes to the file COUNT.
#include <tetgen.h>

#include <dlfcn.h>

#include <cstdlib>
#include <fstream>
#include <new>

void
tetrahedralize(char * switches, tetgenio * in, tetgenio * out, tetgenio * addin, tetgenio * bgmin)
{
  static int calls = 0;
  ++calls;
  if (const char * const file = std::getenv("COUNT"))
  {
    std::ofstream(file) << calls;
  }
  const char * const failAt = std::getenv("FAIL_AT");
  const int          first = failAt ? std::atoi(failAt) : calls + 1;
  const char * const times = std::getenv("TIMES");
  if (calls >= first && (times == nullptr || calls < first + std::atoi(times)))
  {
    if (std::getenv("OUT_OF_MEMORY"))
    {
      throw std::bad_alloc();
    }
    throw 3;
  }
  using Function = void (*)(char *, tetgenio *, tetgenio *, tetgenio *, tetgenio *);
  // The mangled name of this function.
  const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "_Z14tetrahedralizePcP8tetgenioS1_S1_S1_"));
  next(switches, in, out, addin, bgmin);
}
