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
#include "phantom/HeadPhantomFolds.h"
#include "phantom/HeadPhantomShapes.h"

#include <array>

namespace mmm::phantom
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double halfWidth = 0.9;

constexpr int waveCount = 11;

struct Wave
{
  Vector direction;
  double phase;
};

/** Directions spread over a half sphere by the golden angle, with phases that have no pattern. */
std::array<Wave, waveCount>
MakeWaves()
{
  std::array<Wave, waveCount> waves;
  for (int i = 0; i < waveCount; ++i)
  {
    const double height = (i + 0.5) / waveCount;
    const double azimuth = 2.39996322972865332 * i;
    const double radius = std::sqrt(1.0 - height * height);
    waves[i].direction = Vector(radius * std::cos(azimuth), radius * std::sin(azimuth), height);
    waves[i].phase = std::fmod(4.7 * i * i + 1.3 * i, 2.0 * pi);
  }
  return waves;
}

/** Distance to the nearest zero of a sum of plane waves of one wavelength: meandering sheets, like those of sulci. */
double
Meanders(const Vector & point, double wavelength)
{
  static const std::array<Wave, waveCount> waves = MakeWaves();
  const double                             number = 2.0 * pi / wavelength;
  double                                   value = 0.0;
  Vector                                   gradient = Vector::Zero();
  for (const Wave & wave : waves)
  {
    const double argument = number * wave.direction.dot(point) + wave.phase;
    value += std::cos(argument);
    gradient -= number * std::sin(argument) * wave.direction;
  }
  // The constant keeps the quotient tame where the gradient vanishes; sheets get a little wider there.
  const double smallSlope = 0.4 * number * std::sqrt(0.5 * waveCount);
  return std::abs(value) / std::sqrt(gradient.squaredNorm() + smallSlope * smallSlope);
}

/** Corpus callosum, thalami and what else joins the hemispheres, in the median plane. */
double
Commissures(const Vector & point)
{
  return Ellipsoid(Vector(0, point[1], point[2]), Vector(0, 6, 3), Vector(1000, 37, 24));
}
} // namespace

double
MidlineFissures(const Vector & point)
{
  const double bend = 1.2 * std::sin(0.07 * point[1] + 0.05 * point[2]);
  const double off = std::abs(point[0] - bend);
  const double joined = Commissures(point);
  const double fissure = std::hypot(off, Excess(-joined));
  const double cingulate =
    std::hypot(joined - 10 - 0.35 * off - 1.5 * std::sin(0.2 * point[1] + 0.15 * point[2]), Excess(off - 12));
  return std::min(fissure, std::hypot(cingulate, Excess(-10 - point[2]))) - halfWidth;
}

double
LateralFissure(const Vector & point)
{
  const Vector left = MirrorToLeft(point);
  const double along = left[1];
  const double across = 0.95 * (left[2] + 4 - 0.3 * along) - 1.5 * std::sin(0.12 * along);
  // Anteriorly it runs round the temporal pole towards the midline.
  const double bottom = 40 - 24 * SmoothStep(20, 46, -along);
  const double cleft = std::hypot(across, Excess(bottom - left[0]), Excess(along - 36));
  const double insula = std::hypot(left[0] - 40, Excess(std::abs(across) - 12), Excess(std::abs(along + 2) - 26));
  return std::min(cleft, insula) - halfWidth;
}

double
Sulci(const Vector & point, double depth)
{
  // Projected on a rounded box about a core, the sheets are upright everywhere and do not taper with depth; they sway
  // a little on the way down.
  const Vector core = point.cwiseMax(Vector(-22, -42, -6)).cwiseMin(Vector(22, 46, 14));
  const Vector outward = point - core;
  const double distance = std::max(outward.norm(), 1.0);
  const Vector sway(std::sin(0.17 * point[1] + 1), std::sin(0.19 * point[2] + 2), std::sin(0.18 * point[0]));
  const Vector surface = core + 45 / distance * outward + 2.0 * sway;
  const double depthHere =
    15 + 5 * std::sin(0.09 * surface[0] + 1) * std::sin(0.08 * surface[1]) * std::cos(0.085 * surface[2]);
  // The flat base of the frontal lobes is too close to the core for folds, and next to it the projection magnifies.
  const double fold = depthHere * SmoothStep(20, 32, distance + depth) * SmoothStep(10, 22, distance);
  const double unmagnified = std::min(distance / 27, 1.0) * Meanders(surface, 22);
  return std::hypot(unmagnified, Excess(depth - fold)) - halfWidth;
}

double
Folia(const Vector & point, double depth)
{
  const double     y = point[1] - 24;
  const double     z = point[2] + 33;
  const double     angle = std::atan2(z, y) + 0.04 * std::sin(0.12 * point[0]);
  constexpr double step = 0.2;
  const double     offset = std::abs(angle - step * (std::floor(angle / step) + 0.5));
  return std::hypot(offset * std::hypot(y, z), Excess(depth - 10)) - halfWidth;
}
} // namespace mmm::phantom
