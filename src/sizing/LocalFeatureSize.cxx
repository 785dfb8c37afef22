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
#include "sizing/LocalFeatureSize.h"

#include "base/Parallel.h"
#include "sizing/SourcePropagation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 4096;
}

std::vector<float>
ComputeLocalFeatureSizes(const Grid &                         grid,
                         const std::vector<InterfaceSample> & samples,
                         const std::vector<Vector> &          axis)
{
  std::vector<Source> sources;
  sources.reserve(axis.size());
  for (const auto & point : axis)
  {
    sources.push_back({ point.cast<float>(), 0.0f });
  }
  const PropagatedField distance = PropagateSources(grid, sources, 1.0);
  std::vector<float>    sizes(samples.size(), std::numeric_limits<float>::infinity());
  ParallelFor(samples.size(), Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
    {
      // the nearest axis point is what one of the nodes around the sample found nearest
      const Vector & x = samples[s].position;
      for (int corner = 0; corner < 8; ++corner)
      {
        Index at;
        for (int a = 0; a < 3; ++a)
        {
          at[a] = int(std::floor(x[a] / grid.spacing[a])) + ((corner >> a) & 1);
        }
        if (grid.Contains(at) && distance.sources[grid.Offset(at)] != PropagatedField::NoSource)
        {
          const Vector & point = axis[distance.sources[grid.Offset(at)]];
          sizes[s] = std::min(sizes[s], float((point - x).norm()));
        }
      }
    }
  });
  return sizes;
}
} // namespace mmm
