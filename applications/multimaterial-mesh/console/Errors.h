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
#ifndef Errors_h
#define Errors_h

#include <stdexcept>
#include <string>

namespace cli
{
/** The command line itself is wrong. */
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The image, a file or the computation is at fault: what is wrong, where, and what to do. */
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The text in one line, without what ITK puts before it ("itk::ERROR: Class(0x1234): "). */
std::string
ToOneLine(const std::string & text);

/** One line for the exception being handled. */
std::string
DescribeCurrentException();
} // namespace cli

#endif
