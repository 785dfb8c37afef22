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
#include "mmmStuckTetrahedra.h"
#include "mmmTestScenes.h"
#include "mmmTestTetrahedra.h"

#include "gtest/gtest.h"

using mmm::Vector;

namespace
{
constexpr int Size = 14;

const Vector &
Centre()
{
  static const Vector centre = Vector::Constant(0.5 * (Size - 1));
  return centre;
}

/** A ball of material 1 in 0, and the tetrahedra of a Freudenthal subdivision between the nodes. */
class BallOfTetrahedra
{
public:
  BallOfTetrahedra()
    : m_Scene(mmmtest::MakeBallMaterials(Size, Centre(), 3.8))
  {
    const mmm::Grid & grid = m_Scene.indicators->GetGrid();
    m_Points = mmmtest::MakeNodes(grid);
    mesh.tetrahedra = mmmtest::MakeFreudenthalTetrahedra(grid);
    this->SetMaterials([](const Vector & x) { return (x - Centre()).norm() < 3.8; });
  }

  template <typename TFunction>
  void
  SetMaterials(const TFunction & materialAt)
  {
    mesh.materials.clear();
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    {
      mesh.materials.push_back(mmm::Material(materialAt(this->CentreOf(t))));
    }
  }

  Vector
  CentreOf(std::size_t t) const
  {
    const auto & c = mesh.tetrahedra[t];
    return 0.25 * (m_Points[c[0]] + m_Points[c[1]] + m_Points[c[2]] + m_Points[c[3]]);
  }

  std::vector<std::uint32_t>
  FindStuck() const
  {
    return mmm::FindStuckTetrahedra(*m_Scene.indicators, m_Points, { mesh.tetrahedra, m_Points.size() }, 0, mesh);
  }

  mmm::TetrahedralMesh mesh;

private:
  mmmtest::Scene      m_Scene;
  std::vector<Vector> m_Points;
};
} // namespace

TEST(StuckTetrahedra, AreNoneWhereASurfaceIsALittleOff)
{
  BallOfTetrahedra ball;
  EXPECT_TRUE(ball.FindStuck().empty());
  ball.SetMaterials([](const Vector & x) { return (x - Centre()).norm() < (x[0] > Centre()[0] ? 4.6 : 3.8); });
  EXPECT_TRUE(ball.FindStuck().empty());
}

TEST(StuckTetrahedra, AreInAPartThatIsExtra)
{
  BallOfTetrahedra ball;
  const Vector     extra(2.0, 2.0, 2.0);
  ball.SetMaterials([&](const Vector & x) { return (x - Centre()).norm() < 3.8 || (x - extra).norm() < 1.2; });
  const auto stuck = ball.FindStuck();
  ASSERT_FALSE(stuck.empty());
  for (const auto t : stuck)
  {
    EXPECT_LT((ball.CentreOf(t) - extra).norm(), 1.2);
  }
}

TEST(StuckTetrahedra, AreInASheetAcrossAPart)
{
  BallOfTetrahedra ball;
  const double     middle = 6.0;
  ball.SetMaterials(
    [&](const Vector & x) { return (x - Centre()).norm() < 3.8 && (x[2] < middle || x[2] > middle + 1.0); });
  const auto stuck = ball.FindStuck();
  ASSERT_FALSE(stuck.empty());
  for (const auto t : stuck)
  {
    EXPECT_GT(ball.CentreOf(t)[2], middle);
    EXPECT_LT(ball.CentreOf(t)[2], middle + 1.0);
  }
}
