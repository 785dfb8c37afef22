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
#include "delaunay/LocalRecovery.h"

#include "delaunay/TetGen.h"
#include "mesh/InterfaceMesh.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>

namespace mmm
{
namespace
{
/** How often a region grows by the tetrahedra that touch it. */
constexpr int Layers = 2;

constexpr Material Inside = 0;
constexpr Material Outside = 1;

/** Which tetrahedra are around the missing triangles. */
std::vector<char>
FindRegion(const std::vector<Triangle> &    triangles,
           const std::vector<char> &        isMissing,
           std::size_t                      numberOfPoints,
           const std::vector<Tetrahedron> & tetrahedra)
{
  std::vector<char> isNear(numberOfPoints, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int c = 0; isMissing[t] && c < 3; ++c)
    {
      isNear[triangles[t][c]] = 1;
    }
  }
  std::vector<char> isIn(tetrahedra.size(), 0);
  for (int layer = 0; layer < Layers; ++layer)
  {
    const std::vector<char> isTouched = isNear;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    {
      const auto & corners = tetrahedra[t];
      if (std::any_of(corners.begin(), corners.end(), [&](PointId p) { return isTouched[p] != 0; }))
      {
        isIn[t] = 1;
        for (const auto corner : corners)
        {
          isNear[corner] = 1;
        }
      }
    }
  }
  return isIn;
}

/** A part of a mesh with its points, numbered from 0. */
class Part
{
public:
  Part(const std::vector<Vector> & points, const std::vector<Tetrahedron> & tetrahedra)
    : m_Numbers(points.size(), None)
  {
    for (const auto & t : tetrahedra)
    {
      for (const auto corner : t)
      {
        if (m_Numbers[corner] == None)
        {
          m_Numbers[corner] = PointId(m_Origins.size());
          m_Origins.push_back(corner);
          this->points.push_back(points[corner]);
        }
      }
    }
  }

  bool
  HasAll(const Triangle & triangle) const
  {
    return std::all_of(triangle.begin(), triangle.end(), [this](PointId p) { return m_Numbers[p] != None; });
  }

  Triangle
  ToPart(Triangle triangle) const
  {
    for (auto & corner : triangle)
    {
      corner = m_Numbers[corner];
    }
    return triangle;
  }

  /** From the part's numbers. Points that it has got go to the end of all. */
  Tetrahedron
  ToWhole(Tetrahedron t, std::vector<Vector> & all)
  {
    for (auto & corner : t)
    {
      while (corner >= m_Origins.size())
      {
        const PointId added = PointId(all.size());
        all.push_back(points[m_Origins.size()]);
        m_Origins.push_back(added);
      }
      corner = m_Origins[corner];
    }
    return t;
  }

  std::vector<Vector> points;

private:
  static constexpr PointId None = 0xffffffffu;

  std::vector<PointId> m_Numbers;
  std::vector<PointId> m_Origins;
};
} // namespace

void
RecoverLocally(const std::vector<Triangle> & triangles,
               const std::vector<char> &     isMissing,
               std::vector<Vector> &         points,
               std::vector<Tetrahedron> &    tetrahedra)
{
  const auto               isIn = FindRegion(triangles, isMissing, points.size(), tetrahedra);
  TetrahedralMesh          region;
  std::vector<Tetrahedron> others;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
  {
    (isIn[t] ? region.tetrahedra : others).push_back(tetrahedra[t]);
  }
  region.materials.assign(region.tetrahedra.size(), Inside);
  Part          part(points, region.tetrahedra);
  InterfaceMesh border = ExtractInterfaces(region, Outside);
  for (Triangle & triangle : border.triangles)
  {
    triangle = part.ToPart(triangle);
  }
  std::vector<Triangle> facets = border.triangles;
  const TriangleLookup  onBorder(border.triangles);
  for (const Triangle & triangle : triangles)
  {
    if (part.HasAll(triangle) && onBorder.Find(part.ToPart(triangle)) == TriangleLookup::None)
    {
      facets.push_back(part.ToPart(triangle));
    }
  }
  const auto fresh = ConstrainedTetrahedralization(part.points, facets);
  const auto sides = LabelByInterfaces(border, fresh, Outside);
  if (!sides)
  {
    throw TetGenFailure(__FILE__, __LINE__, "TetGen lost faces of a part of the mesh.", "");
  }
  tetrahedra.swap(others);
  for (std::size_t t = 0; t < fresh.size(); ++t)
  {
    if ((*sides)[t] == Inside)
    {
      tetrahedra.push_back(part.ToWhole(fresh[t], points));
    }
  }
}
} // namespace mmm
