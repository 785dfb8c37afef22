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
#include "surface/LinkRepair.h"

#include "base/MakeUnique.h"
#include "surface/LinkChanges.h"
#include "surface/SurfaceParameters.h"
#include "surface/TetrahedronSupport.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace mmm
{
namespace
{
/** The points that are defects or ends of edges that are. */
std::vector<PointId>
PointsOf(const LinkDefects & defects)
{
  std::vector<PointId> points = defects.points;
  for (const auto & edge : defects.edges)
  {
    points.insert(points.end(), edge.begin(), edge.end());
  }
  MakeUnique(points);
  return points;
}

class LinkRepairer
{
public:
  LinkRepairer(const IndicatorSet &         indicators,
               const ParticleSet &          particles,
               const TetrahedronAdjacency & adjacency,
               Material                     outside,
               TetrahedralMesh &            mesh)
    : m_Indicators(indicators)
    , m_Particles(particles)
    , m_Outside(outside)
    , m_Mesh(mesh)
    , m_Adjacency(adjacency)
    , m_Inspector(mesh, adjacency, outside)
    , m_Changes(mesh, adjacency, outside)
    , m_Sizes(indicators.GetNumberOfMaterials() + 1, 0)
    , m_Defects(particles.Size(), Unknown)
  {
    for (const Material m : mesh.materials)
    {
      ++m_Sizes[this->Slot(m)];
    }
  }

  LinkRepairReport
  Repair()
  {
    LinkRepairReport report;
    report.found = FindLinkDefects(m_Mesh, m_Adjacency, m_Outside);
    report.left = report.found;
    for (int pass = 0; pass < MendingParameters::Passes; ++pass)
    {
      std::vector<PointId> points = PointsOf(report.left);
      m_Touched = points;
      std::size_t changed = 0;
      for (const PointId p : points)
      {
        changed += this->RepairAt(p, pass > 0);
      }
      // nothing has changed elsewhere
      MakeUnique(m_Touched);
      report.left = FindLinkDefects(m_Mesh, m_Adjacency, m_Outside, m_Touched);
      report.relabelled += changed;
      if (changed == 0)
      {
        break;
      }
    }
    return report;
  }

private:
  static constexpr std::size_t Unknown = std::size_t(-1);

  /** Makes the change at a point that costs least of those that help. Returns how many tetrahedra changed. */
  std::size_t
  RepairAt(PointId p, bool withPairs)
  {
    std::vector<LinkChange> changes = m_Changes.List(p, withPairs);
    for (LinkChange & change : changes)
    {
      change.strangers = this->CountStrangers(change);
      change.cost = this->CostOf(change);
    }
    std::stable_sort(changes.begin(), changes.end(), [](const LinkChange & a, const LinkChange & b) {
      return std::tie(a.strangers, a.cost) < std::tie(b.strangers, b.cost);
    });
    const auto best =
      std::find_if(changes.begin(), changes.end(), [this](const LinkChange & change) { return this->Helps(change); });
    if (best == changes.end())
    {
      return 0;
    }
    this->Apply(*best);
    for (const auto t : best->tetrahedra)
    {
      for (const PointId corner : m_Mesh.tetrahedra[t])
      {
        m_Touched.push_back(corner);
        m_Defects[corner] = Unknown;
      }
    }
    return best->tetrahedra.size();
  }

  std::size_t
  CountStrangers(const LinkChange & change) const
  {
    std::size_t count = 0;
    for (const auto t : change.tetrahedra)
    {
      const auto & corners = m_Mesh.tetrahedra[t];
      count += std::size_t(std::count_if(
        corners.begin(), corners.end(), [&](PointId p) { return !m_Particles.CellOf(p).Has(change.material); }));
    }
    return count;
  }

  double
  CostOf(const LinkChange & change)
  {
    double sum = 0.0;
    for (const auto t : change.tetrahedra)
    {
      sum += this->SupportOf(t, m_Mesh.materials[t]) - this->SupportOf(t, change.material);
    }
    return sum;
  }

  /** How much the indicators are for a material, by volume. */
  double
  SupportOf(std::uint32_t t, Material m)
  {
    const auto entry = m_Supports.insert({ (std::uint64_t(t) << 32) | m, 0.0 });
    if (entry.second)
    {
      const auto &             c = m_Mesh.tetrahedra[t];
      const TetrahedronSupport support(m_Indicators,
                                       m_Particles.positions[c[0]],
                                       m_Particles.positions[c[1]],
                                       m_Particles.positions[c[2]],
                                       m_Particles.positions[c[3]]);
      entry.first->second = TetrahedronVolume(m_Particles.positions[c[0]],
                                              m_Particles.positions[c[1]],
                                              m_Particles.positions[c[2]],
                                              m_Particles.positions[c[3]]) *
                            this->SupportOf(support, m);
    }
    return entry.first->second;
  }

  /** What is outside of the box belongs to one of its planes. */
  double
  SupportOf(const TetrahedronSupport & support, Material m) const
  {
    if (!m_Indicators.IsPlane(m))
    {
      return support.Of(m);
    }
    double largest = -1e300;
    for (int plane = 0; plane < BoxPlanes::Count; ++plane)
    {
      largest = std::max(largest, support.Of(m_Indicators.Planes().At(plane)));
    }
    return largest;
  }

  /** Whether there would be fewer defects, and no material were lost. */
  bool
  Helps(const LinkChange & change)
  {
    std::vector<PointId>  points;
    std::vector<Material> own;
    for (const auto t : change.tetrahedra)
    {
      points.insert(points.end(), m_Mesh.tetrahedra[t].begin(), m_Mesh.tetrahedra[t].end());
      own.push_back(m_Mesh.materials[t]);
    }
    MakeUnique(points);
    const std::size_t before = this->CountDefects(points);
    this->Apply(change);
    const bool isLost = std::any_of(own.begin(), own.end(), [&](Material m) { return m_Sizes[this->Slot(m)] == 0; });
    const bool helps = !isLost && m_Inspector.CountDefectsAt(points, before) < before;
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      this->SetMaterial(change.tetrahedra[i], own[i]);
    }
    return helps;
  }

  /** The defects at some points as they are, as LinkInspector counts them. */
  std::size_t
  CountDefects(const std::vector<PointId> & points)
  {
    std::size_t count = 0;
    for (const PointId p : points)
    {
      if (m_Defects[p] == Unknown)
      {
        m_Inspector.Inspect(p);
        m_Defects[p] = m_Inspector.CountDefects();
      }
      count += m_Defects[p];
    }
    return count;
  }

  void
  Apply(const LinkChange & change)
  {
    for (const auto t : change.tetrahedra)
    {
      this->SetMaterial(t, change.material);
    }
  }

  void
  SetMaterial(std::uint32_t t, Material material)
  {
    --m_Sizes[this->Slot(m_Mesh.materials[t])];
    ++m_Sizes[this->Slot(material)];
    m_Mesh.materials[t] = material;
  }

  std::size_t
  Slot(Material m) const
  {
    return std::min<std::size_t>(m, m_Sizes.size() - 1);
  }

  const IndicatorSet &         m_Indicators;
  const ParticleSet &          m_Particles;
  const Material               m_Outside;
  TetrahedralMesh &            m_Mesh;
  const TetrahedronAdjacency & m_Adjacency;
  LinkInspector                m_Inspector;
  LinkChangeLister             m_Changes;
  /** The number of tetrahedra of each material. */
  std::vector<std::size_t> m_Sizes;
  /** The defects at each point and its edges, where they are known. */
  std::vector<std::size_t> m_Defects;
  /** What SupportOf() gave, by tetrahedron and material. */
  std::unordered_map<std::uint64_t, double> m_Supports;
  /** Points whose links are not known any more. */
  std::vector<PointId> m_Touched;
};
} // namespace

LinkRepairReport
RepairLinks(const IndicatorSet &         indicators,
            const ParticleSet &          particles,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            TetrahedralMesh &            mesh)
{
  return LinkRepairer(indicators, particles, adjacency, outside, mesh).Repair();
}
} // namespace mmm
