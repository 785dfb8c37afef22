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
#ifndef mmmTestSeeds_h
#define mmmTestSeeds_h

#include <cstdlib>
#include <sstream>
#include <vector>

/** Seeds of tests on what is random. */
namespace mmmtest
{
/** Whether test/fuzz.sh has chosen them, in the environment variable MMM_TEST_SEEDS, "FIRST LAST". */
inline bool
AreSeedsGiven()
{
  return std::getenv("MMM_TEST_SEEDS") != nullptr;
}

/** Those that are given, or 0 to count - 1. */
inline std::vector<int>
Seeds(int count)
{
  int first = 0;
  int last = count - 1;
  if (AreSeedsGiven())
  {
    std::istringstream(std::getenv("MMM_TEST_SEEDS")) >> first >> last;
  }
  std::vector<int> seeds;
  for (int seed = first; seed <= last; ++seed)
  {
    seeds.push_back(seed);
  }
  return seeds;
}
} // namespace mmmtest

#endif
