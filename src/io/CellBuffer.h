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
#ifndef mmmCellBuffer_h
#define mmmCellBuffer_h

#include "io/ComponentType.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace mmm
{
/** Calls body() and throws what is wrong with a cell with the number of the cell in front. */
template <typename TBody>
void
NameCell(std::size_t cell, TBody && body)
{
  try
  {
    body();
  }
  catch (const MeshFileError & error)
  {
    throw MeshFileError("its cell " + std::to_string(cell) + ' ' + error.what());
  }
}

/** Calls visit(ITK's type, points) for each cell of a buffer as itk::MeshIOBase passes it: type, number of points,
 * point identifiers, type, ... Negative identifiers become large ones. */
template <typename TVisitor>
void
VisitCells(const void *         buffer,
           itk::IOComponentEnum type,
           std::size_t          bufferSize,
           std::size_t          numberOfCells,
           TVisitor &&          visit)
{
  VisitComponentType(type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (std::is_integral_v<T>)
    {
      const T *                  values = static_cast<const T *>(buffer);
      const T * const            end = values + bufferSize;
      std::vector<std::uint64_t> points;
      for (std::size_t cell = 0; cell < numberOfCells; ++cell)
      {
        NameCell(cell, [&] {
          if (end - values < 2 || static_cast<std::size_t>(values[1]) > static_cast<std::size_t>(end - values - 2))
          {
            throw MeshFileError("is not complete in its cell buffer");
          }
          points.assign(values + 2, values + 2 + static_cast<std::size_t>(values[1]));
          visit(static_cast<std::int64_t>(values[0]), points);
          values += 2 + points.size();
        });
      }
      if (values != end)
      {
        throw MeshFileError("its cell buffer has more than its cells");
      }
    }
    else
    {
      throw MeshFileError("its cells have point identifiers that are not integers");
    }
  });
}
} // namespace mmm

#endif
