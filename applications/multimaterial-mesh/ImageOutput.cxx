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
#include "ImageOutput.h"

#include "Errors.h"
#include "OutputFile.h"
#include "StreamCapture.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"

#include <algorithm>

namespace cli
{
namespace
{
/** ITK's image writers do not notice that a disk is full. */
void
CheckWritten(const ScalarImage & image, const std::string & fileName)
{
  auto reader = itk::ImageFileReader<ScalarImage>::New();
  reader->SetFileName(fileName);
  reader->Update();
  const auto          count = image.GetBufferedRegion().GetNumberOfPixels();
  const float * const written = reader->GetOutput()->GetBufferPointer();
  if (reader->GetOutput()->GetBufferedRegion().GetNumberOfPixels() != count ||
      !std::equal(written, written + count, image.GetBufferPointer()))
  {
    throw Error("the file is incomplete");
  }
}
} // namespace

void
CheckImageName(const std::string & option, const std::string & fileName)
{
  // Formats of a single file, so that it can be renamed once it is complete.
  const std::string extensions[] = { ".nrrd", ".nii", ".nii.gz", ".mha" };
  if (std::none_of(std::begin(extensions), std::end(extensions), [&](const std::string & extension) {
        return fileName.size() > extension.size() &&
               fileName.compare(fileName.size() - extension.size(), extension.size(), extension) == 0;
      }))
  {
    throw UsageError(option + " is '" + fileName + "'; images are written as .nrrd, .nii, .nii.gz or .mha");
  }
}

void
WriteImage(const ScalarImage * image, const std::string & fileName)
{
  OutputFile    file(fileName);
  StreamCapture capture;
  try
  {
    auto writer = itk::ImageFileWriter<ScalarImage>::New();
    writer->SetInput(image);
    writer->SetFileName(file.GetTemporaryName());
    writer->UseCompressionOn();
    writer->Update();
    CheckWritten(*image, file.GetTemporaryName());
  }
  catch (const itk::MemoryAllocationError &)
  {
    throw;
  }
  catch (const std::exception &)
  {
    throw Error("cannot write " + fileName + ", the disk may be full: " + DescribeCurrentException());
  }
  file.Commit();
}
} // namespace cli
