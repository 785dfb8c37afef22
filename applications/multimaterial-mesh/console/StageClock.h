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
#ifndef StageClock_h
#define StageClock_h

#include "console/Interruption.h"
#include "console/ProgressDisplay.h"
#include "base/PeakMemory.h"
#include "MultiMaterialMeshingReports.h"

#include <chrono>
#include <string>
#include <vector>

namespace cli
{
/** \brief Runs the stages that are the program's own, shows and records them. */
class StageClock
{
public:
  explicit StageClock(ProgressDisplay & display)
    : m_Display(display)
  {}

  /** The total is how much of all work is done before the stage, from 0 to 1. */
  template <typename TBody>
  void
  Run(const std::string & name, double total, const TBody & body)
  {
    ThrowIfInterrupted();
    m_Display.Show(name, 0.0, total);
    const auto start = std::chrono::steady_clock::now();
    body();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    m_Display.Finish();
    m_Records.push_back({ name, seconds.count(), mmm::PeakMemory() });
  }

  /** Appends stages that something else has run. */
  void
  Append(const std::vector<mmm::StageRecord> & records)
  {
    m_Records.insert(m_Records.end(), records.begin(), records.end());
  }

  /** Since it was made. */
  double
  GetSeconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_Start).count();
  }

  const std::vector<mmm::StageRecord> &
  GetRecords() const
  {
    return m_Records;
  }

private:
  ProgressDisplay &                     m_Display;
  std::chrono::steady_clock::time_point m_Start{ std::chrono::steady_clock::now() };
  std::vector<mmm::StageRecord>         m_Records;
};
} // namespace cli

#endif
