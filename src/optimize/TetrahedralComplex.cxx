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
#include "optimize/TetrahedralComplex.h"

#include "mesh/TetrahedronNeighbours.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>

namespace mmm
{
namespace
{
int
CornerOf(const Tetrahedron & corners, PointId point)
{
  return int(std::find(corners.begin(), corners.end(), point) - corners.begin());
}

/** As std::find() tells, but without an early end, so that compilers vectorize it. */
bool
Has(const std::vector<TetrahedralComplex::Id> & tetrahedra, TetrahedralComplex::Id t)
{
  bool found = false;
  for (const auto other : tetrahedra)
  {
    found |= other == t;
  }
  return found;
}
} // namespace

TetrahedralComplex::TetrahedralComplex(const TetrahedralMesh & mesh, std::size_t numberOfPoints)
  : m_Corners(mesh.tetrahedra)
  , m_Neighbours(ComputeTetrahedronNeighbours(mesh.tetrahedra))
  , m_Materials(mesh.materials)
  , m_Alive(mesh.tetrahedra.size(), 1)
  , m_PointTetrahedron(numberOfPoints, NoTetrahedron)
  , m_IsTouched(numberOfPoints, 0)
{
  this->FindTetrahedronOfEachPoint();
}

void
TetrahedralComplex::FindTetrahedronOfEachPoint()
{
  std::fill(m_PointTetrahedron.begin(), m_PointTetrahedron.end(), NoTetrahedron);
  for (Id t = 0; t < m_Corners.size(); ++t)
  {
    for (const auto corner : m_Corners[t])
    {
      m_PointTetrahedron[corner] = t;
    }
  }
}

void
TetrahedralComplex::GetStar(PointId point, std::vector<Id> & star) const
{
  star.clear();
  if (m_PointTetrahedron[point] == NoTetrahedron)
  {
    return;
  }
  star.push_back(m_PointTetrahedron[point]);
  for (std::size_t n = 0; n < star.size(); ++n)
  {
    const Id t = star[n];
    for (int f = 0; f < 4; ++f)
    {
      const Id other = m_Neighbours[t][f];
      if (m_Corners[t][f] != point && other != NoTetrahedron && !Has(star, other))
      {
        star.push_back(other);
      }
    }
  }
}

void
TetrahedralComplex::GetRing(Id first, PointId a, PointId b, Ring & ring) const
{
  ring.tetrahedra.clear();
  ring.link.clear();
  ring.closed = true;
  // the two other corners, so ordered that the ring turns one way
  PointId others[2];
  int     count = 0;
  for (const auto corner : m_Corners[first])
  {
    if (corner != a && corner != b)
    {
      others[count++] = corner;
    }
  }
  for (int direction = 0; direction < 2; ++direction)
  {
    Id      t = first;
    PointId behind = others[direction];
    PointId ahead = others[1 - direction];
    if (direction == 0)
    {
      ring.link.push_back(behind);
    }
    while (true)
    {
      if (direction == 0)
      {
        ring.tetrahedra.push_back(t);
      }
      const Id next = m_Neighbours[t][CornerOf(m_Corners[t], behind)];
      if (next == first)
      {
        return;
      }
      if (direction == 0)
      {
        ring.link.push_back(ahead);
      }
      if (next == NoTetrahedron)
      {
        break;
      }
      t = next;
      behind = ahead;
      for (const auto corner : m_Corners[t])
      {
        if (corner != a && corner != b && corner != behind)
        {
          ahead = corner;
          break;
        }
      }
      if (direction == 1)
      {
        ring.tetrahedra.insert(ring.tetrahedra.begin(), t);
        ring.link.insert(ring.link.begin(), ahead);
      }
    }
    ring.closed = false;
  }
}

void
TetrahedralComplex::Replace(const std::vector<Id> & old, const std::vector<Element> & fresh)
{
  struct Open
  {
    Triangle face;
    Id       tetrahedron;
    int      number;
  };
  std::vector<Open> open;
  for (const Id t : old)
  {
    for (int f = 0; f < 4; ++f)
    {
      const Id other = m_Neighbours[t][f];
      if (other == NoTetrahedron || !Has(old, other))
      {
        const int number =
          other == NoTetrahedron
            ? 0
            : int(std::find(m_Neighbours[other].begin(), m_Neighbours[other].end(), t) - m_Neighbours[other].begin());
        open.push_back({ SortedFaceOf(m_Corners[t], f), other, number });
      }
    }
  }
  for (const Id t : old)
  {
    m_Alive[t] = 0;
    this->Touch(t);
    for (const auto corner : m_Corners[t])
    {
      m_PointTetrahedron[corner] = NoTetrahedron;
    }
  }
  m_Free.insert(m_Free.end(), old.rbegin(), old.rend());
  // points that no new tetrahedron has may still belong to one beside the hole
  for (const auto & o : open)
  {
    if (o.tetrahedron != NoTetrahedron)
    {
      for (const auto corner : o.face)
      {
        m_PointTetrahedron[corner] = o.tetrahedron;
      }
    }
  }

  for (const auto & element : fresh)
  {
    Id t;
    if (m_Free.empty())
    {
      t = Id(m_Corners.size());
      m_Corners.emplace_back();
      m_Neighbours.emplace_back();
      m_Materials.emplace_back();
      m_Alive.emplace_back();
    }
    else
    {
      t = m_Free.back();
      m_Free.pop_back();
    }
    m_Corners[t] = element.corners;
    m_Materials[t] = element.material;
    m_Alive[t] = 1;
    for (int f = 0; f < 4; ++f)
    {
      const Triangle face = SortedFaceOf(element.corners, f);
      const auto     twin = std::find_if(open.begin(), open.end(), [&](const Open & o) { return o.face == face; });
      if (twin == open.end())
      {
        m_Neighbours[t][f] = NoTetrahedron;
        open.push_back({ face, t, f });
      }
      else
      {
        m_Neighbours[t][f] = twin->tetrahedron;
        if (twin->tetrahedron != NoTetrahedron)
        {
          m_Neighbours[twin->tetrahedron][twin->number] = t;
        }
        *twin = open.back();
        open.pop_back();
      }
    }
    for (const auto corner : element.corners)
    {
      m_PointTetrahedron[corner] = t;
    }
  }
  // what found no twin lies on the outside of the mesh now
  for (const auto & o : open)
  {
    if (o.tetrahedron != NoTetrahedron)
    {
      m_Neighbours[o.tetrahedron][o.number] = NoTetrahedron;
    }
  }
}

void
TetrahedralComplex::ForgetTouched()
{
  std::fill(m_IsTouched.begin(), m_IsTouched.end(), 0);
}

void
TetrahedralComplex::Compact()
{
  std::vector<Id> number(m_Corners.size(), NoTetrahedron);
  Id              left = 0;
  for (Id t = 0; t < m_Corners.size(); ++t)
  {
    if (m_Alive[t])
    {
      number[t] = left++;
    }
  }
  for (Id t = 0; t < m_Corners.size(); ++t)
  {
    if (!m_Alive[t])
    {
      continue;
    }
    for (auto & other : m_Neighbours[t])
    {
      other = other == NoTetrahedron ? NoTetrahedron : number[other];
    }
    m_Corners[number[t]] = m_Corners[t];
    m_Neighbours[number[t]] = m_Neighbours[t];
    m_Materials[number[t]] = m_Materials[t];
  }
  m_Corners.resize(left);
  m_Neighbours.resize(left);
  m_Materials.resize(left);
  m_Alive.assign(left, 1);
  m_Free.clear();
  this->FindTetrahedronOfEachPoint();
}

TetrahedralMesh
TetrahedralComplex::GetMesh() const
{
  TetrahedralMesh mesh;
  for (Id t = 0; t < m_Corners.size(); ++t)
  {
    if (m_Alive[t])
    {
      mesh.tetrahedra.push_back(m_Corners[t]);
      mesh.materials.push_back(m_Materials[t]);
    }
  }
  return mesh;
}
} // namespace mmm
