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
#include "report/PageSections.h"

#include "report/HTML.h"

#include <cmath>

namespace mmm
{
namespace
{
std::string
MakeNumberTable(const itk::MeshFacts & facts)
{
  const MeshEstimate & expected = facts.meshing->estimate;
  const auto           rounded = [](double count) { return CountHTML(std::size_t(std::llround(count))); };
  HTMLTable            table("What was expected before the work began, and what there is",
                             { { "Numbers of", false }, { "Expected" }, { "Made" } });
  table.AddRow(
    { "triangles between labels", rounded(expected.triangles), CountHTML(facts.surface->GetNumberOfCells()) });
  table.AddRow({ "points", rounded(expected.points), CountHTML(facts.tetrahedra->GetNumberOfPoints()) });
  table.AddRow({ "tetrahedra", rounded(expected.tetrahedra), CountHTML(facts.tetrahedra->GetNumberOfCells()) });
  table.AddRow({ "points of the triangles", "", CountHTML(facts.surface->GetNumberOfPoints()) });
  table.AddRow({ "memory (GB)", NumberHTML(expected.memory, 2), "see below" });
  return table.ToText();
}

std::string
MakeSpacingTable(const SamplingReport & sampling)
{
  HTMLTable table("Lengths of the surface's edges per length asked for at their middle: 1 is as asked",
                  { { "First percentile" }, { "Median" }, { "Last percentile" }, { "Share from 0.6 to 1.6" } });
  table.AddRow({ NumberHTML(sampling.percentile1Spacing, 2),
                 NumberHTML(sampling.medianSpacing, 2),
                 NumberHTML(sampling.percentile99Spacing, 2),
                 NumberHTML(sampling.nearShare, 3) });
  return table.ToText();
}

void
AddResiduals(HTMLTable & table, const std::string & when, const ResidualReports & residuals)
{
  const char * const names[3] = { "", "curves", "surfaces" };
  for (std::size_t dimension = 1; dimension < residuals.size(); ++dimension)
  {
    const ResidualReport & residual = residuals[dimension];
    table.AddRow({ std::string("on ") + names[dimension] + ", " + when,
                   NumberHTML(residual.percentile99, 4),
                   NumberHTML(residual.maximum, 4),
                   NumberHTML(residual.leftShare, 5) });
  }
}

std::string
MakeParticleTable(const MeshingReport & report)
{
  const char * const names[4] = {
    "points where four labels meet", "curves where three labels meet", "surfaces between two labels", "the interior"
  };
  HTMLTable table("Particles, and how they came to rest: the last move is per length asked for",
                  { { "On", false },
                    { "Particles" },
                    { "Sweeps" },
                    { "Last move" },
                    { "At rest", false },
                    { "Added" },
                    { "Removed" } });
  for (std::size_t dimension = 0; dimension < report.particles.size(); ++dimension)
  {
    const RelaxationReport & relaxation = report.relaxation[dimension];
    const bool               isMoved = dimension > 0;
    table.AddRow({ names[dimension],
                   CountHTML(report.particles[dimension]),
                   isMoved ? CountHTML(std::size_t(relaxation.sweeps)) : "",
                   isMoved ? NumberHTML(relaxation.meanMove, 4) : "",
                   !isMoved               ? ""
                   : relaxation.converged ? "yes"
                                          : "no",
                   isMoved ? CountHTML(relaxation.added) : "",
                   isMoved ? CountHTML(relaxation.removed) : "" });
  }
  return table.ToText();
}
} // namespace

std::string
MakeSizeSection(const itk::MeshFacts & facts)
{
  const MeshingReport & report = *facts.meshing;
  HTMLTable             residuals("Distances of particles to where labels meet, in units of the smallest spacing",
                                  { { "Particles", false }, { "99th percentile" }, { "Largest" }, { "Share above 0.01" } });
  AddResiduals(residuals, "before the surface was found", report.residualsOfParticles);
  AddResiduals(residuals, "after optimization", report.residualsAfterOptimization);
  return SectionHTML("sizes",
                     "Sizes",
                     MakeNumberTable(facts) + MakeSpacingTable(report.sampling) + MakeParticleTable(report) +
                       residuals.ToText());
}
} // namespace mmm
