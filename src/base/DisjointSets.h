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
#ifndef mmmDisjointSets_h
#define mmmDisjointSets_h

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mmm
{
/** \brief Elements 0 to n - 1 that threads may unite at the same time, without locks.
 *
 * The smallest element stands for its set, so that the result depends neither on the order of the calls nor on the
 * number of threads. */
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : m_Parents(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      m_Parents[i].store(std::uint32_t(i), std::memory_order_relaxed);
    }
  }

  std::size_t
  size() const
  {
    return m_Parents.size();
  }

  std::uint32_t
  Find(std::uint32_t element)
  {
    std::uint32_t parent = m_Parents[element].load(std::memory_order_relaxed);
    while (parent != element)
    {
      // a failed exchange only means that another thread has shortened the path
      const std::uint32_t grandparent = m_Parents[parent].load(std::memory_order_relaxed);
      m_Parents[element].compare_exchange_weak(parent, grandparent, std::memory_order_relaxed);
      element = grandparent;
      parent = m_Parents[element].load(std::memory_order_relaxed);
    }
    return element;
  }

  void
  Unite(std::uint32_t a, std::uint32_t b)
  {
    while (true)
    {
      a = this->Find(a);
      b = this->Find(b);
      if (a == b)
      {
        return;
      }
      if (a < b)
      {
        std::swap(a, b);
      }
      std::uint32_t expected = a;
      if (m_Parents[a].compare_exchange_strong(expected, b, std::memory_order_relaxed))
      {
        return;
      }
    }
  }

private:
  std::vector<std::atomic<std::uint32_t>> m_Parents;
};
} // namespace mmm

#endif
