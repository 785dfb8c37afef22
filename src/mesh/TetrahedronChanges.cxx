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
#include "mesh/TetrahedronChanges.h"

#include <algorithm>
#include <iterator>

namespace mmm
{
std::optional<std::vector<Tetrahedron>>
TetrahedronChanges::Next(const std::vector<Vector> & points, const TetrahedralMesh & mesh)
{
  std::vector<Key> keys(mesh.tetrahedra.size());
  for (std::size_t t = 0; t < keys.size(); ++t)
  {
    std::copy_n(mesh.tetrahedra[t].begin(), 4, keys[t].begin());
    std::sort(keys[t].begin(), keys[t].begin() + 4);
    keys[t][4] = mesh.materials[t];
  }
  std::sort(keys.begin(), keys.end());

  std::optional<std::vector<Tetrahedron>> changes;
  if (!m_Points.empty() && points.size() >= m_Points.size() &&
      std::equal(m_Points.begin(), m_Points.end(), points.begin()))
  {
    std::vector<Key> changed;
    std::set_symmetric_difference(m_Keys.begin(), m_Keys.end(), keys.begin(), keys.end(), std::back_inserter(changed));
    changes.emplace();
    for (const Key & key : changed)
    {
      changes->push_back({ { key[0], key[1], key[2], key[3] } });
    }
  }
  m_Points = points;
  m_Keys.swap(keys);
  return changes;
}
} // namespace mmm
