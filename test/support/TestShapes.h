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
#ifndef mmmTestShapes_h
#define mmmTestShapes_h

#include "base/Grid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

/** Solids whose surface, volume and local feature size are known, to measure digitized ones against. */
namespace mmmtest
{
/** Points spread evenly over the unit sphere. */
inline std::vector<mmm::Vector>
SpherePoints(int count)
{
  std::vector<mmm::Vector> points;
  for (int n = 0; n < count; ++n)
  {
    const double z = 1.0 - (2.0 * n + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    const double angle = 2.399963229728653 * n;
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return points;
}

/** A way from within a solid through its surface, which is `length` away. The rays of a solid sweep all of it. */
struct SurfaceRay
{
  mmm::Vector origin;
  mmm::Vector direction;
  double      length;
  /** The share of the volume that a ray stands for is a * t^2 + b * t^3, if the surface is t times as far away. */
  double squareShare;
  double cubicShare;
};

class Solid
{
public:
  Solid(const mmm::Vector & centre, const Eigen::Matrix3d & rotation)
    : m_Centre(centre)
    , m_Rotation(rotation)
  {}
  virtual ~Solid() = default;

  virtual double
  Volume() const = 0;

  bool
  Contains(const mmm::Vector & x) const
  {
    return this->Distance(x) < 0.0;
  }
  /** The signed distance to the surface, negative inside; exact on the surface and to first order near it. */
  double
  Distance(const mmm::Vector & x) const
  {
    return this->LocalDistance(m_Rotation.transpose() * (x - m_Centre));
  }
  /** The outward normal of the surface nearest to x. */
  mmm::Vector
  Normal(const mmm::Vector & x) const
  {
    constexpr double step = 1e-5;
    mmm::Vector      gradient;
    for (int a = 0; a < 3; ++a)
    {
      const mmm::Vector d = step * mmm::Vector::Unit(a);
      gradient[a] = this->Distance(x + d) - this->Distance(x - d);
    }
    return gradient.normalized();
  }
  std::vector<SurfaceRay>
  Rays(int count) const
  {
    auto rays = this->LocalRays(count);
    for (auto & ray : rays)
    {
      ray.origin = m_Centre + m_Rotation * ray.origin;
      ray.direction = m_Rotation * ray.direction;
    }
    return rays;
  }

protected:
  virtual double
  LocalDistance(const mmm::Vector & x) const = 0;
  virtual std::vector<SurfaceRay>
  LocalRays(int count) const = 0;

private:
  mmm::Vector     m_Centre;
  Eigen::Matrix3d m_Rotation;
};

class Ellipsoid : public Solid
{
public:
  Ellipsoid(const mmm::Vector & centre, const Eigen::Matrix3d & rotation, const mmm::Vector & semiaxes)
    : Solid(centre, rotation)
    , m_Semiaxes(semiaxes)
  {}

  double
  Volume() const override
  {
    return 4.0 / 3.0 * EIGEN_PI * m_Semiaxes.prod();
  }

protected:
  double
  LocalDistance(const mmm::Vector & x) const override
  {
    const mmm::Vector scaled = x.cwiseQuotient(m_Semiaxes);
    const double      radius = scaled.norm();
    const double      slope = scaled.cwiseQuotient(m_Semiaxes).norm();
    return slope > 0.0 ? (radius - 1.0) * radius / slope : -m_Semiaxes.minCoeff();
  }
  std::vector<SurfaceRay>
  LocalRays(int count) const override
  {
    std::vector<SurfaceRay> rays;
    for (const auto & point : SpherePoints(count))
    {
      const mmm::Vector end = point.cwiseProduct(m_Semiaxes);
      rays.push_back({ mmm::Vector::Zero(), end.normalized(), end.norm(), 0.0, 1.0 / count });
    }
    return rays;
  }

private:
  mmm::Vector m_Semiaxes;
};

class Torus : public Solid
{
public:
  Torus(const mmm::Vector & centre, const Eigen::Matrix3d & rotation, double major, double minor)
    : Solid(centre, rotation)
    , m_Major(major)
    , m_Minor(minor)
  {}

  double
  Volume() const override
  {
    return 2.0 * EIGEN_PI * EIGEN_PI * m_Major * m_Minor * m_Minor;
  }

protected:
  double
  LocalDistance(const mmm::Vector & x) const override
  {
    return std::hypot(std::hypot(x[0], x[1]) - m_Major, x[2]) - m_Minor;
  }
  std::vector<SurfaceRay>
  LocalRays(int count) const override
  {
    const int               around = int(std::sqrt(count));
    std::vector<SurfaceRay> rays;
    for (int n = 0; n < around * around; ++n)
    {
      const double      u = 2.0 * EIGEN_PI * (n % around) / around;
      const double      v = 2.0 * EIGEN_PI * (n / around + 0.5) / around;
      const mmm::Vector out(std::cos(u), std::sin(u), 0.0);
      const mmm::Vector across = std::cos(v) * out + std::sin(v) * mmm::Vector::UnitZ();
      const double      cubic = 2.0 * m_Minor * std::cos(v) / (3.0 * m_Major);
      rays.push_back({ m_Major * out, across, m_Minor, 1.0 / (around * around), cubic / (around * around) });
    }
    return rays;
  }

private:
  double m_Major;
  double m_Minor;
};

/** A rotation drawn at random. */
template <typename TRandom>
Eigen::Matrix3d
RandomRotation(TRandom & random)
{
  std::normal_distribution<double> normal;
  Eigen::Quaterniond               q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

/** A vector with each component between -0.5 and 0.5, drawn at random. */
template <typename TRandom>
mmm::Vector
RandomOffset(TRandom & random)
{
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  return mmm::Vector(unit(random), unit(random), unit(random));
}
} // namespace mmmtest

#endif
