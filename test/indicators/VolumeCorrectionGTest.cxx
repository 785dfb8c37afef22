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
#include "image/ImageParts.h"
#include "indicators/IndicatorSmoothing.h"
#include "support/TestScenes.h"

#include <gtest/gtest.h>

using mmm::Vector;
using mmmtest::MakeBallMaterials;
using mmmtest::MakeMaterials;
using mmmtest::Scene;

namespace
{
/** A box of voxels of one material, from its lowest voxel on. */
struct VoxelBox
{
  Vector lower;
  Vector size;

  bool
  Has(const Vector & x) const
  {
    return ((x - lower).array() >= 0.0).all() && ((x - lower).array() < size.array()).all();
  }
};

/** Boxes as materials 1, 2, ... in 0. */
mmm::MaterialImage
MakeBoxes(const mmm::Index & size, const std::vector<VoxelBox> & boxes)
{
  return MakeMaterials(size, Vector::Ones(), boxes.size() + 1, [&](const Vector & x) {
    for (std::size_t b = 0; b < boxes.size(); ++b)
    {
      if (boxes[b].Has(x))
      {
        return int(b + 1);
      }
    }
    return 0;
  });
}

/** The volume around a box where its material's indicator is the largest. */
double
VolumeAround(const Scene & scene, const VoxelBox & box, mmm::Material material)
{
  constexpr int samples = 6;
  std::size_t   inside = 0;
  const Vector  first = box.lower - Vector::Constant(2.5 - 0.5 / samples);
  const auto    count = [&](int a) { return (int(box.size[a]) + 4) * samples; };
  for (int k = 0; k < count(2); ++k)
  {
    for (int j = 0; j < count(1); ++j)
    {
      for (int i = 0; i < count(0); ++i)
      {
        inside += scene.indicators->MaterialAt(first + Vector(i, j, k) / samples) == material;
      }
    }
  }
  return double(inside) / (samples * samples * samples);
}

void
ExpectVolumeOfVoxels(const VoxelBox & box)
{
  const Scene  scene(MakeBoxes({ { 20, 20, 20 } }, { box }));
  const double voxels = box.size.prod();
  EXPECT_NEAR(VolumeAround(scene, box, 1), voxels, 0.05 * voxels);
}
} // namespace

TEST(ImageParts, AreConnectedByFacesAndCounted)
{
  // two cubes that touch in an edge, in what surrounds them
  const VoxelBox first{ Vector(1.0, 1.0, 1.0), Vector::Constant(2.0) };
  const VoxelBox second{ Vector(3.0, 3.0, 1.0), Vector(2.0, 2.0, 3.0) };
  const auto     image = MakeMaterials(
    { { 7, 7, 6 } }, Vector::Ones(), 2, [&](const Vector & x) { return first.Has(x) || second.Has(x) ? 1 : 0; });
  const auto found = mmm::FindImageParts(image);
  ASSERT_EQ(found.parts.size(), 3u);
  EXPECT_EQ(found.parts[0].material, 0);
  EXPECT_EQ(found.parts[1].material, 1);
  EXPECT_EQ(found.parts[2].material, 1);
  EXPECT_EQ(found.parts[0].voxels, 7u * 7u * 6u - 20u);
  EXPECT_EQ(found.parts[1].voxels, 8u);
  EXPECT_EQ(found.parts[2].voxels, 12u);
  EXPECT_EQ(found.numbers[image.grid.Offset(1, 1, 1)], 1u);
  EXPECT_EQ(found.numbers[image.grid.Offset(4, 4, 3)], 2u);
}

TEST(VolumeCorrection, CubesOfFewVoxelsKeepTheirVolume)
{
  for (const double edge : { 2.0, 3.0, 4.0, 5.0 })
  {
    ExpectVolumeOfVoxels({ Vector(6.0, 7.0, 8.0), Vector::Constant(edge) });
  }
}

TEST(VolumeCorrection, ASharpBoxKeepsItsVolume)
{
  ExpectVolumeOfVoxels({ Vector(5.0, 6.0, 4.0), Vector(8.0, 8.0, 12.0) });
}

TEST(VolumeCorrection, ARodOfTwoVoxelsKeepsItsVolume)
{
  ExpectVolumeOfVoxels({ Vector(8.0, 8.0, 3.0), Vector(2.0, 2.0, 13.0) });
}

TEST(VolumeCorrection, NeighboursKeepTheirVolumesEach)
{
  const VoxelBox first{ Vector(5.0, 6.0, 6.0), Vector(3.0, 3.0, 3.0) };
  const VoxelBox second{ Vector(8.0, 6.0, 6.0), Vector(4.0, 3.0, 3.0) };
  const Scene    scene(MakeBoxes({ { 17, 15, 15 } }, { first, second }));
  EXPECT_NEAR(VolumeAround(scene, first, 1), 27.0, 0.05 * 27.0);
  EXPECT_NEAR(VolumeAround(scene, second, 2), 36.0, 0.05 * 36.0);
}

TEST(VolumeCorrection, PartsOfOneLabelKeepTheirVolumesEach)
{
  // smoothing makes the one smaller and the other larger
  const VoxelBox small{ Vector(4.0, 4.0, 4.0), Vector::Constant(2.0) };
  const VoxelBox large{ Vector(11.0, 5.0, 5.0), Vector::Constant(8.0) };
  const Scene    scene(MakeMaterials(
    { { 24, 18, 18 } }, Vector::Ones(), 2, [&](const Vector & x) { return small.Has(x) || large.Has(x) ? 1 : 0; }));
  EXPECT_NEAR(VolumeAround(scene, small, 1), 8.0, 0.05 * 8.0);
  EXPECT_NEAR(VolumeAround(scene, large, 1), 512.0, 0.05 * 512.0);
}

TEST(VolumeCorrection, KeepsInterfacesFurtherAwayFromTheCentresOfTips)
{
  // a block with a spike of one voxel
  const VoxelBox   block{ Vector(4.0, 4.0, 4.0), Vector::Constant(6.0) };
  const mmm::Index tip{ { 6, 6, 10 } };
  const Scene      scene(MakeMaterials({ { 15, 15, 15 } }, Vector::Ones(), 2, [&](const Vector & x) {
    return block.Has(x) || (x - Vector(tip[0], tip[1], tip[2])).norm() < 0.5 ? 1 : 0;
  }));
  ASSERT_EQ(mmm::CentreMarginOf(scene.image, tip), mmm::SmoothingParameters::TipCentreMargin);
  EXPECT_GT(scene.indicators->InsideOutside(1, scene.image.grid.Position(tip)),
            2.0 * mmm::SmoothingParameters::TipCentreMargin - 1e-4);
}

TEST(VolumeCorrection, KeepsInterfacesAwayFromVoxelCentres)
{
  const VoxelBox box{ Vector(6.0, 6.0, 6.0), Vector::Constant(5.0) };
  const Scene    scene(MakeBoxes({ { 17, 17, 17 } }, { box }));
  const auto &   image = scene.image;
  for (std::size_t n = 0; n < image.materials.size(); ++n)
  {
    const Vector x = image.grid.Position(image.grid.IndexAt(n));
    EXPECT_GT(scene.indicators->InsideOutside(image.materials[n], x),
              2.0 * mmm::SmoothingParameters::CentreMargin - 1e-4);
  }
}

TEST(VolumeCorrection, LeavesLargeSmoothShapesAlone)
{
  const auto image = MakeBallMaterials(28, Vector(13.6, 13.2, 13.9), 10.0);
  const auto boxes = mmm::ComputeMaterialBoxes(image);

  std::vector<mmm::Block<float>> blocks;
  for (mmm::Material m = 0; m < 2; ++m)
  {
    blocks.push_back(mmm::ComputeSmoothIndicator(image, m, boxes[m], 0.5));
  }
  const auto before = blocks;
  mmm::CorrectVolumes(image, blocks);
  EXPECT_EQ(blocks[0].values, before[0].values);
  EXPECT_EQ(blocks[1].values, before[1].values);
}
