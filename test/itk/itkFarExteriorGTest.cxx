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
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

namespace
{
using LabelImage = itk::Image<unsigned char, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

constexpr int Far = 30;
constexpr int Size = 80;

/** A ball of 18 voxels and a small one beside it, `before` voxels from the image's first corner. */
LabelImage::Pointer
MakeBalls(int size, int before)
{
  return mmmtest::MakeImage<LabelImage>(size, size, size, [before](int i, int j, int k) {
    i -= before;
    j -= before;
    k -= before;
    return mmmtest::IsInBall(i, j, k, 18, 9.0) ? 1 : mmmtest::IsInBall(i - 20, j - 3, k, 6, 3.0) ? 2 : 0;
  });
}

FilterType::Pointer
RunFilter(const LabelImage * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->KeepIntermediatesOn();
  filter->Update();
  return filter;
}
} // namespace

TEST(FarExterior, ChangesNoMesh)
{
  const auto near = RunFilter(MakeBalls(42, 8));
  const auto far = RunFilter(MakeBalls(Size, Far));
  EXPECT_EQ(mmmtest::CellsOf<4>(far->GetOutput()), mmmtest::CellsOf<4>(near->GetOutput()));
  EXPECT_EQ(mmmtest::CellDataOf(far->GetOutput()), mmmtest::CellDataOf(near->GetOutput()));
  const auto points = mmmtest::PointsOf(far->GetOutput());
  const auto expected = mmmtest::PointsOf(near->GetOutput());
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    EXPECT_LT((points[p] - expected[p] - mmm::Vector::Constant(Far - 8)).norm(), 1e-9);
  }
}

TEST(FarExterior, IsInTheReportsAndImages)
{
  const auto image = MakeBalls(Size, Far);
  const auto filter = RunFilter(image);
  EXPECT_EQ(filter->GetMeshedRegion(), image->GetLargestPossibleRegion());
  std::size_t voxels = 0;
  for (const auto & record : filter->GetIslandRecords())
  {
    voxels += record.second.voxelsAfter;
  }
  EXPECT_EQ(voxels, std::size_t(Size * Size * Size));

  const auto * sizes = filter->GetComputedSizingImage();
  EXPECT_EQ(sizes->GetLargestPossibleRegion(), image->GetLargestPossibleRegion());
  EXPECT_GT(sizes->GetPixel({ { 0, 0, 0 } }), sizes->GetPixel({ { Far, Far + 9, Far + 9 } }));
  EXPECT_EQ(sizes->GetPixel({ { Size - 1, 40, 40 } }), sizes->GetPixel({ { Size - 2, 40, 40 } }));

  const auto * indicator = filter->GetIndicatorImage(1);
  EXPECT_NEAR(indicator->GetPixel({ { Far, Far + 9, Far + 9 } }), 0.5, 0.5);
  EXPECT_LT(indicator->GetPixel({ { Far - 2, Far + 9, Far + 9 } }), -1.0);
}
