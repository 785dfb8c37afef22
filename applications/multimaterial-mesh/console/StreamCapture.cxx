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
#include "console/StreamCapture.h"

#include "console/Warnings.h"

#include <iostream>

#ifdef _WIN32
#  include <io.h>
#  define dup _dup
#  define dup2 _dup2
#  define close _close
#  define fileno _fileno
#else
#  include <unistd.h>
#endif

namespace cli
{
namespace
{
void
Flush()
{
  std::cout.flush();
  std::cerr.flush();
  std::fflush(stdout);
  std::fflush(stderr);
}
} // namespace

StreamCapture::StreamCapture()
  : m_File(std::tmpfile())
{
  if (m_File == nullptr)
  {
    return;
  }
  HoldWarnings();
  Flush();
  for (int stream = 0; stream < 2; ++stream)
  {
    const int descriptor = fileno(stream == 0 ? stdout : stderr);
    m_Saved[stream] = dup(descriptor);
    dup2(fileno(m_File), descriptor);
  }
}

StreamCapture::~StreamCapture() { this->Finish(); }

std::string
StreamCapture::Finish()
{
  std::string text;
  if (m_File == nullptr)
  {
    return text;
  }
  Flush();
  for (int stream = 0; stream < 2; ++stream)
  {
    dup2(m_Saved[stream], fileno(stream == 0 ? stdout : stderr));
    close(m_Saved[stream]);
  }
  std::rewind(m_File);
  for (int c = std::fgetc(m_File); c != EOF; c = std::fgetc(m_File))
  {
    text += char(c);
  }
  std::fclose(m_File);
  m_File = nullptr;
  ReleaseWarnings();
  return text;
}
} // namespace cli
