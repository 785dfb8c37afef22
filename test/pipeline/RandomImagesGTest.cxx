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
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "base/Hash.h"
#include "support/TestLabelImages.h"
#include "support/TestSeeds.h"

#include <set>
#include <vector>

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

/** Whether the whole pipeline ends without an exception; with one, it has words to print. */
bool
Runs(FilterType * filter)
{
  try
  {
    filter->Update();
    return true;
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_FALSE(std::string(error.GetDescription()).empty());
    std::cout << "exception: " << error.GetDescription() << '\n';
    return false;
  }
}

/** What holds of every mesh, of the image that it was made from. */
void
ExpectValidMesh(FilterType * filter)
{
  const auto calculator = itk::TetrahedralMeshQualityCalculator<itk::LabelTetrahedralMesh>::New();
  calculator->SetMesh(filter->GetOutput());
  calculator->Compute();
  const auto & quality = calculator->GetReport();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0u);
  EXPECT_EQ(quality.tetrahedra.nonPositive, 0u);
  EXPECT_EQ(quality.unusedPoints, 0u);
  EXPECT_EQ(quality.overusedFaces, 0u);
  if (filter->GetReport().links.left.empty())
  {
    EXPECT_EQ(quality.nonManifoldEdges, 0u);
  }

  std::set<int> expected(filter->GetLabels().begin(), filter->GetLabels().end());
  expected.erase(filter->GetOutsideLabel());
  for (const auto & vanished : filter->GetVanishedLabels())
  {
    expected.erase(vanished.first);
  }
  std::set<int> meshed;
  for (const auto & label : quality.labels)
  {
    EXPECT_EQ(label.openEdges, 0u) << "label " << label.label;
    meshed.insert(label.label);
  }
  EXPECT_EQ(meshed, expected);
}

/** Draws that depend on a seed and a number only. */
class Draws
{
public:
  explicit Draws(int seed)
    : m_Seed(mmm::Hash(std::uint64_t(seed)))
  {}
  /** A whole number in [lowest, highest]. */
  int
  Whole(int what, int lowest, int highest) const
  {
    return lowest + int(mmm::Hash(m_Seed + std::uint64_t(what)) % std::uint64_t(highest - lowest + 1));
  }
  /** A number in [0, 1). */
  double
  Real(int what) const
  {
    return double(mmm::Hash(m_Seed + std::uint64_t(what)) >> 11) * 0x1p-53;
  }

private:
  std::uint64_t m_Seed;
};

/** In voxels, from the environment variable, or 20. */
int
LargestSide()
{
  const char * const side = std::getenv("MMM_TEST_LARGEST_SIDE");
  return side == nullptr ? 20 : std::max(5, std::atoi(side));
}

/** The label of the nearest of some random places: blobs that touch in all kinds of junctions. A share of the voxels
 * has any label: from none to all, which is noise. */
LabelImage::Pointer
MakeRandomImage(const Draws & draws)
{
  enum What
  {
    SizeX,
    SizeY,
    SizeZ,
    Labels,
    Noise,
    Sites,
    Slices,
    FirstSite = 100,
    FirstVoxel = 1000
  };
  const int    largest = LargestSide();
  const int    smallest = 2 * largest / 5;
  const int    nx = draws.Whole(SizeX, smallest, largest);
  const int    ny = draws.Whole(SizeY, smallest, largest);
  const int    nz = draws.Whole(SizeZ, smallest, largest);
  const int    labels = draws.Whole(Labels, 2, 6);
  const double noise = std::vector<double>{ 0.0, 0.02, 0.2, 1.0 }[draws.Whole(Noise, 0, 3)];
  const int    sites = draws.Whole(Sites, labels, 40);
  const auto   image = mmmtest::MakeImage<LabelImage>(nx, ny, nz, [&](int i, int j, int k) {
    const int voxel = FirstVoxel + 2 * (i + nx * (j + ny * k));
    if (draws.Real(voxel) < noise)
    {
      return draws.Whole(voxel + 1, 0, labels - 1);
    }
    int    nearest = 0;
    double least = 1e30;
    for (int s = 0; s < sites; ++s)
    {
      const int    at = FirstSite + 3 * s;
      const double distance =
        std::hypot(nx * draws.Real(at) - i, ny * draws.Real(at + 1) - j, nz * draws.Real(at + 2) - k);
      if (distance < least)
      {
        least = distance;
        nearest = s;
      }
    }
    return nearest % labels;
  });
  const double spacing[] = { 1.0, 1.0, draws.Whole(Slices, 0, 2) == 0 ? 4.0 : 1.0 };
  image->SetSpacing(spacing);
  return image;
}

class RandomImages : public ::testing::TestWithParam<int>
{};
} // namespace

TEST_P(RandomImages, GiveAValidMesh)
{
  const Draws draws(GetParam());
  const auto  filter = FilterType::New();
  filter->SetInput(MakeRandomImage(draws));
  filter->SetMinimumIslandSize(GetParam() % 2 ? 8 : 0);
  filter->SetExteriorLabels(GetParam() % 3 ? FilterType::LabelsType{ 0 } : FilterType::LabelsType{});
  filter->SetEpsilon(GetParam() % 5 == 3 ? 1.0 : 2.5); // topologies are kept at 1
  const bool runs = Runs(filter);
  EXPECT_TRUE(runs || mmmtest::AreSeedsGiven()); // test/fuzz.sh counts the exceptions
  if (runs)
  {
    ExpectValidMesh(filter);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         RandomImages,
                         ::testing::ValuesIn(mmmtest::Seeds(12)),
                         ::testing::PrintToStringParamName());

class Slabs : public ::testing::TestWithParam<int>
{};

TEST_P(Slabs, OfAnySizeAreMeshed)
{
  const int  n = GetParam();
  const auto filter = FilterType::New();
  filter->SetInput(mmmtest::MakeImage<LabelImage>(n, n, n, [n](int i, int, int) { return i < n / 2 ? 1 : 2; }));
  filter->SetExteriorLabels({});
  ASSERT_TRUE(Runs(filter));
  ExpectValidMesh(filter);
  EXPECT_TRUE(filter->GetVanishedLabels().empty());
}

INSTANTIATE_TEST_SUITE_P(Sizes, Slabs, ::testing::Range(4, 17));
