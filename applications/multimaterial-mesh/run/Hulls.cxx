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
#include "run/Hulls.h"

#include "console/Errors.h"
#include "console/Warnings.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace cli
{
namespace
{
using Points = std::vector<std::array<double, 3>>;

Points
SortedPoints(const itk::LabelInterfaceMesh & mesh)
{
  Points points;
  for (const auto & point : mesh.GetPoints()->CastToSTLConstContainer())
  {
    points.push_back({ point[0], point[1], point[2] });
  }
  std::sort(points.begin(), points.end());
  return points;
}

std::size_t
CountCommon(const Points & a, const Points & b)
{
  Points common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common.size();
}

/** "1 handle", "2 handles". */
std::string
Counted(std::size_t count, const std::string & noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

void
WarnOfDefects(const std::string & file, const itk::LabelHullMeshFilter & filter)
{
  std::string text;
  const auto  add = [&](std::size_t count, const std::string & noun, const std::string & remark) {
    if (count > 0)
    {
      text += (text.empty() ? "" : ", ") + Counted(count, noun) + remark;
    }
  };
  add(filter.GetNumberOfOtherParts(), "part", " of the labels left out beside it");
  add(filter.GetNumberOfPinchedEdges(), "pinched edge", "");
  add(filter.GetNumberOfPinchedPoints(), "pinched point", "");
  add(filter.GetNumberOfHandles(), "handle", "");
  if (!text.empty())
  {
    Warn("the hull " + file + " has " + text);
  }
}
} // namespace

void
CheckHullLabels(const Settings & settings, const Input & input)
{
  for (const Hull & hull : settings.hulls)
  {
    const auto isThere = [&](int label) { return input.voxels.count(label) != 0; };
    if (std::none_of(hull.labels.begin(), hull.labels.end(), isThere))
    {
      throw Error("no voxel has a label of --hull " + hull.file);
    }
    for (const int label : hull.labels)
    {
      if (!isThere(label))
      {
        Warn("no voxel has the label " + std::to_string(label) + " that --hull names");
      }
    }
  }
}

void
MakeHulls(Outcome & outcome)
{
  const auto &        hulls = outcome.settings.hulls;
  std::vector<Points> points;
  for (const Hull & hull : hulls)
  {
    const auto filter = itk::LabelHullMeshFilter::New();
    filter->SetInput(outcome.surface);
    filter->SetLabels(hull.labels);
    filter->Update();
    WarnOfDefects(hull.file, *filter);
    points.push_back(SortedPoints(*filter->GetOutput()));
    for (std::size_t other = 0; other + 1 < points.size(); ++other)
    {
      if (const std::size_t common = CountCommon(points[other], points.back()))
      {
        Warn("the hulls " + hulls[other].file + " and " + hull.file + " touch in " + Counted(common, "point"));
      }
    }
    outcome.hulls.push_back(filter);
  }
}
} // namespace cli
