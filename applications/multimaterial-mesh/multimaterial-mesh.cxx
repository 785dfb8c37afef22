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
#include "options/CommandLine.h"
#include "console/Errors.h"
#include "options/HelpText.h"
#include "console/Interruption.h"
#include "run/Run.h"
#include "options/SlicerDescription.h"
#include "options/Version.h"
#include "console/Warnings.h"

#include "itksys/Encoding.hxx"
#include "itkVersion.h"

#include <cstdlib>
#include <iostream>

namespace
{
constexpr int UsageFailure = 2;

void
PrintError(const std::string & text)
{
  std::cerr << "multimaterial-mesh: error: " << text << std::endl;
}

int
Mesh(const cli::Settings & settings)
{
  try
  {
    cli::CatchITKWarnings();
    cli::CatchInterruptions();
    cli::Run(settings);
    return EXIT_SUCCESS;
  }
  catch (const cli::UsageError & error)
  {
    PrintError(error.what());
    return UsageFailure;
  }
  catch (...)
  {
    const int signal = cli::GetInterruption();
    if (signal != 0)
    {
      std::cerr << "multimaterial-mesh: aborted" << std::endl;
      // What shells report for programs that a signal ends.
      return 128 + signal;
    }
    PrintError(cli::DescribeCurrentException());
    return EXIT_FAILURE;
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  const auto    arguments = itksys::Encoding::CommandLineArguments::Main(argc, argv);
  cli::Settings settings;
  try
  {
    switch (cli::ParseCommandLine(arguments.argc(), arguments.argv(), settings))
    {
      case cli::Request::Help:
        cli::PrintHelp(std::cout);
        return EXIT_SUCCESS;
      case cli::Request::Version:
        std::cout << "multimaterial-mesh " << cli::GetVersion() << " (ITK " << itk::Version::GetITKVersion() << ")\n";
        return EXIT_SUCCESS;
      case cli::Request::SlicerDescription:
        cli::PrintSlicerDescription(std::cout);
        return EXIT_SUCCESS;
      case cli::Request::SlicerLogo:
        // There is none. Slicer takes no answer for none.
        return EXIT_SUCCESS;
      default:
        return Mesh(settings);
    }
  }
  catch (const std::exception & error)
  {
    PrintError(error.what());
    return UsageFailure;
  }
}
