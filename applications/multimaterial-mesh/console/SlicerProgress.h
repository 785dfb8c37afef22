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
#ifndef SlicerProgress_h
#define SlicerProgress_h

#include <string>

namespace cli
{
/** \brief Prints progress as 3D Slicer reads it from the standard output of the programs that it runs.
 *
 * Each element is a line, written at once. Slicer looks for the last one of a kind. */
class SlicerProgress
{
public:
  void
  Begin(const std::string & stage);

  /** Both from 0 to 1: of all work, and of the stage. What Slicer shows never goes back. */
  void
  Update(double total, double ofStage);

  void
  End(const std::string & stage, double seconds);

private:
  double m_Total{ 0.0 };
};
} // namespace cli

#endif
