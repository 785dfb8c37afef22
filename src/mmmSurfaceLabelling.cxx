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
#include "mmmSurfaceLabelling.h"

#include "mmmParallel.h"
#include "mmmTetrahedronSupport.h"

namespace mmm
{
std::vector<Material>
LabelTetrahedra(const IndicatorSet &             indicators,
                const ParticleSet &              particles,
                const std::vector<Tetrahedron> & tetrahedra,
                Material                         exterior)
{
  std::vector<Material> materials(tetrahedra.size());
  ParallelFor(tetrahedra.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
    {
      const auto & corners = tetrahedra[t];
      Material     candidates[Cell::Capacity] = {};
      int          count = 0;
      for (const Material m : particles.CellOf(corners[0]))
      {
        if (particles.CellOf(corners[1]).Has(m) && particles.CellOf(corners[2]).Has(m) &&
            particles.CellOf(corners[3]).Has(m))
        {
          candidates[count++] = m;
        }
      }
      Material best = candidates[0];
      if (count != 1)
      {
        const TetrahedronSupport support(indicators,
                                         particles.positions[corners[0]],
                                         particles.positions[corners[1]],
                                         particles.positions[corners[2]],
                                         particles.positions[corners[3]]);
        const auto               nearby = indicators.Candidates(support.Centre());
        const auto               first = count > 0 ? static_cast<const Material *>(candidates) : nearby.first;
        const auto               last = count > 0 ? candidates + count : nearby.second;
        double                   largest = -1e300;
        for (auto m = first; m != last; ++m)
        {
          const double value = support.Of(*m);
          if (value > largest)
          {
            largest = value;
            best = *m;
          }
        }
      }
      materials[t] = indicators.IsPlane(best) ? exterior : best;
    }
  });
  return materials;
}

} // namespace mmm
