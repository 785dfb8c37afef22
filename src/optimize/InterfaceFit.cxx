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
#include "optimize/InterfaceFit.h"

#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "optimize/ComplexDefects.h"
#include "optimize/PointSmoother.h"
#include "mesh/TetrahedronRaster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mmm
{
namespace
{
using Parameters = InterfaceFitParameters;
using Floor = Parameters::Floor;

constexpr std::size_t Grain = 1024;
/** The depth of a centre that has no tetrahedron of its material nearby. */
constexpr double NoSuchTetrahedron = 1e3;

/** How far x is from a tetrahedron: the largest distance beyond the plane of a face, negative inside. The search ends
 * early at one that is not below `enough`. */
double
DepthOutside(const std::array<const Vector *, 4> & corners, const Vector & x, double enough)
{
  double depth = -1e300;
  for (const auto & face : TetrahedronFaces)
  {
    const Vector & a = *corners[face[0]];
    const Vector   normal = (*corners[face[1]] - a).cross(*corners[face[2]] - a); // outwards
    depth = std::max(depth, normal.dot(x - a) / normal.norm());
    if (depth >= enough)
    {
      break;
    }
  }
  return depth;
}

class InterfaceFit : private PointSmoother
{
public:
  InterfaceFit(const IndicatorSet &           indicators,
               const InterfaceConstraint &    constraint,
               Material                       exterior,
               const OptimizationParameters & parameters,
               const TetrahedralComplex &     complex,
               std::vector<Vector> &          points,
               Monitor &                      monitor)
    : PointSmoother(constraint, exterior, parameters, points, complex)
    , m_Indicators(indicators)
    , m_Grid(indicators.GetGrid())
    , m_Monitor(monitor)
  {}

  void
  BalanceVolumes()
  {
    std::vector<Vector> moves(m_Points.size());
    for (int pass = 0; pass < Parameters::BalancePasses; ++pass)
    {
      // all gaps first: what the neighbours do about theirs is not to count twice
      ParallelFor(m_Points.size(), Grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
        {
          moves[p] = this->MoveOntoMean(PointId(p));
        }
      });
      this->MoveByColour([&](PointId p) {
        const double length = moves[p].norm();
        const double part = length > Parameters::LongestBalanceMove ? Parameters::LongestBalanceMove / length : 1.0;
        const Vector x = m_Points[p] + part * moves[p];
        return length > 0.0 &&
               (m_Cells[p].count == 2 || this->DistanceFromOwn(p, x) <= m_Parameters.interfaceTolerance) &&
               this->MoveAbove(this->FloorAt(p, Parameters::BalanceFloor), p, x);
      });
      this->ReportPass();
    }
  }

  void
  RecoverVoxelCentres()
  {
    for (int pass = 0; pass < Parameters::CentrePasses; ++pass)
    {
      const auto        isBesideWrong = this->MarkCorners(this->FindTetrahedraOfWrongCentres());
      std::vector<char> hasMoved(m_Points.size(), 0);
      const auto        moves = this->MoveByColour([&](PointId p) {
        hasMoved[p] = isBesideWrong[p] && this->MoveForCentres(p);
        return bool(hasMoved[p]);
      });
      if (moves == 0)
      {
        break;
      }
      const auto isBesideMoved = this->MarkCorners(this->FindTetrahedraOf(hasMoved));
      this->MoveByColour([&](PointId p) { return isBesideMoved[p] && this->MakeRoom(p); });
      this->ReportPass();
    }
  }

private:
  void
  ReportPass()
  {
    m_Monitor.Report(double(++m_PassesDone) / (Parameters::BalancePasses + Parameters::CentrePasses));
  }

  /** The move by which the triangles around p lie on both sides of the zero set in equal parts; none but for points on
   * surfaces, which follow the normal, and where a surface ends at a face of the box, which stay on that face. */
  Vector
  MoveOntoMean(PointId p) const
  {
    const Cell & cell = m_Cells[p];
    const bool   isOnFace = cell.count == 3 && m_Indicators.IsPlane(cell.materials[2]);
    if (m_Freedom[p] != Freedom::OnCell || !(cell.count == 2 || isOnFace) || m_Indicators.IsPlane(cell.materials[1]))
    {
      return Vector::Zero();
    }
    const Cell surface{ cell.materials[0], cell.materials[1] };
    Vector     normal = m_Indicators.Normal(surface, m_Points[p]);
    if (isOnFace)
    {
      const Vector outwards = m_Indicators.Planes().Gradient(cell.materials[2]);
      normal -= normal.dot(outwards) * outwards;
    }
    const double square = normal.squaredNorm();
    return square > Parameters::LeastSquareOnFace ? Vector(this->MeanGap(p, surface) / square * normal)
                                                  : Vector(Vector::Zero());
  }

  /** How far the zero set is from the triangles of a surface around p on average, along its normal. */
  double
  MeanGap(PointId p, const Cell & surface) const
  {
    const Cell & cell = m_Cells[p];
    const auto   gapAt = [&](const Vector & x) {
      return 0.5 * m_Indicators.Difference(surface.materials[0], surface.materials[1], x);
    };
    double sum = 0.0;
    double areas = 0.0;
    for (auto f = m_FanStart[p]; f < m_FanStart[p + 1]; ++f)
    {
      const auto & ends = m_Fan[f];
      if (cell.count == 3 && m_Cells[ends[0]].Has(cell.materials[2]) && m_Cells[ends[1]].Has(cell.materials[2]))
      {
        continue; // it lies on the face of the box
      }
      const Vector & a = m_Points[p];
      const Vector & b = m_Points[ends[0]];
      const Vector & c = m_Points[ends[1]];
      const double   area = (b - a).cross(c - a).norm();
      // the middles of the edges give the mean of a quadratic function
      sum += area * (gapAt(0.5 * (a + b)) + gapAt(0.5 * (a + c)) + gapAt(0.5 * (b + c))) / 3.0;
      areas += area;
    }
    return areas > 0.0 ? sum / areas : 0.0;
  }

  /** What is below the floor already must not get worse. */
  Floor
  FloorAt(PointId p, const Floor & floor) const
  {
    return { std::min(m_Parameters.angleToKeep, floor.angle),
             std::min(this->WorstTriangleAround(p, m_Points[p]), floor.triangle) };
  }

  bool
  MoveAbove(const Floor & floor, PointId p, const Vector & x)
  {
    return this->MoveIfGood(p, x, floor.angle, floor.triangle);
  }

  std::vector<char>
  FindTetrahedraOfWrongCentres() const
  {
    std::vector<char> isWrong(m_Tetrahedra.size(), 0);
    ParallelFor(m_Tetrahedra.size(), Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        VisitIndicesInside(
          m_Grid.size, CornersInVoxels(m_Grid, m_Points, m_Tetrahedra[t]), -Parameters::OnFace, [&](const Index & at) {
            isWrong[t] |= m_Indicators.NodeMaterials()[m_Grid.Offset(at)] != m_Materials[t];
          });
      }
    });
    return isWrong;
  }

  std::vector<char>
  FindTetrahedraOf(const std::vector<char> & points) const
  {
    std::vector<char> found(m_Tetrahedra.size(), 0);
    for (std::size_t t = 0; t < found.size(); ++t)
    {
      const auto & c = m_Tetrahedra[t];
      found[t] = points[c[0]] || points[c[1]] || points[c[2]] || points[c[3]];
    }
    return found;
  }

  /** The grid nodes in the tetrahedra around p, as far as these are meshed, and likewise far outside. */
  std::vector<std::size_t>
  NodesAround(PointId p) const
  {
    double reach = 0.0;
    for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
    {
      for (int c = 0; !this->IsExterior(*s) && c < 4; ++c)
      {
        reach = std::max(reach, (m_Points[m_Tetrahedra[*s][c]] - m_Points[p]).norm());
      }
    }
    Index lower;
    Index upper;
    for (int a = 0; a < 3; ++a)
    {
      lower[a] = std::max(int(std::ceil((m_Points[p][a] - reach) / m_Grid.spacing[a])), 0);
      upper[a] = std::min(int(std::floor((m_Points[p][a] + reach) / m_Grid.spacing[a])), m_Grid.size[a] - 1);
    }
    std::vector<std::size_t> nodes;
    for (auto s = m_Star.Begin(p); s != m_Star.End(p); ++s)
    {
      VisitIndicesInside(
        lower, upper, CornersInVoxels(m_Grid, m_Points, m_Tetrahedra[*s]), Parameters::OnFace, [&](const Index & at) {
          nodes.push_back(m_Grid.Offset(at));
        });
    }
    MakeUnique(nodes);
    return nodes;
  }

  /** How far a centre is from the tetrahedra of its material around p if p is at x; 0 inside of one. */
  double
  DepthOf(std::size_t node, PointId p, const Vector & x) const
  {
    const Material own = m_Indicators.NodeMaterials()[node];
    const Vector   centre = m_Grid.Position(m_Grid.IndexAt(node));
    double         depth = NoSuchTetrahedron;
    for (auto s = m_Star.Begin(p); s != m_Star.End(p) && depth > 0.0; ++s)
    {
      if (m_Materials[*s] == own)
      {
        depth = std::min(depth, DepthOutside(this->CornersWith(*s, p, x), centre, depth));
      }
    }
    return std::max(0.0, depth);
  }

  /** Voxel centres by their grid nodes, those first that lie in a tetrahedron of another material, and their depths in
   * sum. */
  struct Centres
  {
    std::vector<std::size_t> nodes;
    double                   depth{ 0.0 };
  };

  /** The voxel centres around p, none where they are no measure. */
  Centres
  CentresAround(PointId p) const
  {
    Centres    centres;
    const auto nodes = this->NodesAround(p);
    if (nodes.size() > Parameters::MostCentres)
    {
      return centres;
    }
    std::vector<std::size_t> right;
    for (const auto node : nodes)
    {
      const double depth = this->DepthOf(node, p, m_Points[p]);
      centres.depth += depth;
      (depth > 0.0 ? centres.nodes : right).push_back(node);
    }
    centres.nodes.insert(centres.nodes.end(), right.begin(), right.end());
    return centres;
  }

  /** The depths of centres in sum if p is at x; the search ends early at one that is not below `enough`. */
  double
  DepthAt(const Centres & centres, PointId p, const Vector & x, double enough) const
  {
    double sum = 0.0;
    for (std::size_t n = 0; n < centres.nodes.size() && sum < enough; ++n)
    {
      sum += this->DepthOf(centres.nodes[n], p, x);
    }
    return sum;
  }

  /** How far x is from where p belongs: from its cell, or from the interfaces that meet at it. */
  double
  DistanceFromOwn(PointId p, const Vector & x) const
  {
    if (m_Freedom[p] != Freedom::OnCell)
    {
      return this->DistanceFromInterfaces(this->MaterialsAround(p), p, x);
    }
    Vector onCell = x;
    return m_Constraint.Project(p, onCell) ? (x - onCell).norm() : 2.0 * Parameters::Far;
  }

  /** Moves p so that centres around it get nearer to tetrahedra of their material. It stays within the tolerance of
   * where it belongs, or as near to it as it is. */
  bool
  MoveForCentres(PointId p)
  {
    if (!this->IsOnInterface(p) || !m_Constraint.MayLeaveCell(p))
    {
      return false;
    }
    const Centres centres = this->CentresAround(p);
    if (centres.depth == 0.0)
    {
      return false;
    }
    const double distance = this->DistanceFromOwn(p, m_Points[p]);
    if (distance > Parameters::Far)
    {
      return false;
    }
    const double furthest = std::max(m_Parameters.interfaceTolerance, distance);
    const Floor  floor = this->FloorAt(p, Parameters::CentreFloor);
    double       depth = centres.depth;
    return SearchAround(
      Parameters::LongestCentreMove, Parameters::ShortestCentreMove, [&](double step, const Vector & direction) {
        const Vector x = m_Points[p] + step * direction;
        const double enough = depth - Parameters::NegligibleDepth;
        const double reached = this->DepthAt(centres, p, x, enough);
        if (!(reached < enough && this->DistanceFromOwn(p, x) <= furthest && this->MoveAbove(floor, p, x)))
        {
          return false;
        }
        depth = reached;
        return true;
      });
  }

  /** Moves p to where the radius ratios around it are larger on average, now that its neighbours have moved. Centres do
   * not suffer, where they are a measure. */
  bool
  MakeRoom(PointId p)
  {
    if (!this->IsOnInterface(p))
    {
      return this->MoveUphillOnAverage(p, [](Vector &) { return true; });
    }
    if (m_Freedom[p] != Freedom::OnCell)
    {
      return false;
    }
    const double distance = this->DistanceFromOwn(p, m_Points[p]);
    if (distance > Parameters::Far)
    {
      return false;
    }
    const double  triangle = std::min(this->WorstTriangleAround(p, m_Points[p]), Parameters::TriangleFloorOfRoom);
    const bool    mayLeave = m_Constraint.MayLeaveCell(p);
    const double  furthest = std::max(Parameters::RoomOffCell, distance);
    const Centres centres = this->CentresAround(p);
    const double  enough = centres.depth + Parameters::NegligibleDepth;
    return this->MoveUphillOnAverage(p, [&](Vector & x) {
      return (mayLeave ? this->DistanceFromOwn(p, x) <= furthest : this->Admit(p, x, 0.0)) &&
             this->WorstTriangleAround(p, x) >= triangle && this->DepthAt(centres, p, x, enough) < enough;
    });
  }

  const IndicatorSet & m_Indicators;
  const Grid &         m_Grid;
  Monitor &            m_Monitor;
  int                  m_PassesDone{ 0 };
};
} // namespace

void
FitInterfaces(const IndicatorSet &           indicators,
              const InterfaceConstraint &    constraint,
              Material                       exterior,
              const OptimizationParameters & parameters,
              const TetrahedralComplex &     complex,
              std::vector<Vector> &          points,
              Monitor &                      monitor)
{
  InterfaceFit         fit(indicators, constraint, exterior, parameters, complex, points, monitor);
  const SoundnessCheck check(complex, points);
  fit.BalanceVolumes();
  check.AssertSound();
  fit.RecoverVoxelCentres();
  check.AssertSound();
}
} // namespace mmm
