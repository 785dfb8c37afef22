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
#include "quality/MeshQuality.h"

#include <iomanip>
#include <ostream>
#include <string>

namespace mmm
{
namespace
{
void
PrintRow(std::ostream & os, const std::string & name, const TetrahedronStatistics & statistics)
{
  os << std::setw(8) << name << std::setw(10) << statistics.count << std::setw(12) << statistics.volume;
  for (const auto * distribution : { &statistics.radiusRatio, &statistics.smallestAngle })
  {
    os << std::setw(11) << distribution->average << std::setw(11) << distribution->firstPercentile << std::setw(11)
       << distribution->minimum;
  }
  os << std::setw(9) << statistics.largestAngle;
  for (const auto & counts : { statistics.below, statistics.above })
  {
    for (const auto count : counts)
    {
      os << std::setw(8) << count;
    }
  }
}
} // namespace

const char *
ToString(PoorTetrahedron::Place place)
{
  switch (place)
  {
    case PoorTetrahedron::Place::Interior:
      return "interior";
    case PoorTetrahedron::Place::BesideInterface:
      return "beside an interface";
    case PoorTetrahedron::Place::AcrossLayer:
      return "across a thin layer";
    default:
      return "on an interface";
  }
}

std::ostream &
operator<<(std::ostream & os, const MeshQualityReport & report)
{
  const auto flags = os.flags();
  const auto precision = os.precision(4);
  os << std::dec << std::defaultfloat << std::right;
  os << "points: " << report.points << ", unused: " << report.unusedPoints << ", duplicates: " << report.duplicatePoints
     << '\n';
  os << "tetrahedra: " << report.tetrahedra.count << ", not positive: " << report.tetrahedra.nonPositive
     << ", faces with more than two: " << report.overusedFaces << '\n';
  os << "interface triangles: " << report.interfaceTriangles
     << ", radius ratio average: " << report.interfaceRadiusRatio.average
     << ", 1 %: " << report.interfaceRadiusRatio.firstPercentile << ", minimum: " << report.interfaceRadiusRatio.minimum
     << '\n';
  os << "edges of the labels' boundaries, open: " << report.openEdges << ", non-manifold: " << report.nonManifoldEdges
     << '\n';
  os << "   label     count      volume     RR avg     RR 1 %     RR min  angle avg  angle 1 %  angle min"
     << "  max       <5     <10     <15    >165    >170    >175   parts    open  non-mf"
     << (report.hasBettiNumbers ? "  b0 b1 b2\n" : "\n");
  PrintRow(os, "all", report.tetrahedra);
  os << '\n';
  for (const auto & label : report.labels)
  {
    PrintRow(os, std::to_string(label.label), label.tetrahedra);
    os << std::setw(8) << label.components << std::setw(8) << label.openEdges << std::setw(8) << label.nonManifoldEdges;
    if (report.hasBettiNumbers)
    {
      os << "  " << label.betti[0] << ' ' << label.betti[1] << ' ' << label.betti[2];
    }
    os << '\n';
  }
  os.flags(flags);
  os.precision(precision);
  return os;
}
} // namespace mmm
