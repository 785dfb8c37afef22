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
#ifndef mmmFilterMonitor_h
#define mmmFilterMonitor_h

#include "MultiMaterialMeshingReports.h"
#include "base/Monitor.h"
#include "base/Parallel.h"

#include "itkProcessObject.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace mmm
{
/** A stage and its share of the whole work. */
struct PlannedStage
{
  std::string name;
  double      share;
};

/** \brief Makes the core's progress that of a filter, keeps a log of the stages, and ends the work if the filter is
 * told to abort, by throwing itk::ProcessAborted. Parallel work that goes on meanwhile runs on the filter's threads.
 *
 * A stage that is not in the plan has no share of the progress. The last stage ends with the monitor. */
class FilterMonitor : public Monitor
{
public:
  /** Filter and log must outlive the monitor. The log is emptied. */
  FilterMonitor(itk::ProcessObject * filter, StageLog & log, std::vector<PlannedStage> plan);
  ~FilterMonitor() override;

  FilterMonitor(const FilterMonitor &) = delete;
  FilterMonitor &
  operator=(const FilterMonitor &) = delete;

  void
  BeginStage(const std::string & name) override;
  void
  Report(double fraction) override;

  /** Reports without throwing, for observers of ITK's own filters: these report from destructors, too. */
  void
  Update(double fraction);

  /** Makes a filter of ITK that does a stage's work report it here, and abort with this one. */
  void
  Observe(itk::ProcessObject * stage);

private:
  using Clock = std::chrono::steady_clock;

  void
  EndStage();

  itk::ProcessObject *      m_Filter;
  ThreaderScope             m_Threads;
  StageLog &                m_Log;
  std::vector<PlannedStage> m_Plan;
  double                    m_Start{ 0.0 };
  double                    m_Share{ 0.0 };
  bool                      m_IsRunning{ false };
  Clock::time_point         m_StageBegin;
};

/** Runs the stages of a filter. Where memory runs out, the exception tells in which. */
void
RunStages(itk::ProcessObject *                         filter,
          StageLog &                                   log,
          const std::vector<PlannedStage> &            plan,
          const std::function<void(FilterMonitor &)> & body);

/** The same for a filter that is a single stage, and keeps no log. */
void
RunStage(itk::ProcessObject * filter, const std::string & name, const std::function<void(FilterMonitor &)> & body);
} // namespace mmm

#endif
