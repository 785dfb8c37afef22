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
#include "optimize/MeshOptimizer.h"

#include "optimize/ComplexDefects.h"
#include "optimize/ConnectivityImprover.h"
#include "optimize/PointSmoother.h"
#include "optimize/ShapeQuality.h"

namespace mmm
{
OptimizationReport
OptimizeMesh(const InterfaceConstraint &    constraint,
             Material                       exterior,
             const OptimizationParameters & parameters,
             std::vector<Vector> &          points,
             TetrahedralComplex &           complex,
             Monitor &                      monitor)
{
  OptimizationReport   report;
  const double         flipQuality = QualityOfAngle(parameters.flipAngle);
  const double         poorQuality = QualityOfAngle(parameters.poorAngle);
  OptimizerState       state{ constraint, exterior, parameters, points, complex, report };
  const SoundnessCheck check(complex, points);
  report.moves += PointSmoother(constraint, exterior, parameters, points, complex).SmoothAll();
  check.AssertSound();
  monitor.Report(0.1);
  for (int round = 0; round < parameters.rounds; ++round)
  {
    std::size_t changes = ImproveTriangles(state, parameters.poorTriangle);
    check.AssertSound();
    changes += ImproveTetrahedra(state, flipQuality, poorQuality);
    complex.Compact();
    check.AssertSound();
    PointSmoother smoother(constraint, exterior, parameters, points, complex);
    report.moves += smoother.SmoothWorst(poorQuality, parameters.interfaceTolerance);
    report.moves += smoother.SmoothAll();
    report.moves += smoother.SmoothTriangles(parameters.lowTriangle);
    report.moves += smoother.ReturnToCells();
    check.AssertSound();
    report.rounds = round + 1;
    monitor.Report(0.1 + 0.9 * (round + 1) / parameters.rounds);
    if (changes == 0)
    {
      break;
    }
  }
  return report;
}
} // namespace mmm
