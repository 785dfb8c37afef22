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
#include "CommandLineTest.h"

#include "itkImageRegionIteratorWithIndex.h"
#include "itksys/Process.h"

#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <sstream>

namespace fs = std::filesystem;

std::vector<std::string>
RunResult::ErrorLines() const
{
  std::vector<std::string> lines;
  std::istringstream       stream(error);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

CommandLine::CommandLine()
{
  std::random_device random;
  m_Folder = fs::temp_directory_path() / ("multimaterial-mesh-" + std::to_string(random()) + std::to_string(random()));
  fs::create_directory(m_Folder);
}

CommandLine::~CommandLine()
{
  std::error_code ignored;
  fs::remove_all(m_Folder, ignored);
}

std::string
CommandLine::Path(const std::string & name) const
{
  return (m_Folder / name).string();
}

std::set<std::string>
CommandLine::Files() const
{
  std::set<std::string> names;
  for (const auto & entry : fs::recursive_directory_iterator(m_Folder))
  {
    names.insert(fs::relative(entry.path(), m_Folder).generic_string());
  }
  return names;
}

std::string
CommandLine::Contents(const std::string & name) const
{
  std::ifstream stream(m_Folder / name, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

RunResult
CommandLine::Run(const std::vector<std::string> & arguments)
{
  std::vector<std::string> command{ MULTIMATERIAL_MESH };
  command.insert(command.end(), arguments.begin(), arguments.end());
  return Start(command);
}

RunResult
CommandLine::Start(const std::vector<std::string> & command, const std::string & interruptAfter)
{
  std::vector<const char *> words;
  for (const auto & word : command)
  {
    words.push_back(word.c_str());
  }
  words.push_back(nullptr);

  const std::unique_ptr<itksysProcess, void (*)(itksysProcess *)> owner(itksysProcess_New(), itksysProcess_Delete);
  itksysProcess * const                                           process = owner.get();
  itksysProcess_SetCommand(process, words.data());
  // Interrupts are sent to a group, which shall not be that of the test.
  itksysProcess_SetOption(process, itksysProcess_Option_CreateProcessGroup, 1);
  itksysProcess_Execute(process);

  RunResult result;
  bool      isInterrupted = interruptAfter.empty();
  char *    data = nullptr;
  int       length = 0;
  while (const int pipe = itksysProcess_WaitForData(process, &data, &length, nullptr))
  {
    (pipe == itksysProcess_Pipe_STDERR ? result.error : result.output).append(data, length);
    if (!isInterrupted && result.output.find(interruptAfter) != std::string::npos)
    {
      isInterrupted = true;
      itksysProcess_Interrupt(process);
    }
  }
  itksysProcess_WaitForExit(process, nullptr);
  if (itksysProcess_GetState(process) == itksysProcess_State_Exited)
  {
    result.exitCode = itksysProcess_GetExitValue(process);
  }
  return result;
}

void
CommandLine::ExpectError(const std::vector<std::string> & arguments, int exitCode, const std::string & message) const
{
  const auto before = this->Files();
  const auto result = Run(arguments);
  EXPECT_EQ(result.exitCode, exitCode);
  const auto lines = result.ErrorLines();
  ASSERT_EQ(lines.size(), 1u) << result.error;
  EXPECT_EQ(lines[0].rfind("multimaterial-mesh: error: ", 0), 0u) << lines[0];
  EXPECT_NE(lines[0].find(message), std::string::npos) << lines[0];
  EXPECT_EQ(this->Files(), before);
}

CommandLine::LabelImage::Pointer
CommandLine::MakeBalls()
{
  auto image = MakeImage<short>(itk::Size<3>{ { 16, 16, 16 } });
  for (itk::ImageRegionIteratorWithIndex<LabelImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    double square = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      square += (it.GetIndex()[d] - 7.5) * (it.GetIndex()[d] - 7.5);
    }
    it.Set(square < 3.0 * 3.0 ? 5 : square < 6.0 * 6.0 ? 2 : 0);
  }
  return image;
}

std::string
CommandLine::WriteBalls() const
{
  return this->WriteImage<LabelImage>(MakeBalls(), "labels.nrrd");
}
