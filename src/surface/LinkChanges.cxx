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
#include "surface/LinkChanges.h"

#include <algorithm>
#include <utility>

namespace mmm
{
LinkChangeLister::LinkChangeLister(const TetrahedralMesh &      mesh,
                                   const TetrahedronAdjacency & adjacency,
                                   Material                     outside)
  : m_Mesh(mesh)
  , m_Adjacency(adjacency)
  , m_Outside(outside)
  , m_Inspector(mesh, adjacency, outside)
{}

std::vector<LinkChange>
LinkChangeLister::List(PointId p, bool withPairs)
{
  m_Changes.clear();
  m_Inspector.Inspect(p);
  if (m_Inspector.CountDefects() == 0)
  {
    return {};
  }
  const std::vector<int>      parts(m_Inspector.Parts().begin(), m_Inspector.Parts().end() - 1);
  const std::vector<PointId>  edges = m_Inspector.DefectEdges();
  const std::vector<Material> materials = m_Inspector.Materials();
  const auto * const          star = m_Adjacency.stars.Begin(p);
  std::vector<std::uint32_t>  group;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    this->AddChanges({ star[i] });
    for (const auto other : m_Adjacency.neighbours[star[i]])
    {
      if (withPairs && other != NoTetrahedron && other > star[i] &&
          m_Mesh.materials[other] == m_Mesh.materials[star[i]] &&
          std::binary_search(star, m_Adjacency.stars.End(p), other))
      {
        this->AddChanges({ star[i], other });
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
      this->AddChanges(group);
    }
  }
  for (const PointId q : edges)
  {
    this->AddSectors(p, q);
  }
  for (const Material m : materials)
  {
    m_Changes.push_back({ std::vector<std::uint32_t>(star, m_Adjacency.stars.End(p)), m });
  }
  return std::move(m_Changes);
}

void
LinkChangeLister::AddSectors(PointId p, PointId q)
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
    this->AddChanges(sector);
  }
}

void
LinkChangeLister::AddChanges(const std::vector<std::uint32_t> & tetrahedra)
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
    m_Changes.push_back({ tetrahedra, m });
  }
}
} // namespace mmm
