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
#include "surface/LinkInspector.h"

#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <numeric>

namespace mmm
{
LinkInspector::LinkInspector(const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency, Material outside)
  : m_Mesh(mesh)
  , m_Adjacency(adjacency)
  , m_Outside(outside)
{}

void
LinkInspector::Inspect(PointId p)
{
  m_DefectEdges.clear();
  this->FindPartsAndSpokes(p);
  std::sort(
    m_Spokes.begin(), m_Spokes.end(), [](const LinkSpoke & a, const LinkSpoke & b) { return a.corner < b.corner; });
  const LinkSpoke * const end = m_Spokes.data() + m_Spokes.size();
  std::ptrdiff_t          edges = 0;
  for (const LinkSpoke * first = m_Spokes.data(); first != end; ++edges)
  {
    const LinkSpoke * const last =
      std::find_if(first, end, [=](const LinkSpoke & s) { return s.corner != first->corner; });
    // there are as many sectors as faces
    this->ListMaterials(first, last);
    if (std::size_t(last - first) > m_Materials.size())
    {
      m_DefectEdges.push_back(first->corner);
    }
    first = last;
  }
  this->ListMaterials(m_Spokes.data(), end);
  // the interfaces are a graph on the sphere: V - E + F = 1 + the number of its pieces
  const auto pieces = edges - std::ptrdiff_t(m_Spokes.size() / 2) + std::ptrdiff_t(m_NumberOfParts) - 1;
  m_IsDefect = !m_Spokes.empty() && (m_NumberOfParts > m_Materials.size() || pieces > 1);
}

/** The parts of each material around p, and the faces between them. */
void
LinkInspector::FindPartsAndSpokes(PointId p)
{
  const auto * const begin = m_Adjacency.stars.Begin(p);
  const auto * const end = m_Adjacency.stars.End(p);
  // the last part is what lies beyond the mesh
  const int beyond = int(end - begin);
  bool      isAtHull = false;
  m_Parents.resize(beyond + 1);
  std::iota(m_Parents.begin(), m_Parents.end(), 0);
  m_Spokes.clear();
  m_NumberOfParts = beyond;
  for (const auto * t = begin; t != end; ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto other = m_Adjacency.neighbours[*t][f];
      // each face at p once
      if (m_Mesh.tetrahedra[*t][f] == p || (other != NoTetrahedron && other < *t))
      {
        continue;
      }
      m_NumberOfParts += other == NoTetrahedron && !isAtHull;
      isAtHull = isAtHull || other == NoTetrahedron;
      const Material material = other == NoTetrahedron ? m_Outside : m_Mesh.materials[other];
      if (material == m_Mesh.materials[*t])
      {
        this->Unite(int(t - begin), other == NoTetrahedron ? beyond : int(std::lower_bound(begin, end, other) - begin));
        continue;
      }
      for (const auto corner : FaceOf(m_Mesh.tetrahedra[*t], f))
      {
        if (corner != p)
        {
          m_Spokes.push_back({ corner, { m_Mesh.materials[*t], material } });
        }
      }
    }
  }
  for (int & parent : m_Parents)
  {
    parent = this->Find(parent);
  }
}

void
LinkInspector::Unite(int a, int b)
{
  a = this->Find(a);
  b = this->Find(b);
  m_Parents[std::max(a, b)] = std::min(a, b);
  m_NumberOfParts -= a != b;
}

int
LinkInspector::Find(int a) const
{
  while (m_Parents[a] != a)
  {
    a = m_Parents[a];
  }
  return a;
}

void
LinkInspector::ListMaterials(const LinkSpoke * begin, const LinkSpoke * end)
{
  m_Materials.clear();
  for (; begin != end; ++begin)
  {
    for (const Material m : begin->sides)
    {
      if (std::find(m_Materials.begin(), m_Materials.end(), m) == m_Materials.end())
      {
        m_Materials.push_back(m);
      }
    }
  }
}
} // namespace mmm
