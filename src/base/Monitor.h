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
#ifndef mmmMonitor_h
#define mmmMonitor_h

#include <string>

namespace mmm
{
/** \brief How the geometry core reports progress and learns that it is to stop.
 *
 * Both functions are called from the thread that started the work. Either may throw (the filters throw
 * itk::ProcessAborted), which ends the work. */
class Monitor
{
public:
  virtual ~Monitor() = default;

  /** A stage begins, for instance "relaxation of 2-cells". */
  virtual void
  BeginStage(const std::string & name)
  {
    (void)name;
  }
  /** The fraction of the running stage that is done, in [0, 1]. */
  virtual void
  Report(double fraction)
  {
    (void)fraction;
  }
};
} // namespace mmm

#endif
