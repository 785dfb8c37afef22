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
#include "particles/CellNumbers.h"
#include "surface/MissingSamples.h"
#include "support/TestScenes.h"

#include "gtest/gtest.h"

namespace
{
using mmm::Cell;
using mmm::Vector;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

constexpr mmm::Material Outside = 99;

struct Corner
{
  Vector position;
  Cell   cell;
};

mmm::ParticleSet
MakeParticles(const std::vector<Corner> & corners)
{
  mmm::ParticleSet particles;
  mmm::CellNumbers numbers(particles.cellTable);
  for (const Corner & corner : corners)
  {
    particles.positions.push_back(corner.position);
    particles.cells.push_back(numbers(corner.cell));
  }
  return particles;
}

/** What one tetrahedron of material 0 lacks. */
mmm::MissingSamples
FindInOneTetrahedron(const Scene & scene, mmm::ParticleSet & particles)
{
  mmm::TetrahedralMesh mesh;
  mesh.tetrahedra = { { { 0, 1, 2, 3 } } };
  mesh.materials = { 0 };
  return mmm::FindMissingSamples(
    *scene.indicators, mesh, mmm::ComputeTetrahedronNeighbours(mesh.tetrahedra), Outside, particles);
}

/** Material 0 below x = 5.5. Above, 1 and 2 are divided at y = 5.5. */
Scene
MakeTee()
{
  return Scene(MakeMaterials(
    { { 12, 12, 12 } }, Vector::Ones(), 3, [](const Vector & x) { return x[0] < 5.5 ? 0 : (x[1] < 5.5 ? 1 : 2); }));
}

/** The indicators round the junction, and correct the volumes for that: the interfaces are this near to the planes. */
constexpr double Near = 0.15;
constexpr double NearAtJunction = 0.5;
constexpr double Accuracy = 1e-6;

/** The lower face along the third axis. */
constexpr mmm::Material LowerFace = 3 + 4;

std::size_t
Add(const Scene & scene, float size, const Corner & sample, mmm::ParticleSet & particles)
{
  const std::vector<float> sizes(scene.image.grid.NumberOfNodes(), size);
  return mmm::AddMissingSamples(*scene.indicators,
                                mmm::SizingField(scene.image.grid, sizes.data()),
                                { { sample.position, sample.cell } },
                                particles);
}
} // namespace

TEST(MissingSamples, AreNoneWhereTheCornersHaveAMaterialInCommon)
{
  const Scene scene = MakeTee();
  auto        particles = MakeParticles({ { { 5.5, 2, 3 }, Cell{ 0, 1 } },
                                          { { 5.5, 9, 3 }, Cell{ 0, 2 } },
                                          { { 5.5, 5.5, 6 }, Cell{ 0, 1, 2 } },
                                          { { 2, 5, -0.5 }, Cell{ 0, LowerFace } } });
  const auto  missing = FindInOneTetrahedron(scene, particles);
  EXPECT_TRUE(missing.samples.empty());
  EXPECT_EQ(missing.completedCells, 0u);
}

TEST(MissingSamples, LieOnTheTraceThatAnEdgeInAFaceOfTheImageCrosses)
{
  const Scene scene = MakeTee();
  auto        particles = MakeParticles({ { { 3, 2, -0.5 }, Cell{ 0, LowerFace } },
                                          { { 8, 3, -0.5 }, Cell{ 1, LowerFace } },
                                          { { 5.5, 1, 2 }, Cell{ 0, 1 } },
                                          { { 5.5, 4, 2 }, Cell{ 0, 1 } } });
  const auto  samples = FindInOneTetrahedron(scene, particles).samples;
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].cell, (Cell{ 0, 1, LowerFace }));
  EXPECT_LT((samples[0].position - Vector(5.5, 2.5, -0.5)).norm(), Near);
  EXPECT_LT(scene.indicators->CellIndicator(Cell{ 0, 1 }, samples[0].position), Accuracy);
  EXPECT_EQ(samples[0].position[2], -0.5);
}

TEST(MissingSamples, LieOnTheCurveThatPassesThroughAFace)
{
  const Scene scene = MakeTee();
  auto        particles = MakeParticles({ { { 5.5, 3, 5 }, Cell{ 0, 1 } },
                                          { { 5.5, 8, 5 }, Cell{ 0, 2 } },
                                          { { 8, 5.5, 5 }, Cell{ 1, 2 } },
                                          { { 5.5, 5.5, 8 }, Cell{ 0, 1, 2 } } });
  const auto  samples = FindInOneTetrahedron(scene, particles).samples;
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].cell, (Cell{ 0, 1, 2 }));
  EXPECT_LT((samples[0].position - Vector(5.5, 5.5, 5)).norm(), NearAtJunction);
  EXPECT_LT(scene.indicators->CellIndicator(samples[0].cell, samples[0].position), Accuracy);
}

TEST(MissingSamples, AreNotNeededWhereACornerTouchesTheMaterialThatItLacks)
{
  const Scene scene = MakeTee();
  auto        particles = MakeParticles({ { { 5.4, 2, -0.5 }, Cell{ 0, LowerFace } },
                                          { { 8, 3, -0.5 }, Cell{ 1, LowerFace } },
                                          { { 5.5, 1, 2 }, Cell{ 0, 1 } },
                                          { { 5.5, 4, 2 }, Cell{ 0, 1 } } });
  const auto  missing = FindInOneTetrahedron(scene, particles);
  EXPECT_TRUE(missing.samples.empty());
  EXPECT_EQ(missing.completedCells, 1u);
  EXPECT_EQ(particles.CellOf(0), (Cell{ 0, 1, LowerFace }));
  EXPECT_LT(scene.indicators->CellIndicator(Cell{ 0, 1 }, particles.positions[0]), Accuracy);
  EXPECT_EQ(particles.positions[0][2], -0.5);
}

TEST(AddMissingSamples, DropsParticlesOfSurfacesThatAreCrowdedByOneOfTheirRim)
{
  const Scene scene = MakeTee();
  auto        particles = MakeParticles({ { { 4.5, 2, -0.5 }, Cell{ 0, LowerFace } },    // crowded
                                          { { 5.5, 3, -0.5 }, Cell{ 0, 1, LowerFace } }, // on the rim itself
                                          { { 5.5, 2, 0.5 }, Cell{ 1, 2 } },             // on another surface
                                          { { 1.5, 2, -0.5 }, Cell{ 0, LowerFace } } }); // too far away
  EXPECT_EQ(Add(scene, 4.0f, { { 5.5, 2, -0.5 }, Cell{ 0, 1, LowerFace } }, particles), 1u);
  ASSERT_EQ(particles.Size(), 4u);
  EXPECT_EQ(particles.positions[0], Vector(5.5, 3, -0.5));
  EXPECT_EQ(particles.positions[3], Vector(5.5, 2, -0.5));
  EXPECT_EQ(particles.CellOf(3), (Cell{ 0, 1, LowerFace }));
}

TEST(AddMissingSamples, MakesAParticleThatIsThereOneOfAllMaterials)
{
  const Scene scene = MakeTee();
  auto        particles = MakeParticles({ { { 5.5, 2, 3 }, Cell{ 0, 1 } } });
  EXPECT_EQ(Add(scene, 1.0f, { { 5.5, 2.05, 3 }, Cell{ 0, 1 } }, particles), 0u);
  particles = MakeParticles({ { { 5.4, 2, -0.5 }, Cell{ 0, LowerFace } } });
  EXPECT_EQ(Add(scene, 1.0f, { { 5.5, 2, -0.5 }, Cell{ 0, 1, LowerFace } }, particles), 1u);
  ASSERT_EQ(particles.Size(), 1u);
  EXPECT_EQ(particles.CellOf(0), (Cell{ 0, 1, LowerFace }));
  EXPECT_LT(scene.indicators->CellIndicator(Cell{ 0, 1 }, particles.positions[0]), Accuracy);
}
