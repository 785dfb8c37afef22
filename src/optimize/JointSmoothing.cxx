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
#include "base/Hash.h"
#include "optimize/PointSmoother.h"
#include "optimize/ShapeQuality.h"
#include "mesh/TriangleLookup.h"

#include <algorithm>
#include <utility>

namespace mmm
{
namespace
{
/** Nothing is worse. */
constexpr double NoLimit = -1e300;
/** A number in [-1, 1). */
double
Draw(std::uint64_t & state)
{
  state = Hash(state);
  return double(state >> 11) * 0x1p-52 - 1.0;
}
} // namespace

/** How the worst tetrahedron and the worst triangle around some points are: 1 on the verge of poor, what is well beyond
 * that counts alike. The search ends early where one of them is below `enough`. */
PointSmoother::Worth
PointSmoother::WorthAround(const std::vector<PointId> & points, double poorQuality, const Worth & enough) const
{
  Worth worth{ OptimizationParameters::JointGoal, OptimizationParameters::JointGoal };
  for (const PointId p : points)
  {
    worth.triangle = std::min(worth.triangle, this->WorstTriangleAround(p, m_Points[p]) / m_Parameters.flatTriangle);
    if (worth.triangle < enough.triangle)
    {
      return worth;
    }
  }
  for (const PointId p : points)
  {
    worth.tetrahedron = std::min(
      worth.tetrahedron,
      this->WorstAround(p, m_Points[p], (enough.tetrahedron - OptimizationParameters::NegligibleLoss) * poorQuality) /
        poorQuality);
    if (worth.tetrahedron < enough.tetrahedron)
    {
      return worth;
    }
  }
  return worth;
}

/** Tries places of all of some points at once. Returns whether what is around them got better. */
bool
PointSmoother::MoveTogether(const std::vector<PointId> & corners, double poorQuality)
{
  struct Limit
  {
    std::vector<Material> materials;
    double                distance;
  };
  std::vector<PointId> points;
  std::vector<Limit>   limits;
  double               size = 0.0;
  for (const PointId p : corners)
  {
    size = std::max(size, (m_Points[p] - m_Points[corners[0]]).norm());
    Vector onCell = m_Points[p];
    if (m_Freedom[p] == Freedom::Fixed || (m_Freedom[p] == Freedom::OnCell && !m_Constraint.Project(p, onCell)))
    {
      continue;
    }
    Limit limit{ {}, (m_Points[p] - onCell).norm() };
    if (m_Freedom[p] == Freedom::NearInterfaces)
    {
      limit.materials = this->MaterialsAround(p);
      limit.distance = this->DistanceFromInterfaces(limit.materials, p, m_Points[p]);
    }
    limit.distance = std::max(limit.distance, m_Parameters.interfaceTolerance);
    points.push_back(p);
    limits.push_back(std::move(limit));
  }
  const auto place = [&](std::size_t n, Vector x) {
    const PointId p = points[n];
    const bool    isThere = m_Freedom[p] == Freedom::NearInterfaces
                              ? this->DistanceFromInterfaces(limits[n].materials, p, x) <= limits[n].distance
                              : this->Admit(p, x, limits[n].distance);
    m_Points[p] = isThere ? x : m_Points[p];
  };
  bool                hasMoved = false;
  Worth               worth = this->WorthAround(points, poorQuality, { NoLimit, NoLimit });
  std::uint64_t       state = corners[0];
  std::vector<Vector> before(points.size());
  for (int trial = 0; trial < OptimizationParameters::JointTrials &&
                      std::min(worth.triangle, worth.tetrahedron) < OptimizationParameters::JointGoal;
       ++trial)
  {
    const double step = OptimizationParameters::LongestJointMove * size * std::abs(Draw(state));
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      before[n] = m_Points[points[n]];
      const double x = Draw(state);
      const double y = Draw(state);
      const double z = Draw(state);
      place(n, before[n] + step * Vector(x, y, z));
    }
    const Worth reached = this->WorthAround(points, poorQuality, worth);
    if (reached.triangle >= worth.triangle && reached.tetrahedron >= worth.tetrahedron &&
        (reached.triangle > worth.triangle || reached.tetrahedron > worth.tetrahedron))
    {
      worth = reached;
      hasMoved = true;
      continue;
    }
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      m_Points[points[n]] = before[n];
    }
  }
  return hasMoved;
}

std::size_t
PointSmoother::SmoothJointly()
{
  const double poorQuality = QualityOfAngle(m_Parameters.angleToKeepBesideTriangles);
  std::size_t  moves = 0;
  for (std::uint32_t t = 0; t < m_Tetrahedra.size(); ++t)
  {
    if (this->IsExterior(t))
    {
      continue;
    }
    const auto & c = m_Tetrahedra[t];
    if (ShapeQuality(m_Points[c[0]], m_Points[c[1]], m_Points[c[2]], m_Points[c[3]]) < poorQuality)
    {
      moves += this->MoveTogether({ c.begin(), c.end() }, poorQuality);
    }
    for (int f = 0; f < 4; ++f)
    {
      const Triangle face = FaceOf(c, f);
      if (m_Complex.IsInterface(t, f) &&
          TriangleRadiusRatio(m_Points[face[0]], m_Points[face[1]], m_Points[face[2]]) < m_Parameters.flatTriangle)
      {
        moves += this->MoveTogether({ face.begin(), face.end() }, poorQuality);
      }
    }
  }
  return moves;
}
} // namespace mmm
