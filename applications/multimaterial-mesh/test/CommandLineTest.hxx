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
#ifndef CommandLineTest_hxx
#define CommandLineTest_hxx

#include "itkImageFileWriter.h"

template <typename TImage>
std::string
CommandLine::WriteImage(const TImage * image, const std::string & name) const
{
  auto writer = itk::ImageFileWriter<TImage>::New();
  writer->SetInput(image);
  writer->SetFileName(this->Path(name));
  writer->Update();
  return this->Path(name);
}

template <typename TPixel, unsigned int VDimension>
typename itk::Image<TPixel, VDimension>::Pointer
CommandLine::MakeImage(const itk::Size<VDimension> & size)
{
  auto image = itk::Image<TPixel, VDimension>::New();
  image->SetRegions(size);
  image->Allocate(true);
  return image;
}

#endif
