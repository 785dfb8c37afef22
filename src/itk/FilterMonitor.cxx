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
#include "itk/FilterMonitor.h"

#include "base/OutOfMemory.h"
#include "base/PeakMemory.h"

#include <algorithm>
#include <new>

namespace mmm
{
FilterMonitor::FilterMonitor(itk::ProcessObject * filter, StageLog & log, std::vector<PlannedStage> plan)
  : m_Filter(filter)
  , m_Threads(filter)
  , m_Log(log)
  , m_Plan(std::move(plan))
{
  m_Log = StageLog();
}

FilterMonitor::~FilterMonitor() { this->EndStage(); }

void
FilterMonitor::BeginStage(const std::string & name)
{
  this->EndStage();
  double start = 0.0;
  for (const auto & stage : m_Plan)
  {
    if (stage.name == name)
    {
      m_Start = start;
      m_Share = stage.share;
      break;
    }
    start += stage.share;
  }
  m_Log.current = name;
  m_IsRunning = true;
  m_StageBegin = Clock::now();
  this->Report(0.0);
}

void
FilterMonitor::Update(double fraction)
{
  m_Log.progress = static_cast<float>(std::min(std::max(fraction, 0.0), 1.0));
  m_Filter->UpdateProgress(static_cast<float>(std::min(m_Start + m_Share * m_Log.progress, 1.0)));
}

void
FilterMonitor::Report(double fraction)
{
  this->Update(fraction);
  if (m_Filter->GetAbortGenerateData())
  {
    itk::ProcessAborted aborted(__FILE__, __LINE__);
    aborted.SetDescription(std::string(m_Filter->GetNameOfClass()) + " was told to abort, in stage \"" + m_Log.current +
                           "\".");
    throw aborted;
  }
}

void
FilterMonitor::Observe(itk::ProcessObject * stage)
{
  stage->SetNumberOfWorkUnits(m_Filter->GetNumberOfWorkUnits());
  stage->AddObserver(itk::ProgressEvent(), [this, stage](const itk::EventObject &) {
    this->Update(stage->GetProgress());
    if (m_Filter->GetAbortGenerateData())
    {
      stage->AbortGenerateDataOn();
    }
  });
}

void
FilterMonitor::EndStage()
{
  if (m_IsRunning)
  {
    const std::chrono::duration<double> elapsed = Clock::now() - m_StageBegin;
    m_Log.records.push_back({ m_Log.current, elapsed.count(), PeakMemory() });
    m_Start += m_Share;
    m_Share = 0.0;
    m_IsRunning = false;
  }
}

void
RunStages(itk::ProcessObject *                         filter,
          StageLog &                                   log,
          const std::vector<PlannedStage> &            plan,
          const std::function<void(FilterMonitor &)> & body)
{
  try
  {
    FilterMonitor monitor(filter, log, plan);
    body(monitor);
  }
  catch (const std::bad_alloc &)
  {
    ThrowOutOfMemory(std::string(filter->GetNameOfClass()) + ", in stage \"" + log.current + "\",");
  }
}

void
RunStage(itk::ProcessObject * filter, const std::string & name, const std::function<void(FilterMonitor &)> & body)
{
  StageLog log;
  RunStages(filter, log, { { name, 1.0 } }, [&](FilterMonitor & monitor) {
    monitor.BeginStage(name);
    body(monitor);
  });
}
} // namespace mmm
