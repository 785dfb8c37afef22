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

#include "surface/LinkInspector.h"
#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "surface/TetrahedronSupport.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace mmm
{
namespace
{
constexpr std::size_t PointsPerRange = 4096;
/** Passes over what is left; most is done in the first. */
constexpr int Passes = 5;

/** Inspects some points, and the edges at them. */
LinkDefects
FindDefects(const TetrahedralMesh &      mesh,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            const std::vector<PointId> & points)
{
  std::vector<LinkDefects> parts((points.size() + PointsPerRange - 1) / PointsPerRange);
  ParallelFor(points.size(), PointsPerRange, [&](std::size_t begin, std::size_t end) {
    LinkInspector inspector(mesh, adjacency, outside);
    LinkDefects & defects = parts[begin / PointsPerRange];
    for (std::size_t n = begin; n < end; ++n)
    {
      const PointId p = points[n];
      inspector.Inspect(p);
      if (inspector.IsDefect())
      {
        defects.points.push_back(p);
      }
      for (const PointId q : inspector.DefectEdges())
      {
        defects.edges.push_back({ { std::min(p, q), std::max(p, q) } });
      }
    }
  });
  LinkDefects defects;
  for (const auto & part : parts)
  {
    defects.points.insert(defects.points.end(), part.points.begin(), part.points.end());
    defects.edges.insert(defects.edges.end(), part.edges.begin(), part.edges.end());
  }
  MakeUnique(defects.edges);
  return defects;
}

std::vector<PointId>
AllPoints(std::size_t count)
{
  std::vector<PointId> points(count);
  std::iota(points.begin(), points.end(), 0);
  return points;
}

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
               const std::vector<Vector> &  points,
               const TetrahedronAdjacency & adjacency,
               Material                     outside,
               TetrahedralMesh &            mesh)
    : m_Indicators(indicators)
    , m_Points(points)
    , m_Outside(outside)
    , m_Mesh(mesh)
    , m_Adjacency(adjacency)
    , m_Inspector(mesh, adjacency, outside)
    , m_Sizes(indicators.GetNumberOfMaterials() + 1, 0)
    , m_Defects(points.size(), Unknown)
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
    report.found = this->FindDefectsAt(AllPoints(m_Points.size()));
    report.left = report.found;
    for (int pass = 0; pass < Passes; ++pass)
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
      report.left = this->FindDefectsAt(m_Touched);
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

  LinkDefects
  FindDefectsAt(const std::vector<PointId> & points) const
  {
    return FindDefects(m_Mesh, m_Adjacency, m_Outside, points);
  }

  /** Tetrahedra, what they could be, and how much the indicators are against it. */
  struct Change
  {
    std::vector<std::uint32_t> tetrahedra;
    Material                   material;
    double                     cost{ 0.0 };
  };

  /** Makes the change at a point that costs least of those that help. Returns how many tetrahedra changed. */
  std::size_t
  RepairAt(PointId p, bool withPairs)
  {
    std::vector<Change> changes;
    this->ListChanges(p, withPairs, changes);
    for (Change & change : changes)
    {
      change.cost = this->CostOf(change);
    }
    std::stable_sort(
      changes.begin(), changes.end(), [](const Change & a, const Change & b) { return a.cost < b.cost; });
    const auto best =
      std::find_if(changes.begin(), changes.end(), [this](const Change & change) { return this->Helps(change); });
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

  /** Single tetrahedra or pairs, parts of the star, sectors around edges that are defects, and the whole star. */
  void
  ListChanges(PointId p, bool withPairs, std::vector<Change> & changes)
  {
    m_Inspector.Inspect(p);
    if (m_Inspector.CountDefects() == 0)
    {
      return;
    }
    const std::vector<int>      parts(m_Inspector.Parts().begin(), m_Inspector.Parts().end() - 1);
    const std::vector<PointId>  edges = m_Inspector.DefectEdges();
    const std::vector<Material> materials = m_Inspector.Materials();
    const auto * const          star = m_Adjacency.stars.Begin(p);
    std::vector<std::uint32_t>  group;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      this->AddChanges({ star[i] }, changes);
      for (const auto other : m_Adjacency.neighbours[star[i]])
      {
        if (withPairs && other != NoTetrahedron && other > star[i] &&
            m_Mesh.materials[other] == m_Mesh.materials[star[i]] &&
            std::binary_search(star, m_Adjacency.stars.End(p), other))
        {
          this->AddChanges({ star[i], other }, changes);
        }
      }
      if (parts[i] == int(i))
      {
        group.clear();
        for (std::size_t j = i; j < parts.size(); ++j)
        {
          if (parts[j] == int(i))
          {
            group.push_back(star[j]);
          }
        }
        this->AddChanges(group, changes);
      }
    }
    for (const PointId q : edges)
    {
      this->AddSectors(p, q, changes);
    }
    for (const Material m : materials)
    {
      changes.push_back({ std::vector<std::uint32_t>(star, m_Adjacency.stars.End(p)), m });
    }
  }

  void
  AddSectors(PointId p, PointId q, std::vector<Change> & changes)
  {
    std::vector<std::uint32_t> ring;
    for (const auto * t = m_Adjacency.stars.Begin(p); t != m_Adjacency.stars.End(p); ++t)
    {
      const auto & corners = m_Mesh.tetrahedra[*t];
      if (std::find(corners.begin(), corners.end(), q) != corners.end())
      {
        ring.push_back(*t);
      }
    }
    // sectors grow from one tetrahedron by faces at the edge
    std::vector<char> isTaken(ring.size(), 0);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (isTaken[i])
      {
        continue;
      }
      std::vector<std::uint32_t> sector{ ring[i] };
      isTaken[i] = 1;
      for (std::size_t n = 0; n < sector.size(); ++n)
      {
        for (const auto other : m_Adjacency.neighbours[sector[n]])
        {
          const auto found = std::size_t(std::lower_bound(ring.begin(), ring.end(), other) - ring.begin());
          if (found < ring.size() && ring[found] == other && !isTaken[found] &&
              m_Mesh.materials[other] == m_Mesh.materials[ring[i]])
          {
            isTaken[found] = 1;
            sector.push_back(other);
          }
        }
      }
      this->AddChanges(sector, changes);
    }
  }

  /** To each material that the tetrahedra have a face with. */
  void
  AddChanges(const std::vector<std::uint32_t> & tetrahedra, std::vector<Change> & changes) const
  {
    const Material        own = m_Mesh.materials[tetrahedra[0]];
    std::vector<Material> beyond;
    for (const auto t : tetrahedra)
    {
      for (const auto other : m_Adjacency.neighbours[t])
      {
        const Material m = other == NoTetrahedron ? m_Outside : m_Mesh.materials[other];
        if (m != own && std::find(beyond.begin(), beyond.end(), m) == beyond.end())
        {
          beyond.push_back(m);
        }
      }
    }
    for (const Material m : beyond)
    {
      changes.push_back({ tetrahedra, m });
    }
  }

  double
  CostOf(const Change & change)
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
      const TetrahedronSupport support(m_Indicators, m_Points[c[0]], m_Points[c[1]], m_Points[c[2]], m_Points[c[3]]);
      entry.first->second =
        TetrahedronVolume(m_Points[c[0]], m_Points[c[1]], m_Points[c[2]], m_Points[c[3]]) * this->SupportOf(support, m);
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
    for (int plane = 0; plane < 6; ++plane)
    {
      largest = std::max(largest, support.Of(Material(m_Indicators.GetNumberOfMaterials() + plane)));
    }
    return largest;
  }

  /** Whether there would be fewer defects, and no material were lost. */
  bool
  Helps(const Change & change)
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
  Apply(const Change & change)
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
  const std::vector<Vector> &  m_Points;
  const Material               m_Outside;
  TetrahedralMesh &            m_Mesh;
  const TetrahedronAdjacency & m_Adjacency;
  LinkInspector                m_Inspector;
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

LinkDefects
FindLinkDefects(const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency, Material outside)
{
  return FindDefects(mesh, adjacency, outside, AllPoints(adjacency.numberOfPoints));
}

LinkRepairReport
RepairLinks(const IndicatorSet &         indicators,
            const std::vector<Vector> &  points,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            TetrahedralMesh &            mesh)
{
  return LinkRepairer(indicators, points, adjacency, outside, mesh).Repair();
}
} // namespace mmm
