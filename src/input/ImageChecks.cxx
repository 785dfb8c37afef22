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
#include "input/ImageChecks.h"

#include "input/GzipFile.h"
#include "input/MetaImageData.h"

#include "itkMacro.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace mmm
{
void
ThrowDamaged(const std::string & fileName, const std::string & reason)
{
  itkGenericExceptionMacro(<< fileName << ": the image cannot be read, it may be damaged: " << reason);
}

void
CheckFile(const std::string & fileName)
{
  const std::filesystem::path path = std::filesystem::u8path(fileName);
  std::error_code             error;
  const auto                  status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    itkGenericExceptionMacro(<< fileName << ": there is no such file");
  }
  if (std::filesystem::is_directory(status))
  {
    itkGenericExceptionMacro(<< fileName << ": this is a folder; an image file is needed");
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
  {
    const int reason = errno;
    if (reason == EMFILE || reason == ENFILE)
    {
      itkGenericExceptionMacro(<< fileName << ": the file cannot be opened: " << std::generic_category().message(reason)
                               << "; raise the limit (ulimit -n)");
    }
    itkGenericExceptionMacro(<< fileName << ": the file cannot be opened; check its permissions");
  }
  if (HasExtension(fileName, { ".mha", ".mhd" }))
  {
    CheckMetaImageHeader(fileName);
  }
}

itk::Size<3>
CheckDimensions(const std::string & fileName, const std::vector<std::int64_t> & size)
{
  std::string text;
  for (const std::int64_t extent : size)
  {
    text += (text.empty() ? "" : "x") + std::to_string(extent);
  }
  if (std::any_of(size.begin(), size.end(), [](std::int64_t extent) { return extent < 1; }))
  {
    ThrowDamaged(fileName, "its header says that its size is " + text);
  }
  if (size.size() < 3 || size[2] == 1)
  {
    itkGenericExceptionMacro(<< fileName << ": the image is a single slice (" << text
                             << "); a three-dimensional image is needed");
  }
  if (std::any_of(size.begin() + 3, size.end(), [](std::int64_t extent) { return extent > 1; }))
  {
    itkGenericExceptionMacro(<< fileName << ": the image has more than three dimensions (" << text
                             << "); extract one three-dimensional label image from it first");
  }
  itk::Size<3> spatial;
  std::copy_n(size.begin(), 3, spatial.begin());
  return spatial;
}
} // namespace mmm
