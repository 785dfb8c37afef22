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
#ifndef mmmParallel_h
#define mmmParallel_h

#include <cstddef>
#include <functional>

namespace itk
{
class ProcessObject;
class MultiThreaderBase;
} // namespace itk

namespace mmm
{
/** While it lives, parallel work that this thread starts runs on the threads of a filter: its multi-threader and its
 * number of work units. */
class ThreaderScope
{
public:
  explicit ThreaderScope(const itk::ProcessObject * filter);
  ~ThreaderScope();

  ThreaderScope(const ThreaderScope &) = delete;
  ThreaderScope &
  operator=(const ThreaderScope &) = delete;

private:
  itk::MultiThreaderBase * m_Previous;
};

/** Calls body(begin, end) for consecutive ranges of at most `grain` indices that cover [0, count), on the threads of
 * the filter in whose ThreaderScope this is, or else of a new itk::MultiThreaderBase. The ranges do not depend on the
 * number of threads: a body that writes only to slots of its own range gives the same result for any number of them.
 * The exception of the lowest range that has one is rethrown. */
void
ParallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)> & body);
} // namespace mmm

#endif
