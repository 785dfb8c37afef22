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
#include "itkVolumeFileReader.h"

#include "input/GzipFile.h"
#include "input/ImageChecks.h"
#include "input/LabelValue.h"
#include "input/MetaImageData.h"
#include "input/NrrdHeader.h"
#include "input/RawVolume.h"
#include "input/SegmentLayers.h"
#include "input/TensorVolume.h"

#include "itkImageFileReader.h"
#include "itkImageIOFactory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <type_traits>

namespace itk
{
namespace
{
const char * const Formats = "supported are .nrrd, .nii, .nii.gz, .mha, .mhd and .mgz";

/** ITK says where in its code something is wrong, on several lines. */
std::string
ReasonOf(const ExceptionObject & exception)
{
  std::string        text = exception.GetDescription();
  const auto         colon = text.find("): ");
  std::istringstream words(colon == std::string::npos ? text : text.substr(colon + 3));
  std::string        reason;
  for (std::string word; words >> word;)
  {
    reason += (reason.empty() ? "" : " ") + word;
  }
  // NRRD's library tells each of its functions
  constexpr std::size_t longest = 200;
  return reason.size() > longest ? reason.substr(0, reason.rfind(' ', longest)) + " ..." : reason;
}

bool
IsDICOM(const std::string & fileName)
{
  std::ifstream stream(std::filesystem::u8path(fileName), std::ios::binary);
  char          magic[4] = {};
  stream.seekg(128);
  stream.read(magic, 4);
  return std::string(magic, 4) == "DICM";
}

/** Before memory is taken for what a damaged header says. */
void
CheckFileSize(const std::string & fileName, const ImageIOBase & io)
{
  double expected = io.GetComponentSize() * io.GetNumberOfComponents();
  for (unsigned int d = 0; d < io.GetNumberOfDimensions(); ++d)
  {
    expected *= static_cast<double>(io.GetDimensions(d));
  }
  if (mmm::HasExtension(fileName, { ".nrrd" }))
  {
    // zlib cannot do more
    constexpr double highestCompression = 1032.0;
    std::error_code  error;
    const auto fileSize = static_cast<double>(std::filesystem::file_size(std::filesystem::u8path(fileName), error));
    if (!error && fileSize * highestCompression < expected)
    {
      mmm::ThrowDamaged(fileName,
                        "it is too short for the " + mmm::DigitsOf(expected) + " bytes of data that its header says");
    }
  }
  if (mmm::HasExtension(fileName, { ".mha", ".mhd" }))
  {
    mmm::CheckMetaImageData(fileName, expected);
  }
}

/** Finds out who reads the file, and checks that it is a three-dimensional image of scalars. */
ImageIOBase::Pointer
OpenByITK(const std::string & fileName)
{
  if (IsDICOM(fileName))
  {
    itkGenericExceptionMacro(<< fileName
                             << ": this is a DICOM file; convert it first, a segmentation by dcmqi (segimage2itkimage "
                                "--inputDICOM FILE --outputDirectory FOLDER), a series by dcm2niix (dcm2niix FOLDER)");
  }
  const auto io = ImageIOFactory::CreateImageIO(fileName.c_str(), IOFileModeEnum::ReadMode);
  if (io.IsNull())
  {
    itkGenericExceptionMacro(<< fileName << ": this is not an image file, or one of a format that cannot be read; "
                             << Formats);
  }
  io->SetFileName(fileName);
  try
  {
    io->ReadImageInformation();
  }
  catch (const ExceptionObject & exception)
  {
    mmm::ThrowDamaged(fileName, ReasonOf(exception));
  }
  std::vector<std::int64_t> size;
  for (unsigned int d = 0; d < io->GetNumberOfDimensions(); ++d)
  {
    size.push_back(static_cast<std::int64_t>(io->GetDimensions(d)));
  }
  mmm::CheckDimensions(fileName, size);
  if (io->GetComponentType() == IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    mmm::ThrowDamaged(fileName, "its header says of no known type what the voxels are");
  }
  CheckFileSize(fileName, *io);
  if (io->GetNumberOfComponents() != 1 && mmm::FindSegments(*io).empty())
  {
    itkGenericExceptionMacro(<< fileName << ": the voxels have " << io->GetNumberOfComponents()
                             << " components; an image with one value per voxel is needed");
  }
  return io;
}

template <typename TImage>
typename TImage::Pointer
ReadByITK(const std::string & fileName, ImageIOBase * io)
{
  const auto reader = ImageFileReader<TImage>::New();
  reader->SetFileName(fileName);
  reader->SetImageIO(io);
  try
  {
    reader->Update();
  }
  catch (const MemoryAllocationError &)
  {
    throw;
  }
  catch (const ExceptionObject & exception)
  {
    mmm::ThrowDamaged(fileName, ReasonOf(exception));
  }
  typename TImage::Pointer image = reader->GetOutput();
  image->DisconnectPipeline();
  return image;
}

/** Reads pixels of a type that holds more than labels, and takes them for labels if all of them are. */
template <typename TPixel>
Image<int, 3>::Pointer
ReadAndRound(const std::string & fileName, ImageIOBase * io)
{
  const auto image = ReadByITK<Image<TPixel, 3>>(fileName, io);
  const auto labels = Image<int, 3>::New();
  labels->CopyInformation(image);
  labels->SetRegions(image->GetBufferedRegion());
  labels->Allocate();
  const std::size_t    count = image->GetBufferedRegion().GetNumberOfPixels();
  const TPixel * const values = image->GetBufferPointer();
  for (std::size_t n = 0; n < count; ++n)
  {
    if (!mmm::IsLabel(values[n], mmm::WholeNumberTolerance, labels->GetBufferPointer()[n]))
    {
      mmm::ThrowNoLabel(fileName, image->GetBufferedRegion().GetSize(), n, values[n]);
    }
  }
  return labels;
}

template <typename TNote>
Image<int, 3>::Pointer
ReadLabelsByITK(const std::string & fileName, const TNote & note)
{
  const auto io = OpenByITK(fileName);
  const auto segments = mmm::FindSegments(*io);
  if (io->GetNumberOfComponents() != 1)
  {
    std::string list;
    for (const auto & segment : segments)
    {
      list += (list.empty() ? "" : ", ") + std::to_string(segment.label) + ' ' + segment.name;
    }
    note("its " + std::to_string(io->GetNumberOfComponents()) +
         " layers of segments are made one image, where later ones cover others: " + list);
    return mmm::Flatten(*ReadByITK<VectorImage<int, 3>>(fileName, io), segments);
  }
  switch (io->GetComponentType())
  {
    case IOComponentEnum::FLOAT:
      return ReadAndRound<float>(fileName, io);
    case IOComponentEnum::DOUBLE:
    case IOComponentEnum::LDOUBLE:
      return ReadAndRound<double>(fileName, io);
    case IOComponentEnum::UINT:
    case IOComponentEnum::ULONG:
    case IOComponentEnum::ULONGLONG:
      return ReadAndRound<unsigned long long>(fileName, io);
    case IOComponentEnum::LONG:
    case IOComponentEnum::LONGLONG:
      return ReadAndRound<long long>(fileName, io);
    default:
      return ReadByITK<Image<int, 3>>(fileName, io);
  }
}

std::optional<mmm::RawVolume>
OpenRaw(const std::string & fileName)
{
  auto volume = mmm::OpenNifti(fileName);
  return volume ? volume : mmm::OpenMGH(fileName);
}
} // namespace

void
VolumeFileReader::Note(const std::string & text) const
{
  itkWarningMacro(<< m_FileName << ": " << text);
}

void
VolumeFileReader::Place(ImageBase<3> & image) const
{
  std::vector<std::string> notes;
  const auto               placeOfNrrd = mmm::ReadNrrdPlace(m_FileName, notes);
  const mmm::Affine        affine = placeOfNrrd.value_or(mmm::AffineOf(image));
  const std::string        fault = mmm::FindFault(affine);
  if (!fault.empty())
  {
    itkGenericExceptionMacro(<< m_FileName << ": the image has no place: " << fault << "; correct the header first");
  }
  for (const auto & note : notes)
  {
    this->Note(note);
  }
  // what is less is rounding of the header's numbers, and makes no difference
  constexpr double rightAngle = 89.9;
  const double     angle = mmm::SmallestAngle(affine);
  if (angle < rightAngle)
  {
    std::ostringstream text;
    text.precision(3);
    text << "its axes are not at right angles (" << angle
         << " degrees); it is meshed on its grid and the mesh is sheared with it, so that sizes and angles differ";
    this->Note(text.str());
  }
  // the image's own numbers are the more exact ones
  constexpr double tolerance = 1e-6;
  const double     distance =
    mmm::LargestDistance(affine, mmm::AffineOf(image), image.GetLargestPossibleRegion().GetSize());
  bool isUnit = true;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    isUnit = isUnit && std::abs(affine.steps[axis].GetNorm() / image.GetSpacing()[axis] - 1.0) < tolerance;
  }
  if (!isUnit || distance > tolerance * image.GetSpacing()[0])
  {
    mmm::SetAffine(affine, image);
  }
}

auto
VolumeFileReader::ReadLabels() -> LabelImageType::Pointer
{
  mmm::CheckFile(m_FileName);
  const auto raw = OpenRaw(m_FileName);
  const auto image =
    raw ? mmm::ReadLabels(*raw) : ReadLabelsByITK(m_FileName, [&](const std::string & text) { this->Note(text); });
  if (raw)
  {
    std::for_each(raw->notes.begin(), raw->notes.end(), [&](const std::string & note) { this->Note(note); });
  }
  this->Place(*image);
  return image;
}

auto
VolumeFileReader::ReadScalars() -> ScalarImageType::Pointer
{
  mmm::CheckFile(m_FileName);
  const auto raw = OpenRaw(m_FileName);
  const auto image = raw ? mmm::ReadScalars(*raw) : ReadByITK<ScalarImageType>(m_FileName, OpenByITK(m_FileName));
  if (raw)
  {
    std::for_each(raw->notes.begin(), raw->notes.end(), [&](const std::string & note) { this->Note(note); });
  }
  this->Place(*image);
  return image;
}

bool
VolumeFileReader::HasTensors() const
{
  mmm::CheckFile(m_FileName);
  return mmm::HasTensors(m_FileName);
}

auto
VolumeFileReader::ReadTensors() -> TensorImageType::Pointer
{
  std::vector<std::string> notes;
  const auto               image = mmm::ReadTensors(m_FileName, m_TensorsInVoxelAxes, notes);
  std::for_each(notes.begin(), notes.end(), [&](const std::string & note) { this->Note(note); });
  return image;
}

void
VolumeFileReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << '\n';
  os << indent << "TensorsInVoxelAxes: " << (m_TensorsInVoxelAxes ? "On" : "Off") << '\n';
}
} // end namespace itk
