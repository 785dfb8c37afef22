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
#ifndef mmmTestLabelImages_h
#define mmmTestLabelImages_h

#include "itkCommand.h"
#include "itkImage.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkMultiThreaderBase.h"
#include "itkProcessObject.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

/** Small label images and other things that the tests of several filters need. */
namespace mmmtest
{
/** An image whose label at a voxel is label(i, j, k), voxels counted from the region's start. */
template <typename TImage, typename TFunction>
typename TImage::Pointer
MakeImage(int nx, int ny, int nz, const TFunction & label)
{
  const auto                  image = TImage::New();
  typename TImage::RegionType region;
  region.SetSize({ { itk::SizeValueType(nx), itk::SizeValueType(ny), itk::SizeValueType(nz) } });
  image->SetRegions(region);
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<TImage> it(image, region); !it.IsAtEnd(); ++it)
  {
    const auto & at = it.GetIndex();
    it.Set(static_cast<typename TImage::PixelType>(label(int(at[0]), int(at[1]), int(at[2]))));
  }
  return image;
}

/** Whether a voxel of a cube image of that size is in the ball around its centre; the radius is in voxels. */
inline bool
IsInBall(int i, int j, int k, int size, double radius)
{
  const double c = 0.5 * (size - 1);
  return std::hypot(i - c, j - c, k - c) < radius;
}

/** Label 1 in a ball, 0 around it. */
template <typename TImage>
typename TImage::Pointer
MakeBall(int size, double radius)
{
  return MakeImage<TImage>(
    size, size, size, [=](int i, int j, int k) { return IsInBall(i, j, k, size, radius) ? 1 : 0; });
}

/** Label `first` in the lower half of a ball and `second` in its upper half, 0 around it: all three meet in a circle.
 */
template <typename TImage>
typename TImage::Pointer
MakeHalves(int size, double radius, int first = 1, int second = 2)
{
  return MakeImage<TImage>(size, size, size, [=](int i, int j, int k) {
    return !IsInBall(i, j, k, size, radius) ? 0 : (2 * k < size ? first : second);
  });
}

/** Sets spacing, origin and direction: a rotation by a right angle and more, reflected if asked for. */
template <typename TImage>
void
SetObliqueGeometry(TImage * image, double unit, bool reflect)
{
  typename TImage::PointType origin;
  origin[0] = 12.5 * unit;
  origin[1] = -7.0 * unit;
  origin[2] = 100.0 * unit;
  image->SetOrigin(origin);
  const double                   a = 0.4;
  const double                   b = -1.1;
  const double                   sign = reflect ? -1.0 : 1.0;
  typename TImage::DirectionType direction;
  direction[0][0] = std::cos(a);
  direction[0][1] = -std::sin(a) * std::cos(b);
  direction[0][2] = sign * std::sin(a) * std::sin(b);
  direction[1][0] = std::sin(a);
  direction[1][1] = std::cos(a) * std::cos(b);
  direction[1][2] = sign * -std::cos(a) * std::sin(b);
  direction[2][0] = 0.0;
  direction[2][1] = std::sin(b);
  direction[2][2] = sign * std::cos(b);
  image->SetDirection(direction);
}

/** Expects that run() throws an itk::ExceptionObject whose words contain `words`. */
template <typename TFunction>
void
ExpectException(const TFunction & run, const std::string & words)
{
  try
  {
    run();
    ADD_FAILURE() << "no exception; expected one with: " << words;
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find(words), std::string::npos) << error.GetDescription();
  }
}

/** Tells a filter to abort as soon as it has made some progress. */
inline void
AbortOnProgress(itk::ProcessObject * filter)
{
  filter->AddObserver(itk::ProgressEvent(), [filter](const itk::EventObject &) { filter->AbortGenerateDataOn(); });
}

/** Counts how often a filter has run. */
class RunCounter
{
public:
  explicit RunCounter(itk::ProcessObject * filter)
  {
    filter->AddObserver(itk::StartEvent(), [this](const itk::EventObject &) { ++m_Count; });
  }
  int
  GetCount() const
  {
    return m_Count;
  }

private:
  int m_Count{ 0 };
};

/** Sets the number of threads, until the end of the scope. */
class ThreadCount
{
public:
  explicit ThreadCount(itk::ThreadIdType count)
    : m_Before(itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads())
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(count);
  }
  ~ThreadCount() { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(m_Before); }
  ThreadCount(const ThreadCount &) = delete;
  ThreadCount &
  operator=(const ThreadCount &) = delete;

private:
  itk::ThreadIdType m_Before;
};

/** What Print() writes. */
template <typename TObject>
std::string
Printed(const TObject * object)
{
  std::ostringstream os;
  object->Print(os);
  return os.str();
}
} // namespace mmmtest

#endif
