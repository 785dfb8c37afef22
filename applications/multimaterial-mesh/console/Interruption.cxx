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
#include "console/Interruption.h"

#include "itkMacro.h"

#include <csignal>

namespace cli
{
namespace
{
volatile std::sig_atomic_t theSignal = 0;

extern "C" void
NoteSignal(int signal)
{
  theSignal = signal;
  std::signal(signal, SIG_DFL);
}

void
Catch(int signal)
{
  // Whoever started the program may have wanted it to go on, for instance in the background.
  if (std::signal(signal, NoteSignal) == SIG_IGN)
  {
    std::signal(signal, SIG_IGN);
  }
}
} // namespace

void
CatchInterruptions()
{
  Catch(SIGINT);
  Catch(SIGTERM);
#ifdef SIGXFSZ
  // Writing beyond a file size limit shall fail like a full disk instead of killing the program.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
}

int
GetInterruption()
{
  return theSignal;
}

void
ThrowIfInterrupted()
{
  if (theSignal != 0)
  {
    throw itk::ProcessAborted(__FILE__, __LINE__);
  }
}
} // namespace cli
