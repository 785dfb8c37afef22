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
#include "phantom/HeadPhantomBrain.h"
#include "phantom/HeadPhantomFolds.h"
#include "phantom/HeadPhantomShapes.h"

namespace mmm
{
namespace phantom
{
namespace
{
constexpr double fluidGap = 1.7;
/** On each side. */
constexpr double tentoriumGap = 0.8;
constexpr double cortexThickness = 3.0;
/** The distances within cerebellum and brainstem are stretched by this, which makes their gray matter thinner. */
constexpr double thinCortex = 1.4;

/** The space below the tentorium, which cerebellum and brainstem share. */
double
PosteriorFossa(const Vector & point)
{
  return Ellipsoid(point, Vector(0, 51, -33), Vector(64, 43, 34));
}

double
BrainstemAndCord(const Vector & point)
{
  const double stem = Rod(point, Vector(0, 12, 0), 13, Vector(0, 32, -60), 8);
  const double cord = Rod(point, Vector(0, 32, -60), 7, Vector(0, 36, -110), 6);
  const double end = Rod(point, Vector(0, 36, -110), 6, Vector(0, 36, -1000), 6);
  const double pons = Ellipsoid(point, Vector(0, 14, -28), Vector(17, 12, 14));
  const double peduncles = Rod(MirrorToLeft(point), Vector(8, 18, -30), 9, Vector(26, 44, -33), 8);
  return SmoothUnion(SmoothUnion(stem, std::min(cord, end), 4), std::min(pons, peduncles), 5);
}

/** Depth below the surface of the cerebrum: the distance to the nearest fluid outside of it. */
double
CerebrumDepth(const Vector & point, double depth)
{
  double result = std::min(depth - fluidGap, PosteriorFossa(point) - tentoriumGap);
  // The sheets of fluid below matter only where they are nearer than the white matter.
  if (result <= 0)
  {
    return result;
  }
  const double fissures = std::min(MidlineFissures(point), LateralFissure(point));
  // Rounded where gyri turn from the surface into a sulcus.
  return SmoothUnion(result, std::min(fissures, Sulci(point, depth)), 2.5);
}

double
CerebellumDepth(const Vector & point, double depth)
{
  const double hemispheres = Ellipsoid(point, Vector(0, 53, -31), Vector(66, 42, 37));
  // The notch below the two hemispheres leaves room for the cisterna magna.
  const double notch = Rod(point, Vector(0, 8, -64), 10, Vector(0, 72, -61), 6);
  const double inside =
    std::min({ depth - fluidGap, -PosteriorFossa(point) - tentoriumGap, -std::max(hemispheres, -notch) });
  return inside <= 0 ? inside : std::min(inside, Folia(point, inside));
}

/** Nuclei: gray matter within the white, joined with each other and with the cortex of the insula. */
double
DeepGrayMatter(const Vector & point)
{
  const Vector left = MirrorToLeft(point);
  const double lentiform = Ellipsoid(left, Vector(27, -2, 2), Vector(11, 20, 11));
  const double thalamus = Ellipsoid(left, Vector(11, 13, 4), Vector(9, 14, 9));
  const double caudate = Rod(left, Vector(15, -24, 11), 5.5, Vector(20, 16, 21), 3);
  const double bridges = std::min(Rod(left, Vector(15, -22, 9), 4, Vector(25, -10, 2), 4),
                                  Rod(left, Vector(12, 6, 0), 3, Vector(24, 2, -2), 3));
  return SmoothUnion(std::min({ lentiform, thalamus, caudate }), bridges, 3);
}
} // namespace

double
PetrousRidge(const Vector & left)
{
  return Rod(left, Vector(64, 24, -46), 13, Vector(16, -4, -42), 9);
}

double
IntracranialSpace(const Vector & point)
{
  const Vector left = MirrorToLeft(point);
  // Wider at the back than at the front.
  const Vector tapered(point[0] / (1.0 + 0.0012 * point[1]), point[1], point[2]);
  const double vault = Ellipsoid(tapered, Vector(0, 3, 10), Vector(67, 84, 62));
  const double aboveBase = SmoothIntersection(vault, -17 - point[2], 14);
  const double middleFossa = Ellipsoid(left, Vector(39, -3, -16), Vector(26, 42, 24));
  const double posteriorFossa = Ellipsoid(point, Vector(0, 46, -28), Vector(56, 37, 34));
  const double clivus = Rod(point, Vector(0, 14, -20), 17, Vector(0, 31, -62), 14);
  const double canal = std::min(Rod(point, Vector(0, 31, -62), 14, Vector(0, 36, -110), 10),
                                Rod(point, Vector(0, 36, -110), 10, Vector(0, 36, -1000), 10));
  const double cranium = SmoothUnion(SmoothUnion(aboveBase, middleFossa, 10), posteriorFossa, 10);
  const double whole = SmoothUnion(cranium, SmoothUnion(clivus, canal, 4), 10);
  return SmoothIntersection(whole, -PetrousRidge(left), 5);
}

HeadTissue
IntracranialTissue(const Vector & point, double depth)
{
  if (depth < fluidGap || HeadPhantomVentricles(point) < 0)
  {
    return HeadTissue::CerebrospinalFluid;
  }
  const double cerebellum = CerebellumDepth(point, depth);
  const double brainstem = std::min(-BrainstemAndCord(point), depth - fluidGap);
  const double brain = std::max(CerebrumDepth(point, depth), thinCortex * std::max(cerebellum, brainstem));
  if (brain < 0)
  {
    return HeadTissue::CerebrospinalFluid;
  }
  return brain < cortexThickness || DeepGrayMatter(point) < 0 ? HeadTissue::GrayMatter : HeadTissue::WhiteMatter;
}
} // namespace phantom

double
HeadPhantomVentricles(const Vector & point)
{
  using namespace phantom;
  const Vector left = MirrorToLeft(point);
  const double body = SmoothUnion(Rod(left, Vector(9, -30, 12), 6, Vector(12, 20, 19), 4),
                                  Rod(left, Vector(12, 20, 19), 4, Vector(23, 36, 8), 6.5),
                                  4);
  const double horns = std::min({ Rod(left, Vector(23, 36, 8), 5, Vector(22, 56, 3), 2.5),
                                  Rod(left, Vector(23, 36, 6), 5, Vector(33, 12, -14), 3),
                                  Rod(left, Vector(33, 12, -14), 3, Vector(31, -12, -18), 2.5) });
  const double third = Ellipsoid(point, Vector(0, 5, 1), Vector(2.8, 15, 11));
  const double foramina = Rod(left, Vector(9, -10, 13), 2, Vector(0, -4, 5), 2);
  const double aqueduct = Rod(point, Vector(0, 16, -2), 1.8, Vector(0, 29, -26), 1.8);
  const double fourth = Ellipsoid(point, Vector(0, 31, -35), Vector(8, 6, 11));
  const double outlet = Rod(point, Vector(0, 33, -42), 2.5, Vector(0, 45, -59), 2.5);
  const double lateral = SmoothUnion(body, horns, 4);
  const double lower = std::min(SmoothUnion(aqueduct, fourth, 3), outlet);
  return std::min({ lateral, third, foramina, lower });
}
} // namespace mmm
