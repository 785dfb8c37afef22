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
#include "surface/FlatTetrahedra.h"

#include "surface/LinkInspector.h"
#include "surface/SurfaceParameters.h"
#include "base/ParallelCollect.h"
#include "mesh/TetrahedronQuality.h"
#include "surface/TetrahedronSupport.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <tuple>

namespace mmm
{
namespace
{
constexpr std::size_t TetrahedraPerRange = 16384;

class FlatTetrahedraTurner
{
public:
  FlatTetrahedraTurner(const IndicatorSet &         indicators,
                       const ParticleSet &          particles,
                       const TetrahedronAdjacency & adjacency,
                       Material                     outside,
                       TetrahedralMesh &            mesh)
    : m_Indicators(indicators)
    , m_Particles(particles)
    , m_Mesh(mesh)
    , m_Neighbours(adjacency.neighbours)
    , m_Inspector(mesh, adjacency, outside)
  {}

  std::size_t
  Turn()
  {
    std::size_t total = 0;
    for (int pass = 0; pass < MendingParameters::Passes; ++pass)
    {
      auto candidates = ParallelCollect<Candidate>(
        m_Mesh.tetrahedra.size(), TetrahedraPerRange, [this](std::size_t t, std::vector<Candidate> & found) {
          Candidate candidate;
          if (this->Assess(std::uint32_t(t), candidate))
          {
            found.push_back(candidate);
          }
        });
      std::sort(candidates.begin(), candidates.end());
      std::size_t changed = 0;
      for (Candidate & candidate : candidates)
      {
        // others may have changed around it
        changed += this->Assess(candidate.tetrahedron, candidate) && this->TurnOne(candidate);
      }
      total += changed;
      if (changed == 0)
      {
        break;
      }
    }
    return total;
  }

private:
  /** A tetrahedron that would have better triangles if it were of another material. */
  struct Candidate
  {
    double        radiusRatio;
    std::uint32_t tetrahedron;
    Material      beyond;

    /** Worst first. */
    bool
    operator<(const Candidate & other) const
    {
      return std::tie(radiusRatio, tetrahedron) < std::tie(other.radiusRatio, other.tetrahedron);
    }
  };

  /** A tetrahedron between two materials, some of whose faces are within its own. */
  bool
  Assess(std::uint32_t t, Candidate & candidate) const
  {
    const Material own = m_Mesh.materials[t];
    Material       beyond = own;
    int            inside = 0;
    double         before = 1.0;
    double         after = 1.0;
    for (int f = 0; f < 4; ++f)
    {
      const auto other = m_Neighbours[t][f];
      if (other == NoTetrahedron)
      {
        return false;
      }
      const Material m = m_Mesh.materials[other];
      if (m != own && beyond != own && m != beyond)
      {
        return false;
      }
      inside += m == own;
      beyond = m != own ? m : beyond;
    }
    if (inside == 0 || inside == 4)
    {
      return false;
    }
    for (int f = 0; f < 4; ++f)
    {
      const Triangle corners = FaceOf(m_Mesh.tetrahedra[t], f);
      double &       worst = m_Mesh.materials[m_Neighbours[t][f]] == own ? after : before;
      worst = std::min(worst,
                       TriangleRadiusRatio(m_Particles.positions[corners[0]],
                                           m_Particles.positions[corners[1]],
                                           m_Particles.positions[corners[2]]));
    }
    candidate = { before, t, beyond };
    return before < MendingParameters::PoorTriangle && after > before;
  }

  bool
  TurnOne(const Candidate & candidate)
  {
    const auto               t = candidate.tetrahedron;
    const auto &             c = m_Mesh.tetrahedra[t];
    const Material           own = m_Mesh.materials[t];
    const TetrahedronSupport support(m_Indicators,
                                     m_Particles.positions[c[0]],
                                     m_Particles.positions[c[1]],
                                     m_Particles.positions[c[2]],
                                     m_Particles.positions[c[3]]);
    if (m_Indicators.IsPlane(own) || m_Indicators.IsPlane(candidate.beyond) ||
        support.Of(own) - support.Of(candidate.beyond) > MendingParameters::Tolerance ||
        !std::all_of(c.begin(), c.end(), [&](PointId p) { return m_Particles.CellOf(p).Has(candidate.beyond); }))
    {
      return false;
    }
    const auto before = this->CountDefects(c);
    m_Mesh.materials[t] = candidate.beyond;
    if (this->CountDefects(c) > before)
    {
      m_Mesh.materials[t] = own;
      return false;
    }
    return true;
  }

  std::size_t
  CountDefects(const Tetrahedron & corners)
  {
    std::size_t count = 0;
    for (const PointId p : corners)
    {
      m_Inspector.Inspect(p);
      count += m_Inspector.CountDefects() + std::size_t(m_Inspector.IsHidden());
    }
    return count;
  }

  const IndicatorSet &          m_Indicators;
  const ParticleSet &           m_Particles;
  TetrahedralMesh &             m_Mesh;
  const TetrahedronNeighbours & m_Neighbours;
  LinkInspector                 m_Inspector;
};
} // namespace

std::size_t
TurnFlatTetrahedra(const IndicatorSet &         indicators,
                   const ParticleSet &          particles,
                   const TetrahedronAdjacency & adjacency,
                   Material                     outside,
                   TetrahedralMesh &            mesh)
{
  return FlatTetrahedraTurner(indicators, particles, adjacency, outside, mesh).Turn();
}
} // namespace mmm
