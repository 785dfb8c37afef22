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
#include "electrodes/Skin.h"

#include "base/FaceNeighbours.h"
#include "base/IndexBox.h"
#include "image/MaterialImage.h"
#include "indicators/IndicatorSmoothing.h"

#include "itkMacro.h"

#include <limits>

namespace mmm
{
namespace
{
/** The same as that of the labels by default, in voxels. */
constexpr double Radius = 0.5;
constexpr int    NewtonSteps = 5;
constexpr int    FootSteps = 30;
constexpr double LongestStep = 0.5;
constexpr double Accuracy = 1e-4;
constexpr double LeastSquaredSlope = 0.01;

enum : Material
{
  Outside,
  Head
};

bool
IsAtBorder(const Grid & grid, const Index & at)
{
  bool isAtBorder = false;
  for (int a = 0; a < 3; ++a)
  {
    isAtBorder = isAtBorder || at[a] == 0 || at[a] == grid.size[a] - 1;
  }
  return isAtBorder;
}

/** The exterior that reaches the border, and all else. */
MaterialImage
FindOutside(const Grid & grid, const std::vector<bool> & isExterior)
{
  MaterialImage            image{ grid, std::vector<Material>(grid.NumberOfNodes(), Head), 2 };
  std::vector<std::size_t> found;
  const auto               add = [&](std::size_t n) {
    if (isExterior[n] && image.materials[n] == Head)
    {
      image.materials[n] = Outside;
      found.push_back(n);
    }
  };
  IndexBox::Of(grid.size).Visit([&](const Index & at) {
    if (IsAtBorder(grid, at))
    {
      add(grid.Offset(at));
    }
  });
  for (std::size_t next = 0; next < found.size(); ++next)
  {
    ForEachFaceNeighbour(grid, grid.IndexAt(found[next]), [&](const Index & beside) { add(grid.Offset(beside)); });
  }
  if (found.empty() || found.size() == grid.NumberOfNodes())
  {
    itkGenericExceptionMacro(
      "There is no skin to put electrodes on: " << (found.empty() ? "no exterior is at the border of the image."
                                                                  : "the image is all exterior."));
  }
  return image;
}
} // namespace

Skin::Skin(const Grid & grid, const std::vector<bool> & isExterior)
  : Skin(FindOutside(grid, isExterior))
{}

Skin::Skin(const MaterialImage & image)
  : m_Outside(
      MakeIndicatorSet(image.grid,
                       { ComputeSmoothIndicator(image, Outside, ComputeMaterialBoxes(image)[Outside], Radius) }))
{
  IndexBox::Of(image.grid.size).Visit([&](const Index & at) {
    if (image.materials[image.grid.Offset(at)] == Head)
    {
      ForEachFaceNeighbour(image.grid, at, [&](const Index & beside) {
        if (image.materials[image.grid.Offset(beside)] == Outside)
        {
          m_Faces.push_back(0.5 * (image.grid.Position(at) + image.grid.Position(beside)));
        }
      });
    }
  });
}

Vector
Skin::Normal(const Vector & x) const
{
  Vector gradient;
  static_cast<void>(m_Outside.ValueAndGradient(0, x, gradient));
  return gradient.normalized();
}

Vector
Skin::OntoSkin(Vector x) const
{
  for (int step = 0; step < NewtonSteps; ++step)
  {
    Vector       gradient;
    const double height = m_Outside.ValueAndGradient(0, x, gradient);
    const Vector move = gradient * (height / std::max(gradient.squaredNorm(), LeastSquaredSlope));
    x -= move * std::min(1.0, LongestStep / std::max(move.norm(), Accuracy));
  }
  return x;
}

Vector
Skin::Project(const Vector & x) const
{
  double least = std::numeric_limits<double>::infinity();
  Vector foot = x;
  for (const Vector & face : m_Faces)
  {
    const double distance = (face - x).squaredNorm();
    if (distance < least)
    {
      least = distance;
      foot = face;
    }
  }
  foot = this->OntoSkin(foot);
  for (int step = 0; step < FootSteps; ++step)
  {
    const Vector normal = this->Normal(foot);
    const Vector along = (x - foot) - normal * normal.dot(x - foot);
    if (along.norm() < Accuracy)
    {
      break;
    }
    foot = this->OntoSkin(foot + along * std::min(1.0, LongestStep / along.norm()));
  }
  return foot;
}
} // namespace mmm
