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
#include "phantom/HeadPhantom.h"
#include "phantom/itkHeadPhantomImageSource.h"

#include "itkCommand.h"
#include "itkConnectedComponentImageFilter.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkRelabelComponentImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace
{
using ImageType = itk::Image<unsigned char, 3>;
using SourceType = itk::HeadPhantomImageSource<ImageType>;

constexpr unsigned int labelCount = 7;

enum Label : unsigned char
{
  Outside,
  Scalp,
  Skull,
  Fluid,
  Gray,
  White,
  Air
};

/** The default box at another spacing: the lower corner of the first voxel stays where it is. */
SourceType::Pointer
MakeSource(double spacing)
{
  const auto source = SourceType::New();
  auto       size = source->GetSize();
  auto       origin = source->GetOrigin();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(size[axis] / spacing);
    origin[axis] += 0.5 * (spacing - 1.0);
  }
  source->SetSize(size);
  source->SetOrigin(origin);
  source->SetSpacing(SourceType::SpacingType(spacing));
  return source;
}

mmm::Vector
PositionOf(const ImageType * image, const ImageType::IndexType & index)
{
  ImageType::PointType point;
  image->TransformIndexToPhysicalPoint(index, point);
  return mmm::Vector(point[0], point[1], point[2]);
}

/** Calls body(index, label, neighborIndex, neighborLabel) for the voxel pairs that share a face between two labels. */
template <typename TBody>
void
ForEachContact(const ImageType * image, const TBody & body)
{
  const auto region = image->GetLargestPossibleRegion();
  for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, region); !it.IsAtEnd(); ++it)
  {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      auto neighbor = it.GetIndex();
      ++neighbor[axis];
      if (region.IsInside(neighbor) && image->GetPixel(neighbor) != it.Get())
      {
        body(it.GetIndex(), it.Get(), neighbor, image->GetPixel(neighbor));
      }
    }
  }
}

/** The sizes of the face-connected components of a label, in voxels, the largest first. */
std::vector<itk::SizeValueType>
ComponentSizes(const ImageType * image, unsigned char label)
{
  using ComponentImageType = itk::Image<unsigned int, 3>;
  const auto mask = ImageType::New();
  mask->SetRegions(image->GetBufferedRegion());
  mask->Allocate();
  const auto * begin = image->GetBufferPointer();
  std::transform(begin,
                 begin + image->GetBufferedRegion().GetNumberOfPixels(),
                 mask->GetBufferPointer(),
                 [label](unsigned char value) { return value == label ? 1 : 0; });
  const auto components = itk::ConnectedComponentImageFilter<ImageType, ComponentImageType>::New();
  components->SetInput(mask);
  const auto relabel = itk::RelabelComponentImageFilter<ComponentImageType, ComponentImageType>::New();
  relabel->SetInput(components->GetOutput());
  relabel->Update();
  const auto & sizes = relabel->GetSizeOfObjectsInPixels();
  return { sizes.begin(), sizes.end() };
}

class HeadPhantomImageSource : public ::testing::Test
{
protected:
  static void
  SetUpTestSuite()
  {
    const auto source = SourceType::New();
    source->Update();
    s_Head = source->GetOutput();
    for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(s_Head, s_Head->GetBufferedRegion()); !it.IsAtEnd(); ++it)
    {
      ASSERT_LT(it.Get(), labelCount);
      ++s_Volume[it.Get()];
    }
  }

  static void
  TearDownTestSuite()
  {
    s_Head = nullptr;
  }

  static ImageType::Pointer             s_Head;
  static std::array<double, labelCount> s_Volume;
};

ImageType::Pointer             HeadPhantomImageSource::s_Head;
std::array<double, labelCount> HeadPhantomImageSource::s_Volume{};
} // namespace

TEST_F(HeadPhantomImageSource, HasTheVolumesOfAHead)
{
  constexpr double milliliter = 1000.0;
  EXPECT_GT(s_Volume[Outside], 2000 * milliliter);
  EXPECT_GT(s_Volume[Scalp], 1000 * milliliter);
  EXPECT_NEAR(s_Volume[Skull], 600 * milliliter, 200 * milliliter);
  EXPECT_NEAR(s_Volume[Fluid], 350 * milliliter, 150 * milliliter);
  EXPECT_NEAR(s_Volume[Gray], 600 * milliliter, 150 * milliliter);
  EXPECT_NEAR(s_Volume[White], 550 * milliliter, 150 * milliliter);
  EXPECT_NEAR(s_Volume[Air], 50 * milliliter, 30 * milliliter);
}

TEST_F(HeadPhantomImageSource, LayersTouchOnlyTheirNeighbors)
{
  std::array<std::array<int, labelCount>, labelCount> contacts{};
  ForEachContact(s_Head, [&](const auto &, unsigned char a, const auto &, unsigned char b) {
    ++contacts[std::min(a, b)][std::max(a, b)];
  });
  const std::vector<std::pair<int, int>> wanted{ { Outside, Scalp }, { Scalp, Skull }, { Skull, Fluid },
                                                 { Fluid, Gray },    { Gray, White },  { Fluid, White },
                                                 { Scalp, Air },     { Skull, Air } };
  for (int a = 0; a < int(labelCount); ++a)
  {
    for (int b = a + 1; b < int(labelCount); ++b)
    {
      const bool touch = std::find(wanted.begin(), wanted.end(), std::make_pair(a, b)) != wanted.end();
      EXPECT_EQ(contacts[a][b] > 0, touch) << "labels " << a << " and " << b << ": " << contacts[a][b] << " faces";
    }
  }
}

TEST_F(HeadPhantomImageSource, WhiteMatterTouchesFluidOnlyAtTheVentricles)
{
  int atVentricles = 0;
  int elsewhere = 0;
  ForEachContact(s_Head, [&](const auto & indexA, unsigned char a, const auto & indexB, unsigned char b) {
    if (a + b == Fluid + White && std::min(a, b) == Fluid)
    {
      const auto fluid = PositionOf(s_Head, a == Fluid ? indexA : indexB);
      ++(mmm::HeadPhantomVentricles(fluid) < 0 ? atVentricles : elsewhere);
    }
  });
  EXPECT_EQ(elsewhere, 0);
  EXPECT_GT(atVentricles, 1000);
}

TEST_F(HeadPhantomImageSource, EachTissueButAirIsOnePiece)
{
  for (const unsigned char label : { Outside, Scalp, Skull, Fluid, Gray, White })
  {
    const auto sizes = ComponentSizes(s_Head, label);
    EXPECT_GT(sizes.front(), 0.99 * s_Volume[label]) << "label " << int(label);
  }
}

TEST_F(HeadPhantomImageSource, AirComesInSeveralPockets)
{
  const auto sizes = ComponentSizes(s_Head, Air);
  EXPECT_EQ(sizes.size(), 10u);
  EXPECT_GT(sizes.back(), 500u);
}

TEST_F(HeadPhantomImageSource, OnlyTheLowerBorderCutsTheHead)
{
  const auto region = s_Head->GetLargestPossibleRegion();
  int        cut = 0;
  int        touching = 0;
  for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(s_Head, region); !it.IsAtEnd(); ++it)
  {
    const auto index = it.GetIndex();
    const bool lower = index[2] == 0;
    bool       other = false;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      other |= index[axis] == region.GetUpperIndex()[axis] || (axis < 2 && index[axis] == 0);
    }
    cut += lower && it.Get() != Outside;
    touching += other && it.Get() != Outside;
  }
  EXPECT_GT(cut, 10000);
  EXPECT_EQ(touching, 0);
}

TEST_F(HeadPhantomImageSource, SpacingAndDirectionOnlySampleTheSameHead)
{
  // Every third voxel of the 1 mm image, counted backwards along two axes.
  const auto source = SourceType::New();
  auto       origin = source->GetOrigin();
  auto       direction = source->GetDirection();
  auto       size = source->GetSize();
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] /= 3;
    if (axis < 2)
    {
      origin[axis] += 3.0 * (size[axis] - 1);
      direction[axis][axis] = -1.0;
    }
  }
  source->SetSize(size);
  source->SetOrigin(origin);
  source->SetDirection(direction);
  source->SetSpacing(SourceType::SpacingType(3.0));
  source->Update();
  const ImageType * coarse = source->GetOutput();
  int               different = 0;
  for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(coarse, coarse->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    ImageType::PointType point;
    coarse->TransformIndexToPhysicalPoint(it.GetIndex(), point);
    const auto index = s_Head->TransformPhysicalPointToIndex(point);
    different += it.Get() != s_Head->GetPixel(index);
  }
  EXPECT_EQ(different, 0);
}

TEST_F(HeadPhantomImageSource, VolumesDoNotDependOnTheSpacing)
{
  constexpr double spacing = 2.0;
  const auto       source = MakeSource(spacing);
  source->Update();
  std::array<double, labelCount> volume{};
  const ImageType *              image = source->GetOutput();
  for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    volume[it.Get()] += spacing * spacing * spacing;
  }
  for (const unsigned char label : { Scalp, Skull, Fluid, Gray, White, Air })
  {
    EXPECT_NEAR(volume[label], s_Volume[label], 0.02 * s_Volume[label]) << "label " << int(label);
  }
}

TEST_F(HeadPhantomImageSource, IsTheSameForAnyNumberOfThreads)
{
  std::vector<unsigned char> expected;
  for (const unsigned int workUnits : { 1u, 2u, 7u })
  {
    const auto source = MakeSource(4.0);
    source->SetNumberOfWorkUnits(workUnits);
    source->Update();
    const auto *                     begin = source->GetOutput()->GetBufferPointer();
    const std::vector<unsigned char> labels(begin,
                                            begin + source->GetOutput()->GetBufferedRegion().GetNumberOfPixels());
    if (expected.empty())
    {
      expected = labels;
    }
    EXPECT_EQ(labels, expected) << workUnits << " work units";
  }
}

TEST_F(HeadPhantomImageSource, FillsTheRequestedRegionOnly)
{
  const auto                  source = SourceType::New();
  const ImageType::RegionType region({ { 60, 70, 80 } }, { { 20, 30, 10 } });
  source->UpdateOutputInformation();
  source->GetOutput()->SetRequestedRegion(region);
  source->Update();
  ASSERT_EQ(source->GetOutput()->GetBufferedRegion(), region);
  int different = 0;
  for (itk::ImageRegionConstIteratorWithIndex<ImageType> it(source->GetOutput(), region); !it.IsAtEnd(); ++it)
  {
    different += it.Get() != s_Head->GetPixel(it.GetIndex());
  }
  EXPECT_EQ(different, 0);
}

TEST_F(HeadPhantomImageSource, CanBeAborted)
{
  const auto source = MakeSource(4.0);
  const auto command = itk::CStyleCommand::New();
  command->SetCallback([](itk::Object * caller, const itk::EventObject &, void *) {
    static_cast<SourceType *>(caller)->AbortGenerateDataOn();
  });
  source->AddObserver(itk::ProgressEvent(), command);
  source->SetNumberOfWorkUnits(1);
  EXPECT_THROW(source->Update(), itk::ProcessAborted);
}

TEST_F(HeadPhantomImageSource, PrintsItsParameters)
{
  const auto         source = SourceType::New();
  std::ostringstream text;
  source->Print(text);
  for (const char * name : { "Size: [181, 217, 181]", "Spacing: [1, 1, 1]", "Origin: [-90, -114, -92]", "Direction: " })
  {
    EXPECT_NE(text.str().find(name), std::string::npos) << name << '\n' << text.str();
  }
}
