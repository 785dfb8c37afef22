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
#include "phantom/itkHeadPhantomImageSource.h"

#include "itkImageFileWriter.h"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

namespace
{
/** Not atof(): that follows the locale and takes anything. */
double
Parse(const char * text)
{
  std::istringstream stream{ text };
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !stream.eof() || !(value > 0.0))
  {
    throw std::invalid_argument(std::string("not a positive number: ") + text);
  }
  return value;
}
} // namespace

int
main(int argc, char * argv[])
{
  if ((argc != 2 && argc != 3 && argc != 6) || argv[1][0] == '-')
  {
    std::cerr << "usage: " << argv[0] << " OUTPUT.nrrd [SPACING-MM [SIZE-X SIZE-Y SIZE-Z]]\n"
              << "Writes a synthetic six-tissue head. Without a size, the image covers 181 x 217 x 181 mm.\n";
    return EXIT_FAILURE;
  }
  try
  {
    using ImageType = itk::Image<unsigned char, 3>;
    const auto source = itk::HeadPhantomImageSource<ImageType>::New();
    const auto box = source->GetSize();
    auto       size = box;
    auto       origin = source->GetOrigin();
    const auto spacing = argc > 2 ? Parse(argv[2]) : 1.0;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      size[axis] = std::llround(argc > 3 ? Parse(argv[3 + axis]) : box[axis] / spacing);
      // The default box and this one share their centre from left to right and front to back, and their top.
      const double excess = size[axis] * spacing - box[axis];
      const double lower = origin[axis] - 0.5 - (axis == 2 ? excess : 0.5 * excess);
      origin[axis] = lower + 0.5 * spacing;
    }
    source->SetSize(size);
    source->SetOrigin(origin);
    source->SetSpacing(ImageType::SpacingType(spacing));

    const auto writer = itk::ImageFileWriter<ImageType>::New();
    writer->SetInput(source->GetOutput());
    writer->SetFileName(argv[1]);
    writer->UseCompressionOn();
    writer->Update();
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
