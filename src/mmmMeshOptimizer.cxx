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
#include "mmmMeshOptimizer.h"

#include "mmmMeshOptimizerSmoothing.h"
#include "mmmTetrahedralComplex.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
using Id = TetrahedralComplex::Id;
using Element = TetrahedralComplex::Element;

constexpr int    LongestRing = 9;
constexpr double LeastGain = 1e-6;
/** A new interface triangle's radius ratio is at least this, or that of the worst one that it replaces. */
constexpr double TriangleFloor = 0.4;

/** Local changes of the connectivity. Each keeps the space that is filled, the topology of the interfaces, and makes
 * the worst tetrahedron that it touches better. */
class ConnectivityImprover
{
public:
  ConnectivityImprover(const IndicatorSet &           indicators,
                       Material                       exterior,
                       const std::vector<Cell> &      cells,
                       const OptimizationParameters & parameters,
                       const std::vector<Vector> &    points,
                       const TetrahedralMesh &        mesh,
                       OptimizationReport &           report)
    : m_Indicators(indicators)
    , m_Exterior(exterior)
    , m_Cells(cells)
    , m_Parameters(parameters)
    , m_Points(points)
    , m_Complex(mesh, points.size())
    , m_Report(report)
  {}

  /** Works on all tetrahedra below a quality, worst first. Returns the number of changes. */
  std::size_t
  Improve(double quality)
  {
    std::vector<std::pair<double, Id>> bad;
    for (Id t = 0; t < m_Complex.Size(); ++t)
    {
      if (m_Complex.IsAlive(t))
      {
        const double q = this->Quality(m_Complex.Corners(t));
        if (q < quality)
        {
          bad.push_back({ q, t });
        }
      }
    }
    std::sort(bad.begin(), bad.end());
    std::size_t changes = 0;
    for (const auto & entry : bad)
    {
      const Id t = entry.second;
      // its place may have been taken by another one since
      if (m_Complex.IsAlive(t) && this->Quality(m_Complex.Corners(t)) < quality)
      {
        changes += this->ImproveTetrahedron(t);
      }
    }
    return changes;
  }

  TetrahedralMesh
  GetMesh() const
  {
    return m_Complex.GetMesh();
  }

private:
  double
  Quality(const Tetrahedron & t) const
  {
    return DihedralQuality(m_Points[t[0]], m_Points[t[1]], m_Points[t[2]], m_Points[t[3]]);
  }

  double
  WorstOf(const std::vector<Id> & tetrahedra) const
  {
    double worst = 2.0;
    for (const Id t : tetrahedra)
    {
      worst = std::min(worst, this->Quality(m_Complex.Corners(t)));
    }
    return worst;
  }

  bool
  ImproveTetrahedron(Id t)
  {
    const Tetrahedron corners = m_Complex.Corners(t);
    if (this->GiveToOtherSide(t))
    {
      return true;
    }
    for (const auto & edge : TetrahedronEdges)
    {
      if (this->RemoveEdge(t, corners[edge[0]], corners[edge[1]]))
      {
        return true;
      }
    }
    for (int f = 0; f < 4; ++f)
    {
      if (this->RemoveFace(t, f))
      {
        return true;
      }
    }
    for (const auto & edge : TetrahedronEdges)
    {
      if (this->Collapse(t, corners[edge[0]], corners[edge[1]]) || this->Collapse(t, corners[edge[1]], corners[edge[0]]))
      {
        return true;
      }
    }
    return false;
  }

  /** The material beyond a face, which is the exterior outside of the mesh. */
  Material
  MaterialBeyond(Id t, int face) const
  {
    const Id other = m_Complex.Neighbour(t, face);
    return other == NoTetrahedron ? m_Exterior : m_Complex.MaterialOf(other);
  }

  /** How far the interface of two materials is from a point on it, in units of the smallest voxel spacing. */
  double
  DistanceToInterface(Material a, Material b, const Vector & x, PointId corner) const
  {
    // where the exterior begins at a plane, the plane is the interface
    if (a == m_Exterior || b == m_Exterior)
    {
      if (corner < m_Cells.size())
      {
        for (const Material m : m_Cells[corner])
        {
          if (m_Indicators.IsPlane(m) && std::abs(m_Indicators.PlaneValue(m, x)) < 1e-9)
          {
            return 0.0;
          }
        }
      }
      if (std::size_t(m_Exterior) >= m_Indicators.GetNumberOfMaterials())
      {
        return 1e30;
      }
    }
    return 0.5 * std::abs(m_Indicators.Value(a, x) - m_Indicators.Value(b, x));
  }

  /** Whether all tetrahedra around an edge, but one, have this material; false if the edge lies on the outside. */
  bool
  AllAround(Id t, PointId a, PointId b, Material material)
  {
    m_Complex.GetRing(t, a, b, m_Ring);
    return m_Ring.closed && std::all_of(m_Ring.tetrahedra.begin(), m_Ring.tetrahedra.end(), [&](Id other) {
             return other == t || m_Complex.MaterialOf(other) == material;
           });
  }

  /** A bad tetrahedron with two or three faces on one interface goes to the other material. The shape stays; but two
   * faces that met at a bad angle do not bound the interface any more, and flips can take the tetrahedron apart. */
  bool
  GiveToOtherSide(Id t)
  {
    const Material own = m_Complex.MaterialOf(t);
    const auto     corners = m_Complex.Corners(t);
    int            onInterface[4];
    int            count = 0;
    Material       other = own;
    for (int f = 0; f < 4; ++f)
    {
      const Id beyond = m_Complex.Neighbour(t, f);
      if (beyond == NoTetrahedron)
      {
        return false;
      }
      const Material m = m_Complex.MaterialOf(beyond);
      if (m != own)
      {
        if (count > 0 && m != other)
        {
          return false;
        }
        other = m;
        onInterface[count++] = f;
      }
    }
    if (count != 2)
    {
      return false;
    }
    // the two faces on the interface share an edge, and the two others share the opposite one
    const PointId a = corners[onInterface[0]];
    const PointId b = corners[onInterface[1]];
    PointId       shared[2];
    int           n = 0;
    for (const auto corner : corners)
    {
      if (corner != a && corner != b)
      {
        shared[n++] = corner;
      }
    }
    if (!this->AllAround(t, shared[0], shared[1], other) || !this->AllAround(t, a, b, own))
    {
      return false;
    }
    const Vector before = 0.5 * (m_Points[shared[0]] + m_Points[shared[1]]);
    const Vector after = 0.5 * (m_Points[a] + m_Points[b]);
    const double was = this->DistanceToInterface(own, other, before, shared[0]);
    const double is = this->DistanceToInterface(own, other, after, a);
    if (is > std::max(was, m_Parameters.interfaceTolerance))
    {
      return false;
    }
    const double worstBefore = std::min(TriangleRadiusRatio(m_Points[shared[0]], m_Points[shared[1]], m_Points[a]),
                                        TriangleRadiusRatio(m_Points[shared[0]], m_Points[shared[1]], m_Points[b]));
    const double worstAfter = std::min(TriangleRadiusRatio(m_Points[a], m_Points[b], m_Points[shared[0]]),
                                       TriangleRadiusRatio(m_Points[a], m_Points[b], m_Points[shared[1]]));
    if (worstAfter < std::min(worstBefore, TriangleFloor))
    {
      return false;
    }
    // only as a step towards taking it apart: with its new side an edge or face of it can go
    m_Complex.SetMaterial(t, other);
    const bool gone = this->RemoveEdge(t, shared[0], shared[1]) || this->RemoveEdgeOrFaceOf(t);
    if (!gone)
    {
      m_Complex.SetMaterial(t, own);
      return false;
    }
    ++m_Report.relabelled;
    return true;
  }

  bool
  RemoveEdgeOrFaceOf(Id t)
  {
    const auto corners = m_Complex.Corners(t);
    for (const auto & edge : TetrahedronEdges)
    {
      if (this->RemoveEdge(t, corners[edge[0]], corners[edge[1]]))
      {
        return true;
      }
    }
    for (int f = 0; f < 4; ++f)
    {
      if (this->RemoveFace(t, f))
      {
        return true;
      }
    }
    return false;
  }

  /** The best triangulation of a polygon around the edge ab: each triangle makes a tetrahedron with a and one with b.
   * Returns the worst quality, and appends the triangles. */
  double
  TriangulateLink(const std::vector<PointId> & polygon,
                  PointId                      a,
                  PointId                      b,
                  double                       enough,
                  std::vector<Triangle> &      triangles) const
  {
    const int n = int(polygon.size());
    double    best[LongestRing + 1][LongestRing + 1];
    int       middle[LongestRing + 1][LongestRing + 1];
    for (int i = 0; i + 1 < n; ++i)
    {
      best[i][i + 1] = 2.0;
    }
    for (int length = 2; length < n; ++length)
    {
      for (int i = 0; i + length < n; ++i)
      {
        const int k = i + length;
        best[i][k] = -2.0;
        middle[i][k] = i + 1;
        for (int j = i + 1; j < k; ++j)
        {
          double q = std::min(best[i][j], best[j][k]);
          if (q > best[i][k] && q > enough)
          {
            q = std::min(q, this->Quality({ { polygon[i], polygon[j], polygon[k], b } }));
            if (q > best[i][k])
            {
              q = std::min(q, this->Quality({ { polygon[k], polygon[j], polygon[i], a } }));
            }
          }
          if (q > best[i][k])
          {
            best[i][k] = q;
            middle[i][k] = j;
          }
        }
      }
    }
    std::vector<std::pair<int, int>> stack{ { 0, n - 1 } };
    while (!stack.empty())
    {
      const auto span = stack.back();
      stack.pop_back();
      if (span.second - span.first < 2)
      {
        continue;
      }
      const int j = middle[span.first][span.second];
      triangles.push_back({ { polygon[span.first], polygon[j], polygon[span.second] } });
      stack.push_back({ span.first, j });
      stack.push_back({ j, span.second });
    }
    return best[0][n - 1];
  }

  /** Takes the edge ab out: the tetrahedra around it are replaced by two for each triangle of their link. On an
   * interface of two materials the surface's edge is flipped, from ab to the link's two points on the interface. */
  bool
  RemoveEdge(Id t, PointId a, PointId b)
  {
    m_Complex.GetRing(t, a, b, m_Ring);
    const auto & ring = m_Ring.tetrahedra;
    const int    count = int(ring.size());
    if (count > LongestRing - 2 || (m_Ring.closed && count < 3))
    {
      return false;
    }
    // the link turns counterclockwise as seen from b, or the other way round: find out
    std::vector<PointId> link = m_Ring.link;
    std::vector<Material> materials;
    for (const Id r : ring)
    {
      materials.push_back(m_Complex.MaterialOf(r));
    }
    const double before = this->WorstOf(ring);
    if (before < -0.5)
    {
      return false;
    }
    if (TetrahedronVolume(m_Points[a], m_Points[b], m_Points[link[0]], m_Points[link[1]]) < 0.0)
    {
      std::swap(a, b);
    }
    // link point n lies between tetrahedra n - 1 and n: there is an interface where their materials differ
    std::vector<int> cuts;
    if (m_Ring.closed)
    {
      for (int n = 0; n < count; ++n)
      {
        if (materials[n] != materials[(n + count - 1) % count])
        {
          cuts.push_back(n);
        }
      }
    }
    else
    {
      cuts = { 0, count };
      for (int n = 1; n < count; ++n)
      {
        if (materials[n] != materials[n - 1])
        {
          return false;
        }
      }
    }
    std::vector<Element>  fresh;
    std::vector<Triangle> triangles;
    double                after = 2.0;
    const auto            add = [&](const std::vector<PointId> & polygon, Material material) {
      if (polygon.size() < 3)
      {
        after = -2.0;
        return;
      }
      triangles.clear();
      after = std::min(after, this->TriangulateLink(polygon, a, b, before + LeastGain, triangles));
      for (const auto & triangle : triangles)
      {
        fresh.push_back({ { { triangle[0], triangle[1], triangle[2], b } }, material });
        fresh.push_back({ { { triangle[2], triangle[1], triangle[0], a } }, material });
      }
    };
    if (cuts.empty())
    {
      add(link, materials[0]);
    }
    else if (cuts.size() == 2)
    {
      const PointId c = link[cuts[0]];
      const PointId d = link[cuts[1]];
      const Material one = materials[cuts[0]];
      const Material two = m_Ring.closed ? materials[cuts[1] % count] : m_Exterior;
      if (!this->MayFlip(a, b, c, d, one, two) || (!m_Ring.closed && this->AreNeighbours(c, d)))
      {
        return false;
      }
      add(std::vector<PointId>(link.begin() + cuts[0], link.begin() + cuts[1] + 1), one);
      if (m_Ring.closed && after > before)
      {
        std::vector<PointId> polygon(link.begin() + cuts[1], link.end());
        polygon.insert(polygon.end(), link.begin(), link.begin() + cuts[0] + 1);
        add(polygon, two);
      }
    }
    else
    {
      return false;
    }
    if (!(after > before + LeastGain))
    {
      return false;
    }
    const std::vector<Id> old = ring;
    m_Complex.Replace(old, fresh, m_Ids);
    ++(cuts.empty() ? m_Report.flips : m_Report.interfaceFlips);
    return true;
  }

  bool
  AreNeighbours(PointId p, PointId q)
  {
    m_Complex.GetStar(p, m_Star);
    return std::any_of(m_Star.begin(), m_Star.end(), [&](Id t) {
      const auto & corners = m_Complex.Corners(t);
      return std::find(corners.begin(), corners.end(), q) != corners.end();
    });
  }

  /** Whether the edge ab of an interface may become cd. */
  bool
  MayFlip(PointId a, PointId b, PointId c, PointId d, Material one, Material two) const
  {
    const Vector & pa = m_Points[a];
    const Vector & pb = m_Points[b];
    const Vector & pc = m_Points[c];
    const Vector & pd = m_Points[d];
    const double   was = this->DistanceToInterface(one, two, 0.5 * (pa + pb), a);
    const double   is = this->DistanceToInterface(one, two, 0.5 * (pc + pd), c);
    if (is > std::max(was, m_Parameters.interfaceTolerance))
    {
      return false;
    }
    // no fold, and no worse triangles than are allowed
    const Vector n1 = (pb - pa).cross(pc - pa);
    const Vector n2 = (pd - pa).cross(pb - pa);
    const Vector m1 = (pd - pa).cross(pc - pa);
    const Vector m2 = (pc - pb).cross(pd - pb);
    if (m1.dot(m2) <= 0.0 || m1.dot(n1 + n2) <= 0.0 || m2.dot(n1 + n2) <= 0.0)
    {
      return false;
    }
    const double worstBefore = std::min(TriangleRadiusRatio(pa, pb, pc), TriangleRadiusRatio(pa, pb, pd));
    const double worstAfter = std::min(TriangleRadiusRatio(pa, pc, pd), TriangleRadiusRatio(pb, pc, pd));
    return worstAfter >= std::min(worstBefore, TriangleFloor);
  }

  /** Two tetrahedra of one material become three around a new edge. */
  bool
  RemoveFace(Id t, int face)
  {
    if (m_Complex.IsInterface(t, face))
    {
      return false;
    }
    const Id       other = m_Complex.Neighbour(t, face);
    const auto     corners = m_Complex.Corners(t);
    const PointId  top = corners[face];
    PointId        bottom = top;
    for (const auto corner : m_Complex.Corners(other))
    {
      if (std::find(corners.begin(), corners.end(), corner) == corners.end())
      {
        bottom = corner;
      }
    }
    const double before = std::min(this->Quality(corners), this->Quality(m_Complex.Corners(other)));
    std::vector<Element> fresh;
    for (int c = 0; c < 3; ++c)
    {
      const PointId     u = corners[TetrahedronFaces[face][c]];
      const PointId     v = corners[TetrahedronFaces[face][(c + 1) % 3]];
      const Tetrahedron candidate{ { u, v, bottom, top } };
      if (!(this->Quality(candidate) > before + LeastGain))
      {
        return false;
      }
      fresh.push_back({ candidate, m_Complex.MaterialOf(t) });
    }
    m_Complex.Replace({ t, other }, fresh, m_Ids);
    ++m_Report.flips;
    return true;
  }

  /** The materials around a point, sorted, with the exterior where it lies on the outside of the mesh. */
  std::vector<Material>
  MaterialsAround(PointId p, const std::vector<Id> & star) const
  {
    std::vector<Material> around;
    for (const Id t : star)
    {
      around.push_back(m_Complex.MaterialOf(t));
      for (int f = 0; f < 4; ++f)
      {
        if (m_Complex.Corners(t)[f] != p && m_Complex.Neighbour(t, f) == NoTetrahedron)
        {
          around.push_back(m_Exterior);
        }
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  /** Pulls point u into point v. A point of the interior may go anywhere; one of a surface along the surface. */
  bool
  Collapse(Id t, PointId u, PointId v)
  {
    m_Complex.GetStar(u, m_Star);
    if (m_Star.size() > 60)
    {
      return false;
    }
    const auto aroundU = this->MaterialsAround(u, m_Star);
    if (aroundU.size() > 2)
    {
      return false; // on a junction
    }
    if (aroundU.size() == 2)
    {
      if (u >= m_Cells.size() || m_Cells[u].Dimension() != 2 || v >= m_Cells.size() ||
          !m_Cells[v].Includes(m_Cells[u]) || !this->MayCollapseOnInterface(t, u, v, aroundU))
      {
        return false;
      }
    }
    const double before = this->WorstOf(m_Star);
    std::vector<Element> fresh;
    for (const Id s : m_Star)
    {
      Tetrahedron corners = m_Complex.Corners(s);
      if (std::find(corners.begin(), corners.end(), v) != corners.end())
      {
        continue;
      }
      std::replace(corners.begin(), corners.end(), u, v);
      if (!(this->Quality(corners) > before + LeastGain))
      {
        return false;
      }
      fresh.push_back({ corners, m_Complex.MaterialOf(s) });
    }
    if (!this->LinksMeetInRing(t, u, v))
    {
      return false;
    }
    const std::vector<Id> old = m_Star;
    m_Complex.Replace(old, fresh, m_Ids);
    ++m_Report.collapses;
    return true;
  }

  /** The link condition: the points and edges that lie opposite both u and v are those of the ring around uv. */
  bool
  LinksMeetInRing(Id t, PointId u, PointId v)
  {
    m_Complex.GetRing(t, u, v, m_Ring);
    m_Complex.GetStar(v, m_OtherStar);
    using Edge = std::array<PointId, 2>;
    const auto linkOf = [&](PointId p, const std::vector<Id> & star) {
      std::vector<Edge> link; // a point is listed as an edge to itself
      for (const Id s : star)
      {
        const auto & corners = m_Complex.Corners(s);
        for (int a = 0; a < 4; ++a)
        {
          for (int b = a; b < 4; ++b)
          {
            if (corners[a] != p && corners[b] != p)
            {
              link.push_back({ { std::min(corners[a], corners[b]), std::max(corners[a], corners[b]) } });
            }
          }
        }
      }
      std::sort(link.begin(), link.end());
      link.erase(std::unique(link.begin(), link.end()), link.end());
      return link;
    };
    const auto        ofU = linkOf(u, m_Star);
    const auto        ofV = linkOf(v, m_OtherStar);
    std::vector<Edge> common;
    std::set_intersection(ofU.begin(), ofU.end(), ofV.begin(), ofV.end(), std::back_inserter(common));
    return common.size() == m_Ring.link.size() + m_Ring.tetrahedra.size();
  }

  /** Whether point u of a surface may slide into v: the edge lies on the surface, the surface's own links meet in two
   * points only, and its new triangles are good, unfolded and near the zero set. */
  bool
  MayCollapseOnInterface(Id t, PointId u, PointId v, const std::vector<Material> & materials)
  {
    m_Complex.GetRing(t, u, v, m_Ring);
    int  cuts = m_Ring.closed ? 0 : 2;
    const int count = int(m_Ring.tetrahedra.size());
    for (int n = m_Ring.closed ? 0 : 1; n < count; ++n)
    {
      cuts += m_Complex.MaterialOf(m_Ring.tetrahedra[n]) != m_Complex.MaterialOf(m_Ring.tetrahedra[(n + count - 1) % count]);
    }
    if (cuts != 2)
    {
      return false;
    }
    const auto fanPoints = [&](PointId p, const std::vector<Id> & star, std::vector<std::array<PointId, 2>> * fan) {
      std::vector<PointId> points;
      for (const Id s : star)
      {
        for (int f = 0; f < 4; ++f)
        {
          const auto & corners = m_Complex.Corners(s);
          const Id     other = m_Complex.Neighbour(s, f);
          if (corners[f] == p || !m_Complex.IsInterface(s, f) ||
              (other != NoTetrahedron && m_Complex.MaterialOf(other) < m_Complex.MaterialOf(s)))
          {
            continue;
          }
          PointId face[3];
          for (int c = 0; c < 3; ++c)
          {
            face[c] = corners[TetrahedronFaces[f][c]];
          }
          for (int c = 0; c < 3; ++c)
          {
            if (face[c] == p)
            {
              points.push_back(face[(c + 1) % 3]);
              points.push_back(face[(c + 2) % 3]);
              if (fan)
              {
                fan->push_back({ { face[(c + 1) % 3], face[(c + 2) % 3] } });
              }
            }
          }
        }
      }
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
      return points;
    };
    m_Complex.GetStar(v, m_OtherStar);
    std::vector<std::array<PointId, 2>> fan;
    const auto                          ofU = fanPoints(u, m_Star, &fan);
    const auto                          ofV = fanPoints(v, m_OtherStar, nullptr);
    std::vector<PointId>                common;
    std::set_intersection(ofU.begin(), ofU.end(), ofV.begin(), ofV.end(), std::back_inserter(common));
    if (common.size() != 2)
    {
      return false;
    }
    for (const auto & edge : fan)
    {
      if (edge[0] == v || edge[1] == v)
      {
        continue;
      }
      const Vector & p = m_Points[edge[0]];
      const Vector & q = m_Points[edge[1]];
      const Vector   before = (p - m_Points[u]).cross(q - m_Points[u]);
      const Vector   after = (p - m_Points[v]).cross(q - m_Points[v]);
      if (before.dot(after) <= 0.5 * before.norm() * after.norm() ||
          TriangleRadiusRatio(m_Points[v], p, q) < TriangleFloor ||
          this->DistanceToInterface(materials[0], materials[1], (p + q + m_Points[v]) / 3.0, edge[0]) >
            m_Parameters.interfaceTolerance)
      {
        return false;
      }
    }
    return true;
  }

  const IndicatorSet &           m_Indicators;
  const Material                 m_Exterior;
  const std::vector<Cell> &      m_Cells;
  const OptimizationParameters & m_Parameters;
  const std::vector<Vector> &    m_Points;
  TetrahedralComplex             m_Complex;
  OptimizationReport &           m_Report;
  TetrahedralComplex::Ring       m_Ring;
  std::vector<Id>                m_Star;
  std::vector<Id>                m_OtherStar;
  std::vector<Id>                m_Ids;
};
} // namespace

OptimizationReport
OptimizeMesh(const IndicatorSet &           indicators,
             Material                       exterior,
             const std::vector<Cell> &      cells,
             const OptimizationParameters & parameters,
             std::vector<Vector> &          points,
             TetrahedralMesh &              mesh,
             Monitor &                      monitor)
{
  OptimizationReport report;
  const double       quality = QualityOfAngle(parameters.angle);
  {
    PointSmoother smoother(indicators, exterior, cells, points, mesh.tetrahedra, mesh.materials);
    for (int sweep = 0; sweep < parameters.sweeps; ++sweep)
    {
      report.moves += smoother.SmoothAll();
      monitor.Report(0.3 * (sweep + 1) / parameters.sweeps);
    }
  }
  for (int round = 0; round < parameters.rounds; ++round)
  {
    std::size_t changes = 0;
    {
      ConnectivityImprover improver(indicators, exterior, cells, parameters, points, mesh, report);
      changes = improver.Improve(quality);
      mesh = improver.GetMesh();
    }
    PointSmoother     smoother(indicators, exterior, cells, points, mesh.tetrahedra, mesh.materials);
    const std::size_t moves = smoother.SmoothWorst(quality);
    report.moves += moves;
    report.rounds = round + 1;
    monitor.Report(0.3 + 0.7 * (round + 1) / parameters.rounds);
    if (changes + moves == 0)
    {
      break;
    }
  }
  return report;
}
} // namespace mmm
