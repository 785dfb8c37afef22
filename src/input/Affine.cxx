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
#include "input/Affine.h"

#include "itkMath.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr const char * Ordinals[] = { "first", "second", "third" };

double
Cosine(const Affine & affine, int a, int b)
{
  const auto & u = affine.steps[a];
  const auto & v = affine.steps[b];
  return std::abs(u * v) / (u.GetNorm() * v.GetNorm());
}
} // namespace

itk::Point<double, 3>
Affine::Apply(const itk::ContinuousIndex<double, 3> & index) const
{
  return origin + steps[0] * index[0] + steps[1] * index[1] + steps[2] * index[2];
}

Affine
FromRAS(Affine affine, double unit)
{
  const double factors[] = { -unit, -unit, unit };
  for (unsigned int row = 0; row < 3; ++row)
  {
    affine.origin[row] *= factors[row];
    for (auto & step : affine.steps)
    {
      step[row] *= factors[row];
    }
  }
  return affine;
}

Affine
AffineOf(const itk::ImageBase<3> & image)
{
  Affine affine;
  affine.origin = image.GetOrigin();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    for (unsigned int row = 0; row < 3; ++row)
    {
      affine.steps[axis][row] = image.GetDirection()[row][axis] * image.GetSpacing()[axis];
    }
  }
  return affine;
}

void
SetAffine(const Affine & affine, itk::ImageBase<3> & image)
{
  auto spacing = image.GetSpacing();
  auto direction = image.GetDirection();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = affine.steps[axis].GetNorm();
    for (unsigned int row = 0; row < 3; ++row)
    {
      direction[row][axis] = affine.steps[axis][row] / spacing[axis];
    }
  }
  image.SetSpacing(spacing);
  image.SetDirection(direction);
  image.SetOrigin(affine.origin);
}

std::string
FindFault(const Affine & affine)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto & step = affine.steps[axis];
    const bool   isFinite = std::isfinite(step[0]) && std::isfinite(step[1]) && std::isfinite(step[2]);
    if (!isFinite || !(step.GetNorm() > 0.0))
    {
      return std::string("the spacing along its ") + Ordinals[axis] + " axis is " + (isFinite ? "0" : "no number");
    }
    if (!std::isfinite(affine.origin[axis]))
    {
      return "its origin is no number";
    }
  }
  // Flatter than this, voxels have hardly a volume.
  constexpr double flattest = 0.05;
  const auto       unit = [&](int axis) { return affine.steps[axis] / affine.steps[axis].GetNorm(); };
  if (std::abs(itk::CrossProduct(unit(0), unit(1)) * unit(2)) < flattest)
  {
    for (int a = 0; a < 3; ++a)
    {
      const int b = (a + 1) % 3;
      if (Cosine(affine, a, b) > std::sqrt(1.0 - flattest * flattest))
      {
        return std::string("its ") + Ordinals[std::min(a, b)] + " and " + Ordinals[std::max(a, b)] +
               " axes have nearly the same direction";
      }
    }
    return "its three axes lie nearly in one plane";
  }
  return "";
}

double
SmallestAngle(const Affine & affine)
{
  const double cosine = std::max({ Cosine(affine, 0, 1), Cosine(affine, 1, 2), Cosine(affine, 2, 0) });
  return std::acos(std::min(cosine, 1.0)) / itk::Math::pi_over_180;
}

double
LargestDistance(const Affine & a, const Affine & b, const itk::Size<3> & size)
{
  double largest = 0.0;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    itk::ContinuousIndex<double, 3> index;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      index[axis] = (corner >> axis & 1) != 0 ? static_cast<double>(size[axis]) - 1.0 : 0.0;
    }
    largest = std::max(largest, a.Apply(index).EuclideanDistanceTo(b.Apply(index)));
  }
  return largest;
}
} // namespace mmm
