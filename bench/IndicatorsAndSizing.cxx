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
// Runs the two filters before the meshing on a label image and prints their time and the peak memory so far.

#include "itkIndicatorImagesToSizingImageFilter.h"
#include "itkLabelImageToIndicatorImagesFilter.h"
#include "base/PeakMemory.h"

#include "itkImageFileReader.h"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <iostream>

namespace
{
using LabelImage = itk::Image<int, 3>;
using FloatImage = itk::Image<float, 3>;

/** FNV-1a of an image's values: equal for equal images. */
std::uint64_t
Checksum(const FloatImage * image, std::uint64_t sum)
{
  const float * values = image->GetBufferPointer();
  const auto    count = image->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t n = 0; n < count; ++n)
  {
    std::uint32_t bits;
    std::memcpy(&bits, values + n, sizeof(bits));
    sum = (sum ^ bits) * 1099511628211ull;
  }
  return sum;
}

template <typename TStage>
void
Time(const char * name, std::size_t voxels, const TStage & stage)
{
  const auto start = std::chrono::steady_clock::now();
  const auto startClock = std::clock();
  stage();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::printf("%-12s %9.2f %9.2f %12.0f %9.0f\n",
              name,
              elapsed.count(),
              double(std::clock() - startClock) / CLOCKS_PER_SEC,
              1e9 * elapsed.count() / voxels,
              mmm::PeakMemory());
  std::fflush(stdout);
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 2 || argc > 3)
  {
    std::cerr << "usage: " << argv[0] << " LABELS [THREADS]\n";
    return EXIT_FAILURE;
  }
  try
  {
    if (argc > 2)
    {
      itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(std::max(1, std::atoi(argv[2])));
    }
    const auto reader = itk::ImageFileReader<LabelImage>::New();
    reader->SetFileName(argv[1]);
    reader->Update();
    const LabelImage::Pointer labels = reader->GetOutput();
    const auto                voxels = labels->GetBufferedRegion().GetNumberOfPixels();

    const auto indicators = itk::LabelImageToIndicatorImagesFilter<LabelImage>::New();
    indicators->SetInput(labels);
    std::printf("%-12s %9s %9s %12s %9s\n", "filter", "seconds", "CPU s", "ns per voxel", "peak MB");
    Time("indicators", voxels, [&] { indicators->Update(); });

    const auto sizing = itk::IndicatorImagesToSizingImageFilter<FloatImage>::New();
    for (unsigned int n = 0; n < indicators->GetNumberOfIndexedOutputs(); ++n)
    {
      sizing->SetInput(n, indicators->GetOutput(n));
    }
    if (indicators->GetLabels().front() == 0)
    {
      sizing->SetExteriorIndex(0);
    }
    Time("sizing", voxels, [&] { sizing->Update(); });

    std::uint64_t sum = 14695981039346656037ull;
    for (unsigned int n = 0; n < indicators->GetNumberOfIndexedOutputs(); ++n)
    {
      sum = Checksum(indicators->GetOutput(n), sum);
    }
    std::printf("%zu voxels, %zu labels; checksums %016llx %016llx\n",
                static_cast<std::size_t>(voxels),
                indicators->GetLabels().size(),
                static_cast<unsigned long long>(sum),
                static_cast<unsigned long long>(Checksum(sizing->GetOutput(), 14695981039346656037ull)));
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
