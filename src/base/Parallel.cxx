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

#include <algorithm>
#include <exception>
#include <mutex>

namespace mmm
{
namespace
{
thread_local itk::MultiThreaderBase * currentThreader = nullptr;
}

ThreaderScope::ThreaderScope(const itk::ProcessObject * filter)
  : m_Previous(currentThreader)
{
  currentThreader = filter->GetMultiThreader();
  currentThreader->SetNumberOfWorkUnits(filter->GetNumberOfWorkUnits());
}

ThreaderScope::~ThreaderScope() { currentThreader = m_Previous; }

void
ParallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)> & body)
{
  const std::size_t ranges = (count + grain - 1) / grain;
  if (ranges <= 1)
  {
    if (count > 0)
    {
      body(0, count);
    }
    return;
  }
  // ITK's threader of TBB takes all its threads, however few work units it is to make.
  if (currentThreader != nullptr && currentThreader->GetNumberOfWorkUnits() == 1)
  {
    for (std::size_t range = 0; range < ranges; ++range)
    {
      body(range * grain, std::min(count, (range + 1) * grain));
    }
    return;
  }
  std::exception_ptr                    failure;
  itk::SizeValueType                    failedRange = ranges;
  std::mutex                            mutex;
  const itk::MultiThreaderBase::Pointer threader =
    currentThreader ? currentThreader : itk::MultiThreaderBase::New().GetPointer();
  threader->ParallelizeArray(
    0,
    ranges,
    [&](itk::SizeValueType range) {
      try
      {
        body(range * grain, std::min(count, (range + 1) * grain));
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if (range < failedRange)
        {
          failedRange = range;
          failure = std::current_exception();
        }
      }
    },
    nullptr);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
} // namespace mmm
