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
#include "ImageInput.h"

#include "Errors.h"
#include "NiftiCheck.h"
#include "StreamCapture.h"
#include "Warnings.h"

#include "itkImageFileReader.h"
#include "itkImageIOFactory.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkImageRegionIterator.h"
#include "itkMetaImageIO.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace cli
{
namespace
{
const char * const Formats = "supported are .nrrd, .nii, .nii.gz, .mha and .mhd";

void
CheckFile(const std::string & fileName)
{
  const std::filesystem::path path = std::filesystem::u8path(fileName);
  std::error_code             error;
  const auto                  status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw Error(fileName + ": there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    throw Error(fileName + ": this is a folder; an image file is needed");
  }
  if (!std::ifstream(path, std::ios::binary))
  {
    throw Error(fileName + ": the file cannot be opened; check its permissions");
  }
}

void
CheckDimension(const std::string & fileName, const itk::ImageIOBase & io)
{
  std::ostringstream size;
  unsigned int       extents = 0;
  for (unsigned int d = 0; d < io.GetNumberOfDimensions(); ++d)
  {
    size << (d > 0 ? "x" : "") << io.GetDimensions(d);
    extents += io.GetDimensions(d) > 1 || d < 3;
  }
  if (io.GetNumberOfDimensions() < 3 || io.GetDimensions(2) == 1)
  {
    throw Error(fileName + ": the image is a single slice (" + size.str() + "); a three-dimensional image is needed");
  }
  if (extents > 3)
  {
    throw Error(fileName + ": the image has more than three dimensions (" + size.str() +
                "); extract one three-dimensional label image from it first");
  }
}

[[noreturn]] void
ThrowDamaged(const std::string & fileName, const std::string & reason)
{
  throw Error(fileName + ": the image cannot be read, it may be damaged: " + reason);
}

/** What a library has printed about a file that it could read. */
void
WarnOfComplaint(const std::string & fileName, const std::string & complaint)
{
  if (!complaint.empty())
  {
    Warn(fileName + ": " + ToOneLine(complaint));
  }
}

template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
Read(const std::string & fileName, itk::ImageIOBase * io)
{
  auto reader = itk::ImageFileReader<itk::Image<TPixel, 3>>::New();
  reader->SetFileName(fileName);
  reader->SetImageIO(io);
  StreamCapture capture;
  try
  {
    reader->Update();
  }
  catch (const itk::MemoryAllocationError &)
  {
    throw;
  }
  catch (const itk::ExceptionObject & exception)
  {
    ThrowDamaged(fileName, ToOneLine(exception.GetDescription()));
  }
  const std::string complaint = capture.Finish();
  // This reader does not fail where the end of the file is missing.
  if (!complaint.empty() && dynamic_cast<itk::MetaImageIO *>(io) != nullptr)
  {
    ThrowDamaged(fileName, ToOneLine(complaint));
  }
  WarnOfComplaint(fileName, complaint);
  typename itk::Image<TPixel, 3>::Pointer image = reader->GetOutput();
  image->DisconnectPipeline();
  return image;
}

template <typename TPixel>
bool
IsLabel(TPixel value)
{
  return value >= std::numeric_limits<int>::min() && value <= std::numeric_limits<int>::max() &&
         TPixel(int(value)) == value;
}

template <typename TPixel>
[[noreturn]] void
ThrowNoLabel(const std::string & fileName, const itk::Index<3> & index, TPixel value)
{
  std::ostringstream message;
  message << fileName << ": voxel (" << index[0] << ',' << index[1] << ',' << index[2] << ") has the value " << value;
  if (std::isfinite(double(value)) && std::floor(double(value)) == double(value))
  {
    message << "; labels have to be from " << std::numeric_limits<int>::min() << " to "
            << std::numeric_limits<int>::max();
  }
  else
  {
    message << "; a label image has integer values. Is this an intensity or probability image?";
  }
  throw Error(message.str());
}

/** Reads pixels of a type that holds more than labels, and takes them for labels if all of them are. */
template <typename TPixel>
LabelImage::Pointer
ReadAndCast(const std::string & fileName, itk::ImageIOBase * io)
{
  const auto image = Read<TPixel>(fileName, io);
  auto       labels = LabelImage::New();
  labels->CopyInformation(image);
  labels->SetRegions(image->GetBufferedRegion());
  labels->Allocate();
  itk::ImageRegionIterator<LabelImage> label(labels, labels->GetBufferedRegion());
  for (itk::ImageRegionConstIteratorWithIndex<itk::Image<TPixel, 3>> voxel(image, image->GetBufferedRegion());
       !voxel.IsAtEnd();
       ++voxel, ++label)
  {
    if (!IsLabel(voxel.Get()))
    {
      ThrowNoLabel(fileName, voxel.GetIndex(), voxel.Get());
    }
    label.Set(int(voxel.Get()));
  }
  return labels;
}
} // namespace

itk::ImageIOBase::Pointer
OpenImage(const std::string & fileName)
{
  CheckFile(fileName);
  const std::string damage = FindNiftiDamage(fileName);
  if (!damage.empty())
  {
    ThrowDamaged(fileName, damage);
  }
  StreamCapture capture;
  const auto    io = itk::ImageIOFactory::CreateImageIO(fileName.c_str(), itk::IOFileModeEnum::ReadMode);
  if (io.IsNull())
  {
    throw Error(fileName + ": this is not an image file, or one of a format that cannot be read; " + Formats);
  }
  io->SetFileName(fileName);
  try
  {
    io->ReadImageInformation();
  }
  catch (const itk::ExceptionObject & exception)
  {
    ThrowDamaged(fileName, ToOneLine(exception.GetDescription()));
  }
  WarnOfComplaint(fileName, capture.Finish());
  CheckDimension(fileName, *io);
  if (io->GetNumberOfComponents() != 1)
  {
    std::ostringstream message;
    message << fileName << ": the voxels have " << io->GetNumberOfComponents()
            << " components; an image with one value per voxel is needed";
    throw Error(message.str());
  }
  return io;
}

LabelImage::Pointer
ReadLabelImage(const std::string & fileName)
{
  const auto io = OpenImage(fileName);
  switch (io->GetComponentType())
  {
    case itk::IOComponentEnum::FLOAT:
    case itk::IOComponentEnum::DOUBLE:
    case itk::IOComponentEnum::LDOUBLE:
      return ReadAndCast<double>(fileName, io);
    case itk::IOComponentEnum::UINT:
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::LONG:
    case itk::IOComponentEnum::ULONGLONG:
    case itk::IOComponentEnum::LONGLONG:
      return ReadAndCast<long long>(fileName, io);
    default:
      return Read<int>(fileName, io);
  }
}

ScalarImage::Pointer
ReadScalarImage(const std::string & fileName)
{
  return Read<float>(fileName, OpenImage(fileName));
}
} // namespace cli
