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
#ifndef mmmTestDamage_h
#define mmmTestDamage_h

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

/** Damaged files, for tests of all that reads files. */
namespace mmmtest
{
/** The file with one to three places damaged: bits, bytes, numbers, parts that are missing or there twice. */
inline std::string
DamageAtRandom(std::string file, std::mt19937 & random)
{
  static const std::vector<std::string>   numbers{ "0",
                                                 "-1",
                                                 "7",
                                                 "1000000",
                                                 "4294967295",
                                                 "12884901888",
                                                 "1152921504606846976",
                                                 "9223372036854775807",
                                                 "18446744073709551616",
                                                 "1e300",
                                                 "nan" };
  static const std::vector<std::uint64_t> words{ 0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 1ull << 60, ~0ull };
  for (std::size_t places = 1 + random() % 3; places > 0 && !file.empty(); --places)
  {
    const std::size_t place = random() % file.size();
    const std::size_t length = std::min<std::size_t>(1 + random() % 24, file.size() - place);
    switch (random() % 8)
    {
      case 0:
        file[place] = static_cast<char>(random());
        break;
      case 1:
      {
        const auto        word = words[random() % words.size()];
        const std::size_t bytes = std::min<std::size_t>(random() % 2 ? 4 : 8, file.size() - place);
        std::copy_n(reinterpret_cast<const char *>(&word), bytes, file.begin() + place);
        break;
      }
      case 2:
      {
        const char * const digits = "0123456789";
        const auto         first = std::min(file.find_first_of(digits, place), file.size());
        const auto         past = std::min(file.find_first_not_of(digits, first), file.size());
        file.replace(first, past - first, numbers[random() % numbers.size()]);
        break;
      }
      case 3:
        file.erase(place, length);
        break;
      case 4:
        file.insert(random() % file.size(), file.substr(place, length));
        break;
      case 5:
        file.resize(random() % 4 ? file.size() : place);
        break;
      default:
        file[place] ^= static_cast<char>(1 << (random() % 8));
    }
  }
  return file;
}

/** Damages files, each several times, and asks isRejected(damaged) for each. Anything but an ExceptionObject fails the
 * test. The environment variable MMM_TEST_MUTATIONS gives another number of trials, of all files together. Returns how
 * many were rejected, and how many there were. */
template <typename TFunction>
std::pair<std::size_t, std::size_t>
CountRejected(const std::vector<std::string> & files, std::size_t trials, const TFunction & isRejected)
{
  const char * const given = std::getenv("MMM_TEST_MUTATIONS");
  const std::size_t  all = given ? std::stoul(given) : trials * files.size();
  std::mt19937       random(20240607);
  std::size_t        rejected = 0;
  for (std::size_t trial = 0; trial < all; ++trial)
  {
    rejected += isRejected(DamageAtRandom(files[trial % files.size()], random)) ? 1 : 0;
  }
  return { rejected, all };
}
} // namespace mmmtest

#endif
