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
#include "input/TensorVolume.h"

#include "input/ImageChecks.h"
#include "input/NrrdHeader.h"
#include "input/RawVolume.h"

#include "itkImageFileReader.h"
#include "itkImageIOFactory.h"
#include "itkVectorImage.h"

#include <algorithm>

namespace mmm
{
namespace
{
using Tensor = TensorImage::PixelType;
using Frame = itk::Matrix<double, 3, 3>;

constexpr unsigned int Components = 6;

/** False if ITK cannot read the header: whoever reads the voxels says why. */
bool
HasComponentsForITK(const std::string & fileName)
{
  const auto io = itk::ImageIOFactory::CreateImageIO(fileName.c_str(), itk::IOFileModeEnum::ReadMode);
  if (io.IsNull())
  {
    return false;
  }
  try
  {
    io->SetFileName(fileName);
    io->ReadImageInformation();
  }
  catch (const itk::ExceptionObject &)
  {
    return false;
  }
  return io->GetNumberOfDimensions() == 3 && io->GetNumberOfComponents() == Components;
}

TensorImage::Pointer
MakeImage(const itk::ImageBase<3> & like)
{
  const auto image = TensorImage::New();
  image->CopyInformation(&like);
  image->SetRegions(like.GetLargestPossibleRegion());
  image->Allocate();
  return image;
}

/** The axes of the voxels, in LPS. */
Frame
VoxelAxes(const itk::ImageBase<3> & image)
{
  return image.GetDirection();
}

Frame
AxesOfRAS()
{
  Frame frame;
  frame.SetIdentity();
  frame[0][0] = frame[1][1] = -1.0;
  return frame;
}

TensorImage::Pointer
ReadNiftiTensors(const RawVolume & volume)
{
  // where the file's components are in ITK's order, which is that of the upper triangle
  constexpr unsigned int places[Components] = { 0, 1, 3, 2, 4, 5 };
  const auto             components = ReadComponents(volume, Components);
  const auto             image = MakeImage(*components.front());
  const std::size_t      count = image->GetBufferedRegion().GetNumberOfPixels();
  for (unsigned int c = 0; c < Components; ++c)
  {
    const float * const values = components[c]->GetBufferPointer();
    for (std::size_t n = 0; n < count; ++n)
    {
      image->GetBufferPointer()[n][places[c]] = values[n];
    }
  }
  return image;
}

TensorImage::Pointer
ReadTensorsByITK(const std::string & fileName)
{
  using VectorImage = itk::VectorImage<float, 3>;
  const auto reader = itk::ImageFileReader<VectorImage>::New();
  reader->SetFileName(fileName);
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
    ThrowDamaged(fileName, exception.GetDescription());
  }
  const VectorImage & components = *reader->GetOutput();
  if (components.GetNumberOfComponentsPerPixel() != Components)
  {
    itkGenericExceptionMacro(<< fileName << ": the voxels have " << components.GetNumberOfComponentsPerPixel()
                             << " components; a symmetric tensor has 6");
  }
  const auto    image = MakeImage(components);
  const float * value = components.GetBufferPointer();
  for (std::size_t n = 0; n < image->GetBufferedRegion().GetNumberOfPixels(); ++n, value += Components)
  {
    std::copy_n(value, Components, image->GetBufferPointer()[n].Begin());
  }
  return image;
}

void
Turn(TensorImage & image, const Frame & frame)
{
  Frame identity;
  identity.SetIdentity();
  if (frame == identity)
  {
    return;
  }
  Tensor * const tensors = image.GetBufferPointer();
  std::for_each(tensors, tensors + image.GetBufferedRegion().GetNumberOfPixels(), [&](Tensor & tensor) {
    tensor = tensor.Rotate(frame);
  });
}
} // namespace

bool
HasTensors(const std::string & fileName)
{
  return OpenNiftiTensors(fileName) || HasComponentsForITK(fileName);
}

TensorImage::Pointer
ReadTensors(const std::string & fileName, bool inVoxelAxes, std::vector<std::string> & notes)
{
  CheckFile(fileName);
  if (const auto volume = OpenNiftiTensors(fileName))
  {
    const auto image = ReadNiftiTensors(*volume);
    notes.insert(notes.end(), volume->notes.begin(), volume->notes.end());
    notes.emplace_back(inVoxelAxes ? "its tensors are taken along the axes of its voxels"
                                   : "its tensors are taken along right, anterior and superior, as NIfTI does not say");
    Turn(*image, inVoxelAxes ? VoxelAxes(*image) : AxesOfRAS());
    return image;
  }
  const auto image = ReadTensorsByITK(fileName);
  if (const auto place = ReadNrrdPlace(fileName, notes))
  {
    SetAffine(*place, *image);
  }
  Turn(*image, inVoxelAxes ? VoxelAxes(*image) : ReadNrrdFrame(fileName));
  return image;
}
} // namespace mmm
