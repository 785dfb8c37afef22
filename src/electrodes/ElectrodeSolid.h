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
#ifndef mmmElectrodeSolid_h
#define mmmElectrodeSolid_h

#include "base/IndexBox.h"
#include "electrodes/SkinPatch.h"
#include "itkElectrodes.h"

#include <functional>
#include <vector>

namespace mmm
{
/** \brief A shape as a function of points of the grid, in its unit.
 *
 * It is positive inside, 0 on the surface, and of slope 1 there; where the surface is round, it is a quadratic
 * function, which tricubic interpolation between the nodes reproduces. */
struct ElectrodeSolid
{
  std::function<double(const Vector &)> distance;
  /** Beyond this box it is outside. */
  Vector lower;
  Vector upper;
  /** Of all of its surface, or of what is below; not a number where it is not known. */
  double area;
};

/** The lengths of an electrode in the grid's unit. */
struct ElectrodeLengths
{
  ElectrodeShape shape;
  double         radius;
  double         innerRadius;
  double         size[3];
  double         thickness;
  /** 0 without gel. */
  double gelThickness;
  /** Whether a cylinder begins with half a sphere. */
  bool isRounded;
  /** Whether it is the part of a thinner body between its ends. */
  bool isPartOfBody;
  /** Of the polygon that stands for a circle, 0 if it is not known. */
  double edge;

  /** Where the corners of such a polygon are, if its area is that of the circle. */
  double
  ToCorners(double circle) const
  {
    return circle + edge * edge / (12.0 * circle);
  }
};

/** \brief An electrode on the skin, and its gel.
 *
 * It goes along the skin's normal at its middle, down to the skin: so it hides nothing but exterior, and its lower end
 * is below the skin. Discs and rings are flat, rectangles follow the skin. */
class ElectrodeOnSkin
{
public:
  ElectrodeOnSkin(const ElectrodeLengths & lengths, const Skin & skin, const SkinFrame & frame);

  /** Whether there is skin under all of it. */
  bool
  IsComplete() const
  {
    return m_Extent.isComplete;
  }
  /** How thin they get, as the skin bulges below what is flat. */
  double
  LeastThickness() const;
  double
  LeastGelThickness() const;

  /** With the gel, which is to hide it in part. */
  ElectrodeSolid
  Body() const;
  ElectrodeSolid
  Gel() const;

private:
  /** To the outline in the tangent plane, or to that of the corners of its polygon. */
  double
  ToOutline(double u, double v) const;
  double
  ToCorners(double u, double v) const;
  /** Above the skin, or the plane. */
  double
  Elevation(const Vector & local) const;
  bool
  IsFlat() const
  {
    return m_Lengths.shape != ElectrodeShape::Rectangle;
  }
  ElectrodeSolid
  MakeSolid(double top, double margin, double area) const;

  ElectrodeLengths  m_Lengths;
  SkinFrame         m_Frame;
  double            m_Half[2]{};
  SkinPatch         m_Patch;
  SkinPatch::Extent m_Extent;
};

/** A sphere or a box, whose axes are orthogonal, or a cylinder along the first axis. The origin is the middle. */
ElectrodeSolid
MakeImplant(const ElectrodeLengths & lengths, const SkinFrame & frame);
} // namespace mmm

#endif
