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
#ifndef StreamCapture_h
#define StreamCapture_h

#include <cstdio>
#include <string>

namespace cli
{
/** \brief Keeps what libraries print on stdout and stderr while it lives from the user.
 *
 * Image libraries print what is wrong with a file, in several lines, instead of telling their caller. */
class StreamCapture
{
public:
  StreamCapture();
  ~StreamCapture();
  StreamCapture(const StreamCapture &) = delete;
  StreamCapture &
  operator=(const StreamCapture &) = delete;

  /** Ends the capture and returns what was printed. */
  std::string
  Finish();

private:
  /** Nothing is captured where the system grants no temporary file. */
  std::FILE * m_File{ nullptr };
  int         m_Saved[2]{ -1, -1 };
};
} // namespace cli

#endif
