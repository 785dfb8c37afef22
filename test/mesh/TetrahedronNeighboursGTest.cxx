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
#include "support/TestTetrahedra.h"
#include "mesh/TetrahedronNeighbours.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <map>

TEST(TetrahedronNeighbours, ShareTheFace)
{
  mmm::Grid grid;
  grid.size = { { 5, 5, 5 } };
  const auto tetrahedra = mmmtest::MakeFreudenthalTetrahedra(grid);
  const auto neighbours = mmm::ComputeTetrahedronNeighbours(tetrahedra);

  std::map<mmm::Triangle, std::vector<std::uint32_t>> owners;
  const auto                                          faceOf = [&](std::uint32_t t, int f) {
    mmm::Triangle face;
    for (int c = 0; c < 3; ++c)
    {
      face[c] = tetrahedra[t][mmm::TetrahedronFaces[f][c]];
    }
    std::sort(face.begin(), face.end());
    return face;
  };
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      owners[faceOf(t, f)].push_back(t);
    }
  }
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
  {
    for (int f = 0; f < 4; ++f)
    {
      const auto & both = owners[faceOf(t, f)];
      const auto   expected = both.size() == 1 ? mmm::NoTetrahedron : both[0] == t ? both[1] : both[0];
      EXPECT_EQ(neighbours[t][f], expected);
    }
  }
}

TEST(TetrahedronNeighbours, AreNoneForATetrahedronAlone)
{
  const auto neighbours = mmm::ComputeTetrahedronNeighbours({ { { 3, 1, 0, 2 } } });
  EXPECT_EQ(neighbours[0],
            (std::array<std::uint32_t, 4>{
              { mmm::NoTetrahedron, mmm::NoTetrahedron, mmm::NoTetrahedron, mmm::NoTetrahedron } }));
}
