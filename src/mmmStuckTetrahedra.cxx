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
#include "mmmStuckTetrahedra.h"

#include "mmmLinkInspector.h"
#include "mmmParallel.h"

#include <algorithm>

namespace mmm
{
namespace
{
constexpr std::size_t Grain = 1024;

class TetrahedronTurner
{
public:
  TetrahedronTurner(const IndicatorSet &         indicators,
                    const std::vector<Vector> &  points,
                    const TetrahedronAdjacency & adjacency,
                    Material                     exterior,
                    TetrahedralMesh &            mesh)
    : m_Mesh(mesh)
    , m_Exterior(exterior)
    , m_Wanted(mesh.materials)
    , m_Neighbours(adjacency.neighbours)
    , m_Inspector(mesh, adjacency, exterior)
  {
    ParallelFor(m_Wanted.size(), Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        const auto &   c = mesh.tetrahedra[t];
        const Vector   centre = 0.25 * (points[c[0]] + points[c[1]] + points[c[2]] + points[c[3]]);
        const Material material = indicators.MaterialAt(centre);
        m_Wanted[t] = indicators.IsPlane(material) ? exterior : material;
      }
    });
  }

  std::vector<std::uint32_t>
  Run()
  {
    std::vector<std::uint32_t> left;
    for (std::uint32_t t = 0; t < m_Wanted.size(); ++t)
    {
      if (m_Wanted[t] != m_Mesh.materials[t])
      {
        left.push_back(t);
      }
    }
    std::size_t before = 0;
    do
    {
      before = left.size();
      left.erase(std::remove_if(left.begin(), left.end(), [this](std::uint32_t t) { return this->Turn(t); }),
                 left.end());
    } while (left.size() < before);
    return left;
  }

private:
  /** Gives a tetrahedron the material that is wanted, unless that changes the topology. */
  bool
  Turn(std::uint32_t t)
  {
    const Material own = m_Mesh.materials[t];
    if (!this->HasNeighbour(t, own) || !this->HasNeighbour(t, m_Wanted[t]))
    {
      return false;
    }
    const auto before = m_Inspector.CountDefectsAt(m_Mesh.tetrahedra[t]);
    m_Mesh.materials[t] = m_Wanted[t];
    if (m_Inspector.CountDefectsAt(m_Mesh.tetrahedra[t]) > before)
    {
      m_Mesh.materials[t] = own;
      return false;
    }
    return true;
  }

  bool
  HasNeighbour(std::uint32_t t, Material material) const
  {
    return std::any_of(m_Neighbours[t].begin(), m_Neighbours[t].end(), [&](std::uint32_t other) {
      return (other == NoTetrahedron ? m_Exterior : m_Mesh.materials[other]) == material;
    });
  }

  TetrahedralMesh &             m_Mesh;
  const Material                m_Exterior;
  std::vector<Material>         m_Wanted;
  const TetrahedronNeighbours & m_Neighbours;
  LinkInspector                 m_Inspector;
};
} // namespace

std::vector<std::uint32_t>
FindStuckTetrahedra(const IndicatorSet &         indicators,
                    const std::vector<Vector> &  points,
                    const TetrahedronAdjacency & adjacency,
                    Material                     exterior,
                    TetrahedralMesh              mesh)
{
  return TetrahedronTurner(indicators, points, adjacency, exterior, mesh).Run();
}
} // namespace mmm
