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
#include "optimize/MeshImprovement.h"

#include "optimize/TriangulationConstraint.h"

#include <algorithm>

namespace mmm
{
namespace
{
void
TurnToPositive(const std::vector<Vector> & points, TetrahedralMesh & mesh)
{
  for (auto & t : mesh.tetrahedra)
  {
    if (TetrahedronVolume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) < 0.0)
    {
      std::swap(t[2], t[3]);
    }
  }
}

void
DropUnusedPoints(std::vector<Vector> & points, TetrahedralMesh & mesh)
{
  std::vector<PointId> number(points.size(), 0);
  for (const auto & t : mesh.tetrahedra)
  {
    for (const auto corner : t)
    {
      number[corner] = 1;
    }
  }
  PointId kept = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (number[p])
    {
      points[kept] = points[p];
      number[p] = kept++;
    }
  }
  points.resize(kept);
  for (auto & t : mesh.tetrahedra)
  {
    for (auto & corner : t)
    {
      corner = number[corner];
    }
  }
}
} // namespace

OptimizationReport
ImproveMesh(Material                outside,
            ImprovementParameters & parameters,
            std::vector<Vector> &   points,
            TetrahedralMesh &       mesh,
            Monitor &               monitor)
{
  monitor.BeginStage("interfaces");
  TurnToPositive(points, mesh);
  const TriangulationConstraint constraint(points, mesh, outside, parameters.tolerance, parameters.featureAngle);
  parameters.tolerance = constraint.LargestTolerance();
  monitor.Report(1.0);

  monitor.BeginStage("optimization");
  OptimizationParameters optimization;
  optimization.rounds = parameters.rounds;
  optimization.interfaceTolerance = 1.0;
  // who brings tetrahedra that are good already does not want them worse for the sake of triangles
  optimization.angleToKeepBesideTriangles = optimization.angleToKeep;
  TetrahedralComplex complex(mesh, points.size());
  const auto         report = OptimizeMesh(constraint, outside, optimization, points, complex, monitor);
  mesh = complex.GetMesh();
  DropMaterial(outside, mesh);
  DropUnusedPoints(points, mesh);
  monitor.Report(1.0);
  return report;
}
} // namespace mmm
