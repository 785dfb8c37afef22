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
#ifndef CGALMesh3Options_h
#define CGALMesh3Options_h

#include <string>

/** What cgal-mesh3 is asked to do. Lengths are in mm, angles in degrees. */
struct CGALMesh3Options
{
  std::string labelsFile;
  std::string meshFile;
  double      facetSize{ 2.5 };
  double      cellSize{ 4.0 };
  double      facetDistance{ 0.4 };
  double      facetAngle{ 30.0 };
  double      cellRadiusEdge{ 3.0 };
  double      perturbSeconds{ 0.0 };
  double      exudeSeconds{ 0.0 };
  bool        weights{ true };
  bool        seedComponents{ false };
};

std::string
CGALMesh3Usage();

/** Throws std::invalid_argument. */
CGALMesh3Options
ParseCGALMesh3Options(int argc, const char * const argv[]);

#endif
