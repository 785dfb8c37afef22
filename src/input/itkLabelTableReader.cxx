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
#include "itkLabelTableReader.h"

#include "input/GzipFile.h"
#include "input/ImageChecks.h"
#include "input/LabelTableSearch.h"
#include "input/LabelTableText.h"
#include "input/SegmentLayers.h"

#include "itkImageIOFactory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace itk
{
namespace
{
/** FreeSurfer's has 0.1 MB. What is larger is an image, or anything else. */
constexpr std::uintmax_t MostBytes = 16 << 20;

bool
IsNrrd(const std::string & fileName)
{
  return mmm::HasExtension(fileName, { ".nrrd" });
}

std::vector<mmm::Segment>
ReadSegments(const std::string & fileName)
{
  const auto io = ImageIOFactory::CreateImageIO(fileName.c_str(), IOFileModeEnum::ReadMode);
  if (io.IsNull())
  {
    return {};
  }
  io->SetFileName(fileName);
  io->ReadImageInformation();
  return mmm::FindSegments(*io);
}

std::string
ReadText(const std::string & fileName)
{
  const auto      path = std::filesystem::u8path(fileName);
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
  {
    itkGenericExceptionMacro(<< fileName << ": this is a folder; a table of labels is needed");
  }
  mmm::CheckFile(fileName);
  if (std::filesystem::file_size(path, error) > MostBytes && !error)
  {
    itkGenericExceptionMacro(<< fileName << ": the file is too large for a table of labels");
  }
  std::ifstream stream(path, std::ios::binary);
  std::string   text{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  if (text.find('\0') != std::string::npos)
  {
    itkGenericExceptionMacro(<< fileName << ": this is not a text; a table of labels is needed");
  }
  return text;
}
} // namespace

void
LabelTableReader::Read()
{
  m_LabelTable.clear();
  if (!IsNrrd(m_FileName))
  {
    m_LabelTable = mmm::ParseLabelTable(m_FileName, ReadText(m_FileName));
    return;
  }
  mmm::CheckFile(m_FileName);
  for (const mmm::Segment & segment : ReadSegments(m_FileName))
  {
    m_LabelTable[segment.label] = { segment.name, segment.color };
  }
  if (m_LabelTable.empty())
  {
    itkGenericExceptionMacro(<< m_FileName << ": the header lists no segments, so it has no names of labels");
  }
}

std::string
LabelTableReader::FindFileFor(const std::string & imageFileName)
{
  if (IsNrrd(imageFileName))
  {
    return ReadSegments(imageFileName).empty() ? "" : imageFileName;
  }
  const auto tables = mmm::FindBIDSTables(imageFileName);
  const auto found = std::find_if(tables.begin(), tables.end(), [](const std::string & name) {
    return !mmm::HasExtension(name, { ".json" }) || mmm::HasLabelMap(name, ReadText(name));
  });
  return found == tables.end() ? "" : *found;
}

void
LabelTableReader::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << m_FileName << '\n';
  os << indent << "LabelTable:\n";
  for (const auto & [label, entry] : m_LabelTable)
  {
    os << indent.GetNextIndent() << label << ": " << entry.name << '\n';
  }
}
} // end namespace itk
