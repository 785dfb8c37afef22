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
#include "mesh/MeshTopology.h"
#include "mesh/BoundarySheets.h"
#include "base/DisjointSets.h"
#include "mesh/Incidence.h"
#include "base/Parallel.h"
#include "mesh/TetrahedronNeighbours.h"

#include <stdexcept>
#include <string>

namespace mmm
{
namespace
{
constexpr std::size_t PointsPerRange = 4096;

/** Counts per region that threads add to; integers, so that the order does not matter. */
using Counts = std::vector<std::atomic<std::size_t>>;

Tetrahedron
Sorted(Tetrahedron tetrahedron)
{
  std::sort(tetrahedron.begin(), tetrahedron.end());
  return tetrahedron;
}

class TopologyBuilder
{
public:
  TopologyBuilder(const std::vector<Vector> &        points,
                  const std::vector<Tetrahedron> &   tetrahedra,
                  const std::vector<std::uint32_t> & regions,
                  std::size_t                        numberOfRegions)
    : m_Points(points)
    , m_Tetrahedra(tetrahedra)
    , m_Regions(regions)
    , m_Parts(tetrahedra.size())
  {
    m_Result.regions.resize(numberOfRegions);
  }

  MeshTopology
  Build(bool withBettiNumbers)
  {
    {
      const Incidence atPoints = StarsOfPoints(m_Tetrahedra, m_Points.size());
      this->PairFaces(atPoints);
      if (withBettiNumbers)
      {
        this->CountCells(atPoints);
      }
    }
    for (std::uint32_t t = 0; t < m_Parts.size(); ++t)
    {
      if (m_Parts.Find(t) == t)
      {
        ++m_Result.regions[m_Regions[t]].components;
      }
    }
    this->FollowBoundaries(withBettiNumbers);
    return std::move(m_Result);
  }

private:
  /** Visits each face at its smallest point, with all of its tetrahedra. */
  void
  PairFaces(const Incidence & atPoints)
  {
    const std::size_t                      ranges = (m_Points.size() + PointsPerRange - 1) / PointsPerRange;
    std::vector<std::vector<BoundaryFace>> found(ranges);
    std::vector<std::size_t>               overused(ranges, 0);
    ParallelFor(m_Points.size(), PointsPerRange, [&](std::size_t begin, std::size_t end) {
      const std::size_t  range = begin / PointsPerRange;
      std::vector<Keyed> faces;
      for (std::size_t p = begin; p < end; ++p)
      {
        faces.clear();
        std::uint32_t previous = NoTetrahedron;
        for (auto t = atPoints.Begin(p); t != atPoints.End(p); ++t)
        {
          if (*t == previous)
          {
            continue;
          }
          previous = *t;
          const auto sorted = Sorted(m_Tetrahedra[*t]);
          if (sorted[0] == p)
          {
            faces.push_back({ Key(sorted[1], sorted[2]), *t });
            faces.push_back({ Key(sorted[1], sorted[3]), *t });
            faces.push_back({ Key(sorted[2], sorted[3]), *t });
          }
          if (sorted[1] == p)
          {
            faces.push_back({ Key(sorted[2], sorted[3]), *t });
          }
        }
        std::sort(faces.begin(), faces.end());
        ForEachRun(faces, [&](std::size_t first, std::size_t last) {
          const std::array<std::uint32_t, 3> face{
            { std::uint32_t(p), std::uint32_t(faces[first].key >> 32), std::uint32_t(faces[first].key) }
          };
          overused[range] += last - first > 2;
          this->AddFace(face, faces.data() + first, faces.data() + last, found[range]);
        });
      }
    });
    std::size_t count = 0;
    for (const auto & faces : found)
    {
      count += faces.size();
    }
    m_Result.boundaryFaces.reserve(count);
    for (std::size_t range = 0; range < ranges; ++range)
    {
      m_Result.boundaryFaces.insert(m_Result.boundaryFaces.end(), found[range].begin(), found[range].end());
      m_Result.overusedFaces += overused[range];
      std::vector<BoundaryFace>().swap(found[range]);
    }
    for (const auto & face : m_Result.boundaryFaces)
    {
      ++m_Result.regions[m_Regions[face.tetrahedron]].boundaryFaces;
    }
  }

  /** Joins the tetrahedra of the same region that share a face, and lists the face where there are others. */
  void
  AddFace(const std::array<std::uint32_t, 3> & points,
          const Keyed *                        begin,
          const Keyed *                        end,
          std::vector<BoundaryFace> &          boundary)
  {
    if (end - begin == 1)
    {
      boundary.push_back({ points, begin->value, NoTetrahedron, true });
      return;
    }
    bool first = true;
    for (auto tetrahedron = begin; tetrahedron != end; ++tetrahedron)
    {
      const auto isSame = [&](const Keyed & other) { return m_Regions[other.value] == m_Regions[tetrahedron->value]; };
      const auto before = std::find_if(begin, tetrahedron, isSame);
      if (before != tetrahedron)
      {
        m_Parts.Unite(before->value, tetrahedron->value);
        continue;
      }
      const auto other = std::find_if_not(begin, end, isSame);
      if (other != end)
      {
        boundary.push_back({ points, tetrahedron->value, other->value, first });
        first = false;
      }
    }
  }

  /** The Euler characteristic of each region, from the points, edges and faces that have a tetrahedron of it. */
  void
  CountCells(const Incidence & atPoints)
  {
    const std::size_t                        regions = m_Result.regions.size();
    std::vector<std::atomic<std::ptrdiff_t>> characteristics(regions);
    for (auto & characteristic : characteristics)
    {
      characteristic = 0;
    }
    ParallelFor(m_Points.size(), PointsPerRange, [&](std::size_t begin, std::size_t end) {
      std::vector<std::ptrdiff_t> local(regions, 0);
      std::vector<std::uint32_t>  here;
      std::vector<std::uint64_t>  edges;
      for (std::size_t p = begin; p < end; ++p)
      {
        here.clear();
        edges.clear();
        for (auto t = atPoints.Begin(p); t != atPoints.End(p); ++t)
        {
          here.push_back(m_Regions[*t]);
          for (const auto other : m_Tetrahedra[*t])
          {
            if (other > p)
            {
              edges.push_back(Key(other, m_Regions[*t]));
            }
          }
        }
        std::sort(here.begin(), here.end());
        std::sort(edges.begin(), edges.end());
        const auto endOfHere = std::unique(here.begin(), here.end());
        const auto endOfEdges = std::unique(edges.begin(), edges.end());
        std::for_each(here.begin(), endOfHere, [&](std::uint32_t region) { ++local[region]; });
        std::for_each(edges.begin(), endOfEdges, [&](std::uint64_t edge) { --local[std::uint32_t(edge)]; });
      }
      for (std::size_t region = 0; region < regions; ++region)
      {
        if (local[region] != 0)
        {
          characteristics[region] += local[region];
        }
      }
    });
    // two tetrahedra share a face inside of a region: it has (4 T + B) / 2 faces
    std::vector<std::ptrdiff_t> tetrahedra(regions, 0);
    for (const auto region : m_Regions)
    {
      ++tetrahedra[region];
    }
    m_Characteristics.resize(regions);
    for (std::size_t region = 0; region < regions; ++region)
    {
      const auto faces = (4 * tetrahedra[region] + std::ptrdiff_t(m_Result.regions[region].boundaryFaces)) / 2;
      m_Characteristics[region] = characteristics[region] + faces - tetrahedra[region];
    }
  }

  /** Looks at each edge of each region's boundary, and for Betti numbers at each point as well. */
  void
  FollowBoundaries(bool withBettiNumbers)
  {
    const auto &      faces = m_Result.boundaryFaces;
    const std::size_t regions = m_Result.regions.size();
    const Incidence   atPoints(m_Points.size(), faces.size(), [&](std::size_t f) { return faces[f].points; });
    Counts            open(regions);
    Counts            nonManifold(regions);
    for (std::size_t region = 0; region < regions; ++region)
    {
      open[region] = 0;
      nonManifold[region] = 0;
    }

    DisjointSets sheets(withBettiNumbers ? faces.size() : 0);
    DisjointSets partsByEdge(withBettiNumbers ? m_Parts.size() : 0);
    DisjointSets partsByPoint(withBettiNumbers ? m_Parts.size() : 0);
    for (std::uint32_t t = 0; t < partsByEdge.size(); ++t)
    {
      partsByEdge.Unite(t, m_Parts.Find(t));
      partsByPoint.Unite(t, m_Parts.Find(t));
    }

    ParallelFor(m_Points.size(), PointsPerRange, [&](std::size_t begin, std::size_t end) {
      std::vector<Keyed> edges;
      std::vector<Keyed> here;
      for (std::size_t p = begin; p < end; ++p)
      {
        edges.clear();
        here.clear();
        for (auto f = atPoints.Begin(p); f != atPoints.End(p); ++f)
        {
          const auto region = m_Regions[faces[*f].tetrahedron];
          here.push_back({ region, *f });
          for (const auto other : faces[*f].points)
          {
            if (other > p)
            {
              edges.push_back({ Key(other, region), *f });
            }
          }
        }
        std::sort(edges.begin(), edges.end());
        ForEachRun(edges, [&](std::size_t first, std::size_t last) {
          const auto region = std::uint32_t(edges[first].key);
          open[region] += (last - first) % 2;
          nonManifold[region] += last - first > 2;
          if (withBettiNumbers)
          {
            for (std::size_t i = first + 1; i < last; ++i)
            {
              partsByEdge.Unite(faces[edges[first].value].tetrahedron, faces[edges[i].value].tetrahedron);
            }
            JoinSheets(m_Points,
                       m_Tetrahedra,
                       faces,
                       { { std::uint32_t(p), std::uint32_t(edges[first].key >> 32) } },
                       { edges.data() + first, edges.data() + last },
                       sheets);
          }
        });
        if (withBettiNumbers)
        {
          std::sort(here.begin(), here.end());
          ForEachRun(here, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first + 1; i < last; ++i)
            {
              partsByPoint.Unite(faces[here[first].value].tetrahedron, faces[here[i].value].tetrahedron);
            }
          });
        }
      }
    });
    for (std::size_t region = 0; region < regions; ++region)
    {
      m_Result.regions[region].openEdges = open[region];
      m_Result.regions[region].nonManifoldEdges = nonManifold[region];
    }
    if (!withBettiNumbers)
    {
      return;
    }
    for (std::uint32_t f = 0; f < faces.size(); ++f)
    {
      m_Result.regions[m_Regions[faces[f].tetrahedron]].betti[2] += sheets.Find(f) == f;
    }
    for (std::uint32_t t = 0; t < m_Parts.size(); ++t)
    {
      auto & betti = m_Result.regions[m_Regions[t]].betti;
      betti[0] += partsByPoint.Find(t) == t;
      betti[2] -= partsByEdge.Find(t) == t;
    }
    for (std::size_t region = 0; region < regions; ++region)
    {
      auto & betti = m_Result.regions[region].betti;
      betti[1] = betti[0] + betti[2] - m_Characteristics[region];
    }
  }

  const std::vector<Vector> &        m_Points;
  const std::vector<Tetrahedron> &   m_Tetrahedra;
  const std::vector<std::uint32_t> & m_Regions;
  MeshTopology                       m_Result;
  DisjointSets                       m_Parts;
  std::vector<std::ptrdiff_t>        m_Characteristics;
};
} // namespace

MeshTopology
ComputeMeshTopology(const std::vector<Vector> &        points,
                    const std::vector<Tetrahedron> &   tetrahedra,
                    const std::vector<std::uint32_t> & regions,
                    std::size_t                        numberOfRegions,
                    bool                               withBettiNumbers)
{
  if (tetrahedra.size() >= NoTetrahedron)
  {
    throw std::length_error("A mesh of " + std::to_string(tetrahedra.size()) + " tetrahedra is too large.");
  }
  return TopologyBuilder(points, tetrahedra, regions, numberOfRegions).Build(withBettiNumbers);
}

MeshTopology
ComputeMeshTopology(const std::vector<Vector> & points, const TetrahedralMesh & mesh, std::size_t numberOfMaterials)
{
  const std::vector<std::uint32_t> regions(mesh.materials.begin(), mesh.materials.end());
  return ComputeMeshTopology(points, mesh.tetrahedra, regions, numberOfMaterials + 1, true);
}
} // namespace mmm
