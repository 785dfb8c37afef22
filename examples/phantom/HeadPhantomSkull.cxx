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
#include "phantom/HeadPhantomSkull.h"
#include "phantom/HeadPhantomBrain.h"
#include "phantom/HeadPhantomShapes.h"

namespace mmm::phantom
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double thinnestBone = 2.0;

/** 2 mm at the temples, some 7 mm at the back. */
double
VaultThickness(const Vector & left)
{
  const double thickness = 5.2 + 0.9 * std::sin(0.055 * left[1]) * std::cos(0.05 * left[2] + 0.03 * left[0]) +
                           1.5 * Bump(left, Vector(0, 84, -6), 22) - 4.5 * Bump(left, Vector(66, -10, -6), 24);
  return std::max(thickness, thinnestBone);
}

double
Orbits(const Vector & left)
{
  return Rod(left, Vector(35, -90, -35), 18, Vector(16, -40, -29), 6);
}

double
Midface(const Vector & left)
{
  const double brow = Ellipsoid(left, Vector(18, -79, -14), Vector(27, 12, 9));
  const double maxilla = Ellipsoid(left, Vector(0, -62, -54), Vector(40, 27, 38));
  const double cheek = Ellipsoid(left, Vector(45, -65, -48), Vector(14, 12, 13));
  const double arch = Rod(left, Vector(53, -60, -46), 4, Vector(61, 4, -35), 4);
  const double sphenoid = Ellipsoid(left, Vector(0, -20, -36), Vector(24, 26, 17));
  const double mastoid = Ellipsoid(left, Vector(54, 24, -44), Vector(12, 14, 21));
  const double front = SmoothUnion(SmoothUnion(brow, maxilla, 8), SmoothUnion(cheek, arch, 5), 6);
  return SmoothUnion(front, std::min({ sphenoid, mastoid, PetrousRidge(left) }), 6);
}

/** The lower jaw, closed, so that it belongs to the skull. */
double
Jaw(const Vector & left)
{
  const double ramus = Rod(left, Vector(52, 4, -42), 5, Vector(46, -6, -92), 7);
  const double body = Rod(left, Vector(46, -6, -92), 7, Vector(17, -76, -116), 6.5);
  const double chin = Rod(left, Vector(17, -76, -116), 6.5, Vector(0, -82, -118), 7.5);
  const double arch = Ellipsoid(Vector(left[0], left[1], 0), Vector(0, -48, 0), Vector(28, 36, 1000));
  const double teeth = std::max({ std::abs(arch) - 4.5, left[1] + 52, std::abs(left[2] + 100) - 18 });
  return std::min(SmoothUnion(ramus, SmoothUnion(body, chin, 6), 6), teeth);
}

double
Spine(const Vector & left)
{
  constexpr double period = 18.0;
  const double     bodies =
    Rod(left, Vector(0, 15, -68), 12, Vector(0, 17, -1000), 12) + std::cos(2 * pi / period * left[2]);
  const Vector repeated(left[0], left[1], left[2] - period * std::round(left[2] / period));
  const double spines = Rod(repeated, Vector(0, 48, 2), 4, Vector(0, 62, -2), 3);
  const double wings = Rod(repeated, Vector(8, 24, 0), 4, Vector(24, 28, 0), 4);
  return std::min(bodies, std::max(std::min(spines, wings), left[2] + 74));
}
} // namespace

double
Bones(const Vector & point, double intracranial)
{
  const Vector left = MirrorToLeft(point);
  const double vault = intracranial - VaultThickness(left);
  const double face = SmoothUnion(Midface(left), Jaw(left), 3);
  const double nostrils = Ellipsoid(left, Vector(0, -90, -58), Vector(12, 16, 15));
  const double all = std::min(SmoothUnion(vault, face, 5), Spine(left));
  const double carved = std::max(all, -std::min(Orbits(left), nostrils));
  return std::min(carved, intracranial - thinnestBone);
}

double
AirCavities(const Vector & point, double intracranial)
{
  const Vector left = MirrorToLeft(point);
  const double frontal = Ellipsoid(left, Vector(11, -83, -11), Vector(8, 5, 8));
  const double maxillary = Ellipsoid(left, Vector(25, -62, -64), Vector(10, 14, 12));
  const double ethmoid = Ellipsoid(left, Vector(7, -56, -33), Vector(4, 14, 6));
  const double sphenoid = Ellipsoid(left, Vector(0, -20, -36), Vector(13, 13, 9));
  const double mastoid = Ellipsoid(left, Vector(55, 25, -48), Vector(6, 7, 11));
  const double sinuses = std::min({ frontal, maxillary, ethmoid, sphenoid, mastoid });

  const double nasal = Ellipsoid(left, Vector(7, -60, -60), Vector(5.5, 30, 15));
  const double pharynx = SmoothUnion(Rod(point, Vector(0, -34, -60), 8, Vector(0, -20, -80), 8),
                                     Rod(point, Vector(0, -20, -80), 8, Vector(0, -14, -130), 7),
                                     4);
  const double trachea = Rod(point, Vector(0, -14, -130), 7, Vector(0, -14, -1000), 7.5);
  const double airway = SmoothUnion(nasal, std::min(pharynx, trachea), 5);
  // Walls are left between neighbours: at least the thinnest bone.
  const double clear = std::min(Orbits(left), intracranial) - thinnestBone;
  return std::max(std::min(std::max(sinuses, thinnestBone - airway), airway), -clear);
}

double
HeadOutline(const Vector & point, double intracranial, double bones)
{
  const Vector left = MirrorToLeft(point);
  const double scalp = intracranial - VaultThickness(left) - 6;
  const double face = SmoothUnion(Ellipsoid(left, Vector(0, -46, -66), Vector(60, 49, 62)),
                                  Ellipsoid(left, Vector(0, -84, -118), Vector(20, 14, 13)),
                                  12);
  const double nose = SmoothUnion(Rod(left, Vector(0, -90, -26), 5, Vector(0, -104, -59), 8),
                                  Ellipsoid(left, Vector(9, -97, -62), Vector(7, 9, 7)),
                                  6);
  const double features = std::min({ Ellipsoid(left, Vector(32, -81, -35), Vector(14, 13, 12)),
                                     Ellipsoid(left, Vector(0, -92, -90), Vector(23, 8, 5)),
                                     Ellipsoid(left, Vector(0, -91, -99), Vector(20, 8, 5.5)) });
  const double neck = Rod(left, Vector(0, 22, -90), 54, Vector(0, 26, -1000), 58);
  const double head = SmoothUnion(SmoothUnion(scalp, face, 14), SmoothUnion(neck, bones - 3.5, 20), 20);
  // The ear: a shell that leans outwards to the back, with a hollow.
  const Vector leaning(left[0] - 0.4 * (left[1] - 14), left[1], left[2]);
  const double ear = std::max(Ellipsoid(leaning, Vector(76, 14, -30), Vector(5, 17, 29)),
                              -Ellipsoid(leaning, Vector(83, 11, -29), Vector(5, 8, 12)));
  const double whole = SmoothUnion(SmoothUnion(SmoothUnion(head, nose, 8), features, 5), ear, 5);
  const double earCanal = std::max(Rod(left, Vector(95, 11, -31), 3, Vector(60, 9, -31), 3), 3 - bones);
  return std::max(whole, -earCanal);
}
} // namespace mmm::phantom
