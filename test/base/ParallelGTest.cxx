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
#include "base/Parallel.h"

#include "itkMultiThreaderBase.h"
#include "itkProcessObject.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace
{
class IdleFilter : public itk::ProcessObject
{
public:
  using Self = IdleFilter;
  using Superclass = itk::ProcessObject;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);
};
} // namespace

TEST(ParallelFor, CoversEveryIndexOnce)
{
  std::vector<int> visits(1000, 0);
  mmm::ParallelFor(visits.size(), 7, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      ++visits[n];
    }
  });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));
}

TEST(ParallelFor, RethrowsTheExceptionOfTheLowestRange)
{
  for (int attempt = 0; attempt < 20; ++attempt)
  {
    try
    {
      mmm::ParallelFor(100, 1, [](std::size_t begin, std::size_t) {
        if (begin >= 3)
        {
          throw std::runtime_error(std::to_string(begin));
        }
      });
      FAIL() << "no exception";
    }
    catch (const std::runtime_error & error)
    {
      EXPECT_STREQ(error.what(), "3");
    }
  }
}

TEST(ThreaderScope, KeepsWorkOnOneThreadForOneWorkUnit)
{
  const auto filter = IdleFilter::New();
  filter->SetNumberOfWorkUnits(1);
  const mmm::ThreaderScope     scope(filter);
  std::vector<std::thread::id> threads(64);
  mmm::ParallelFor(threads.size(), 1, [&](std::size_t begin, std::size_t) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    threads[begin] = std::this_thread::get_id();
  });
  EXPECT_EQ(threads, std::vector<std::thread::id>(64, threads[0]));
}
