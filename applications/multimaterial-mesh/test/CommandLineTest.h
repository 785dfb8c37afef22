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
#ifndef CommandLineTest_h
#define CommandLineTest_h

#include "itkImage.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

/** What a run of the program gave. */
struct RunResult
{
  int         exitCode{ -1 };
  std::string output;
  std::string error;

  /** Lines on stderr that report this, for instance "warning". */
  std::vector<std::string>
  ErrorLines() const;
};

/** \brief Runs multimaterial-mesh in a folder of its own, which is removed after the test. */
class CommandLine : public testing::Test
{
public:
  using LabelImage = itk::Image<short, 3>;

  CommandLine();
  ~CommandLine() override;

  /** A name in the test's folder. */
  std::string
  Path(const std::string & name) const;

  /** The names of all files there are. */
  std::set<std::string>
  Files() const;

  /** The bytes of a file. */
  std::string
  Contents(const std::string & name) const;

  static RunResult
  Run(const std::vector<std::string> & arguments);

  /** Runs another program, which may start multimaterial-mesh. It is interrupted, as by Ctrl-C, once it has printed
   * `interruptAfter`. */
  static RunResult
  Start(const std::vector<std::string> & command, const std::string & interruptAfter = "");

  /** The program must fail with one line on stderr, which holds `message`, and leave no file behind. */
  void
  ExpectError(const std::vector<std::string> & arguments, int exitCode, const std::string & message) const;

  /** 16 x 16 x 16 voxels of 1 mm: label 0 outside, a ball of label 2 with a core of label 5. */
  static LabelImage::Pointer
  MakeBalls();

  /** The name of a file with MakeBalls(). */
  std::string
  WriteBalls() const;

  /** Writes an image of any type; returns the file's name. */
  template <typename TImage>
  std::string
  WriteImage(const TImage * image, const std::string & name) const;

  /** An image of zeros. */
  template <typename TPixel, unsigned int VDimension>
  static typename itk::Image<TPixel, VDimension>::Pointer
  MakeImage(const itk::Size<VDimension> & size);

private:
  std::filesystem::path m_Folder;
};

#include "CommandLineTest.hxx"

#endif
