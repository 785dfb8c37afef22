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
#include "itkTetrahedronStages.h"

#include "base/Points.h"
#include "itk/FilterMonitor.h"
#include "optimize/MeshImprovement.h"
#include "quality/MeshQuality.h"

#include <algorithm>
#include <stdexcept>

namespace mmm
{
namespace
{
/** Ascending, each once. */
std::vector<int>
LabelsOf(const itk::TetrahedronArrays & arrays)
{
  std::vector<int> labels = arrays.labels;
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}
} // namespace

void
ImproveTetrahedra(itk::ProcessObject *                                        filter,
                  const ImprovementOptions &                                  options,
                  const std::function<itk::TetrahedronArrays()> &             read,
                  const std::function<void(const itk::TetrahedronArrays &)> & write,
                  ImprovementResults &                                        results)
{
  const std::vector<PlannedStage> plan{
    { "reading", 0.02 }, { "interfaces", 0.05 }, { "optimization", 0.91 }, { "output", 0.02 }
  };
  RunStages(filter, results.log, plan, [&](FilterMonitor & monitor) {
    monitor.BeginStage("reading");
    itk::TetrahedronArrays arrays = read();
    if (arrays.tetrahedra.empty())
    {
      itkGenericExceptionMacro("The mesh has no tetrahedra.");
    }
    const std::vector<int> labels = LabelsOf(arrays);
    if (labels.size() > MostMaterialsToImprove)
    {
      itkGenericExceptionMacro("The mesh has " << labels.size() << " labels; there can be " << MostMaterialsToImprove
                                               << " at most.");
    }
    std::vector<Vector> points = ToVectors(arrays.points);
    TetrahedralMesh     mesh;
    mesh.tetrahedra.swap(arrays.tetrahedra);
    mesh.materials.reserve(arrays.labels.size());
    for (const int label : arrays.labels)
    {
      mesh.materials.push_back(
        static_cast<Material>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin()));
    }
    ImprovementParameters parameters;
    parameters.tolerance = options.tolerance;
    parameters.featureAngle = options.featureAngle;
    parameters.rounds = options.maximumNumberOfRounds;
    results.report = ImproveMesh(static_cast<Material>(labels.size()), parameters, points, mesh, monitor);
    results.largestTolerance = parameters.tolerance;

    monitor.BeginStage("output");
    arrays.points = ToPoints(points);
    arrays.tetrahedra.swap(mesh.tetrahedra);
    arrays.labels.clear();
    for (const Material material : mesh.materials)
    {
      arrays.labels.push_back(labels[material]);
    }
    write(arrays);
    monitor.Report(1.0);
  });
}

MeshQualityReport
ComputeMeshQuality(const itk::TetrahedronArrays & mesh, const MeshQualityOptions & options)
{
  try
  {
    return ComputeMeshQuality(ToVectors(mesh.points), mesh.tetrahedra, mesh.labels, options);
  }
  catch (const std::logic_error & error)
  {
    itkGenericExceptionMacro(<< error.what());
  }
}
} // namespace mmm
