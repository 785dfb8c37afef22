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
#include "console/Warnings.h"

#include "console/Errors.h"
#include "itkMultiMaterialMeshCompatibility.h"

#include "itkOutputWindow.h"

#include <algorithm>
#include <iostream>

namespace cli
{
namespace
{
bool                     areHeld = false;
std::vector<std::string> held;
/** In their order. */
std::vector<std::string> told;

class WarningWindow : public itk::OutputWindow
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(WarningWindow);

  using Self = WarningWindow;
  using Superclass = itk::OutputWindow;
  using Pointer = itk::SmartPointer<Self>;

  itkFactorylessNewMacro(Self);
  itkOverrideGetNameOfClassMacro(WarningWindow);

  void
  DisplayText(const char * text) override
  {
    Warn(ToOneLine(text));
  }

protected:
  WarningWindow() = default;
  ~WarningWindow() override = default;
};
} // namespace

void
Warn(const std::string & text)
{
  if (areHeld)
  {
    held.push_back(text);
  }
  else if (std::find(told.begin(), told.end(), text) == told.end())
  {
    told.push_back(text);
    std::cerr << "multimaterial-mesh: warning: " << text << std::endl;
  }
}

std::vector<std::string>
GetWarnings()
{
  return told;
}

void
HoldWarnings()
{
  areHeld = true;
}

void
ReleaseWarnings()
{
  areHeld = false;
  for (const auto & text : held)
  {
    Warn(text);
  }
  held.clear();
}

void
CatchITKWarnings()
{
  itk::OutputWindow::SetInstance(WarningWindow::New());
}
} // namespace cli
