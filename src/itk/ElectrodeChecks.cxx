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
#include "itk/ElectrodeChecks.h"

#include "itk/LabelDomain.h"

#include <algorithm>

namespace mmm
{
namespace
{
/** Further from the skin, a place is a mistake. In mm. */
constexpr double FarthestProjection = 20.0;
/** No electrode is larger. In mm. */
constexpr double LargestLength = 500.0;
} // namespace

double
ElectrodeChecks::LeastVoxelsOf(const Electrode & electrode)
{
  return electrode.isRounded || electrode.bodyLabel ? LeastVoxelsOfLeads : LeastVoxels;
}

void
ElectrodeChecks::VerifyLabel(const Electrode & electrode, const char * key, int label) const
{
  if (Contains(m_Exterior, label))
  {
    Fail(electrode, key, label, " is the label of the exterior; choose another one");
  }
  if (m_Counts.count(label) != 0)
  {
    Fail(electrode, key, "the image has the label ", label, " already; choose another one");
  }
}

void
ElectrodeChecks::VerifyLength(const Electrode & electrode, const char * key, double length, double voxels) const
{
  const double least = voxels * m_Voxel;
  if (length > LargestLength)
  {
    Fail(electrode, key, length, " mm is too large; it can be ", LargestLength, " mm at most");
  }
  if (!(length >= least * (1.0 - 1e-6)))
  {
    Fail(electrode,
         key,
         length,
         " mm is too small for voxels of ",
         m_Voxel,
         " mm; it has to be ",
         least,
         " mm or more, or the image to have smaller voxels");
  }
}

void
ElectrodeChecks::Verify(const Electrode & electrode) const
{
  this->VerifyLabel(electrode, "label", electrode.label);
  if (electrode.shape == ElectrodeShape::Cylinder && !electrode.end)
  {
    Fail(electrode, "to", "it is missing");
  }
  switch (electrode.shape)
  {
    case ElectrodeShape::Rectangle:
      this->VerifyLength(electrode, "size", electrode.size[0]);
      this->VerifyLength(electrode, "size", electrode.size[1]);
      break;
    case ElectrodeShape::Box:
      for (const double edge : electrode.size)
      {
        this->VerifyLength(electrode, "size", edge);
      }
      break;
    default:
      if (electrode.innerRadius > 0.0)
      {
        this->VerifyLength(electrode, "inner_radius", electrode.innerRadius, 0.5 * LeastVoxels);
        if (electrode.radius - electrode.innerRadius < LeastVoxels * m_Voxel)
        {
          Fail(electrode,
               "inner_radius",
               "it leaves ",
               electrode.radius - electrode.innerRadius,
               " mm up to the radius, which is too thin for voxels of ",
               m_Voxel,
               " mm; ",
               LeastVoxels * m_Voxel,
               " mm or more are needed");
        }
      }
      this->VerifyLength(electrode, "radius", electrode.radius, 0.5 * LeastVoxelsOf(electrode));
  }
  if (electrode.IsOnSkin())
  {
    this->VerifyLength(electrode, "thickness", electrode.thickness);
  }
  if (electrode.gel)
  {
    this->VerifyLabel(electrode, "gel.label", electrode.gel->label);
    this->VerifyLength(electrode, "gel.thickness", electrode.gel->thickness);
  }
}

void
ElectrodeChecks::VerifyBulge(const Electrode & electrode, const char * key, double least) const
{
  if (least < 0.5 * LeastVoxels * m_Voxel)
  {
    Fail(electrode,
         key,
         "the skin bulges so that ",
         std::max(least, 0.0),
         " mm are left of it; it has to be thicker, or less wide");
  }
}

void
ElectrodeChecks::VerifyProjection(const Electrode & electrode, double distance)
{
  if (!(distance <= FarthestProjection))
  {
    Fail(electrode,
         electrode.site.empty() ? "position" : "site",
         "the skin is ",
         distance,
         " mm away, more than ",
         FarthestProjection,
         " mm; check the place and 'space'");
  }
}
} // namespace mmm
