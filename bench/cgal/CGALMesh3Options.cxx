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
#include "CGALMesh3Options.h"

#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace
{
double
ParseLength(const std::string & option, const std::string & text)
{
  std::istringstream stream{ text };
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !stream.eof() || !(value > 0.0))
  {
    throw std::invalid_argument(option + " needs a positive number, not " + text);
  }
  return value;
}
} // namespace

std::string
CGALMesh3Usage()
{
  return "usage: cgal-mesh3 LABELS OUT.vtu [options]\n"
         "  --facet-size MM          largest radius of a facet's surface ball (2.5)\n"
         "  --cell-size MM           largest circumradius of a tetrahedron (4)\n"
         "  --facet-distance MM      largest distance of a facet to its interface (0.4)\n"
         "  --facet-angle DEGREES    smallest angle of a facet, at most 30 (30)\n"
         "  --cell-radius-edge RATIO largest circumradius to shortest edge, at least 2 (3)\n"
         "  --perturb SECONDS        perturb slivers, for so long at most (not done)\n"
         "  --exude SECONDS          exude slivers, for so long at most (not done)\n"
         "  --no-weights             mesh the voxel boundaries, not smoothed ones\n"
         "  --seed-components        start from points on every component of every label, so that none is missed\n";
}

CGALMesh3Options
ParseCGALMesh3Options(int argc, const char * const argv[])
{
  CGALMesh3Options                      options;
  const std::map<std::string, double *> values{ { "--facet-size", &options.facetSize },
                                                { "--cell-size", &options.cellSize },
                                                { "--facet-distance", &options.facetDistance },
                                                { "--facet-angle", &options.facetAngle },
                                                { "--cell-radius-edge", &options.cellRadiusEdge },
                                                { "--perturb", &options.perturbSeconds },
                                                { "--exude", &options.exudeSeconds } };
  std::vector<std::string>              files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const auto        value = values.find(argument);
    if (value != values.end())
    {
      if (++i == argc)
      {
        throw std::invalid_argument(argument + " needs a number");
      }
      *value->second = ParseLength(argument, argv[i]);
    }
    else if (argument == "--no-weights")
    {
      options.weights = false;
    }
    else if (argument == "--seed-components")
    {
      options.seedComponents = true;
    }
    else if (argument.rfind("-", 0) == 0)
    {
      throw std::invalid_argument("unknown option: " + argument);
    }
    else
    {
      files.push_back(argument);
    }
  }
  if (files.size() != 2)
  {
    throw std::invalid_argument(CGALMesh3Usage());
  }
  options.labelsFile = files[0];
  options.meshFile = files[1];
  return options;
}
