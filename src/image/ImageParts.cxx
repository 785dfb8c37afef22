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
#include "image/ImageParts.h"

#include "base/DisjointSets.h"
#include "base/Parallel.h"

namespace mmm
{
ImageParts
FindImageParts(const MaterialImage & image)
{
  const Grid &      grid = image.grid;
  const auto &      materials = image.materials;
  DisjointSets      sets(materials.size());
  const std::size_t row = grid.size[0];
  const std::size_t layer = row * grid.size[1];
  ParallelFor(grid.size[2], 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin * layer; n < end * layer; ++n)
    {
      if (n % row > 0 && materials[n - 1] == materials[n])
      {
        sets.Unite(std::uint32_t(n - 1), std::uint32_t(n));
      }
      if (n % layer >= row && materials[n - row] == materials[n])
      {
        sets.Unite(std::uint32_t(n - row), std::uint32_t(n));
      }
      if (n >= layer && materials[n - layer] == materials[n])
      {
        sets.Unite(std::uint32_t(n - layer), std::uint32_t(n));
      }
    }
  });

  ImageParts result;
  result.numbers.resize(materials.size());
  for (std::size_t n = 0; n < materials.size(); ++n)
  {
    // the first voxel stands for its part
    const std::size_t first = sets.Find(std::uint32_t(n));
    if (first == n)
    {
      result.numbers[n] = std::uint32_t(result.parts.size());
      result.parts.push_back({ materials[n], 0 });
    }
    else
    {
      result.numbers[n] = result.numbers[first];
    }
    ++result.parts[result.numbers[n]].voxels;
  }
  return result;
}
} // namespace mmm
