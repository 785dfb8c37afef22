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
#include "optimize/SmoothPatches.h"

#include "base/DisjointSets.h"

#include <algorithm>

namespace mmm
{
namespace
{
/** An edge, by its points in order, and a triangle that has it. */
struct Use
{
  std::array<PointId, 2> points;
  std::uint32_t          triangle;
};

std::vector<Use>
SortedEdges(const std::vector<Triangle> & triangles)
{
  std::vector<Use> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const auto ends = std::minmax(triangles[t][c], triangles[t][(c + 1) % 3]);
      uses.push_back({ { { ends.first, ends.second } }, t });
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use & a, const Use & b) {
    return a.points != b.points ? a.points < b.points : a.triangle < b.triangle;
  });
  return uses;
}
} // namespace

SmoothPatches
FindSmoothPatches(const std::vector<Vector> & points, const InterfaceMesh & interfaces, double leastCosine)
{
  SmoothPatches result;
  for (const auto & t : interfaces.triangles)
  {
    result.normals.push_back((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).normalized());
  }
  const auto   uses = SortedEdges(interfaces.triangles);
  DisjointSets sets(interfaces.triangles.size());
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last)
  {
    while (last < uses.size() && uses[last].points == uses[first].points)
    {
      ++last;
    }
    const std::uint32_t one = uses[first].triangle;
    const std::uint32_t two = uses[last - 1].triangle;
    if (last - first == 2 && interfaces.sides[one] == interfaces.sides[two] &&
        result.normals[one].dot(result.normals[two]) > leastCosine)
    {
      sets.Unite(one, two);
    }
    else
    {
      result.seams.push_back({ uses[first].points, last - first });
    }
  }
  for (std::uint32_t t = 0; t < interfaces.triangles.size(); ++t)
  {
    result.ofTriangles.push_back(sets.Find(t));
  }
  return result;
}
} // namespace mmm
