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
#include "report/CutFrame.h"

#include "itkContinuousIndex.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr double UnitsPerSpacing = 100.0;
/** Around the mesh, in voxels. */
constexpr double Margin = 1.5;

using Axes = std::array<int, 3>;

/** For each axis of the patient the axis of the image that is the closest to it. */
Axes
ClosestAxes(const itk::ImageBase<3>::DirectionType & direction)
{
  Axes   axes{ { 0, 1, 2 } };
  Axes   best = axes;
  double most = -1.0;
  do
  {
    double sum = 0.0;
    for (int p = 0; p < 3; ++p)
    {
      sum += std::abs(direction[p][axes[p]]);
    }
    if (sum > most)
    {
      most = sum;
      best = axes;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return best;
}

/** How a cut is looked at: axes of the patient in LPS, and whether what is drawn to the right and downwards is towards
 * their positive ends. */
struct View
{
  const char * name;
  int          normal;
  Axes         along;
  bool         positive[2];
};

const View Views[3] = { { "Axial", 2, { { 0, 1, 0 } }, { true, true } },
                        { "Coronal", 1, { { 0, 2, 0 } }, { true, false } },
                        { "Sagittal", 0, { { 1, 2, 0 } }, { true, false } } };
/** Of the negative and the positive end of each of the patient's axes. */
const char * const Ends[3] = { "RL", "AP", "IS" };

/** The sides need not be at right angles. */
double
AreaOfVoxel(const itk::ImageBase<3> & image, const CutPlane & plane)
{
  Vector sides[2];
  for (int a = 0; a < 2; ++a)
  {
    for (int p = 0; p < 3; ++p)
    {
      sides[a][p] = image.GetDirection()[p][plane.along[a]] * image.GetSpacing()[plane.along[a]];
    }
  }
  return sides[0].cross(sides[1]).norm();
}

CutFrame
MakeCutFrame(const View & view, const itk::ImageBase<3> & image, const Vector & lower, const Vector & upper)
{
  const auto & direction = image.GetDirection();
  const auto & spacing = image.GetSpacing();
  const Axes   axes = ClosestAxes(direction);
  const double unit = std::min({ spacing[0], spacing[1], spacing[2] }) / UnitsPerSpacing;
  CutFrame     frame;
  frame.name = view.name;
  frame.unit = unit;
  frame.plane.normal = axes[view.normal];
  frame.layer = std::lround(0.5 * (lower[frame.plane.normal] + upper[frame.plane.normal]));
  frame.plane.position = double(frame.layer);
  for (int a = 0; a < 2; ++a)
  {
    const int  patient = view.along[a];
    const int  axis = axes[patient];
    const bool isForward = (direction[patient][axis] >= 0.0) == view.positive[a];
    const bool isPositive = view.positive[a];
    frame.plane.along[a] = axis;
    frame.origin[a] = isForward ? lower[axis] - Margin : upper[axis] + Margin;
    frame.scale[a] = (isForward ? 1.0 : -1.0) * spacing[axis] / unit;
    frame.size[a] = std::lround((upper[axis] - lower[axis] + 2.0 * Margin) * spacing[axis] / unit);
    frame.sides[2 * a] = Ends[patient][isPositive ? 0 : 1];
    frame.sides[2 * a + 1] = Ends[patient][isPositive ? 1 : 0];
  }
  itk::ContinuousIndex<double, 3> middle;
  for (int a = 0; a < 3; ++a)
  {
    middle[a] = 0.5 * (lower[a] + upper[a]);
  }
  middle[frame.plane.normal] = frame.plane.position;
  itk::Point<double, 3> place;
  image.TransformContinuousIndexToPhysicalPoint(middle, place);
  frame.voxelArea = AreaOfVoxel(image, frame.plane);
  frame.axis = std::string(1, "xyz"[view.normal]);
  frame.place = place[view.normal];
  return frame;
}
} // namespace

SvgPoint
CutFrame::ToDrawing(const PlanarPoint & point) const
{
  return { { std::lround((point[0] - origin[0]) * scale[0]), std::lround((point[1] - origin[1]) * scale[1]) } };
}

std::array<CutFrame, 3>
MakeCutFrames(const itk::ImageBase<3> & image, const std::vector<Vector> & points)
{
  Vector lower = points.front();
  Vector upper = points.front();
  for (const Vector & point : points)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  return { { MakeCutFrame(Views[0], image, lower, upper),
             MakeCutFrame(Views[1], image, lower, upper),
             MakeCutFrame(Views[2], image, lower, upper) } };
}

template <typename TMesh>
std::vector<Vector>
ToContinuousIndices(const TMesh & mesh, const itk::ImageBase<3> & image)
{
  std::vector<Vector> indices;
  if (mesh.GetPoints() == nullptr)
  {
    return indices;
  }
  indices.reserve(mesh.GetNumberOfPoints());
  for (const auto & meshPoint : mesh.GetPoints()->CastToSTLConstContainer())
  {
    itk::Point<double, 3> point;
    point.CastFrom(meshPoint);
    itk::ContinuousIndex<double, 3> index;
    // whether it is inside does not matter here
    static_cast<void>(image.TransformPhysicalPointToContinuousIndex(point, index));
    indices.emplace_back(index[0], index[1], index[2]);
  }
  return indices;
}

template std::vector<Vector>
ToContinuousIndices(const itk::LabelTetrahedralMesh & mesh, const itk::ImageBase<3> & image);
template std::vector<Vector>
ToContinuousIndices(const itk::LabelInterfaceMesh & mesh, const itk::ImageBase<3> & image);
} // namespace mmm
