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
#ifndef itkTetrahedronStages_h
#define itkTetrahedronStages_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingOptions.h"
#include "MultiMaterialMeshingQuality.h"
#include "MultiMaterialMeshingReports.h"
#include "itkTetrahedronArrays.h"

#include "itkProcessObject.h"

#include <functional>

/** The compiled part of what works on tetrahedra of any origin. */
namespace mmm
{
struct ImprovementResults
{
  StageLog           log;
  OptimizationReport report;
  /** The largest tolerance that was used, in the mesh's unit. */
  double largestTolerance{ 0.0 };
};

/** What OptimizeTetrahedralMeshFilter does between reading and writing. */
MultiMaterialMeshing_EXPORT void
ImproveTetrahedra(itk::ProcessObject *                                        filter,
                  const ImprovementOptions &                                  options,
                  const std::function<itk::TetrahedronArrays()> &             read,
                  const std::function<void(const itk::TetrahedronArrays &)> & write,
                  ImprovementResults &                                        results);

/** What TetrahedralMeshQualityCalculator computes. */
MultiMaterialMeshing_EXPORT MeshQualityReport
ComputeMeshQuality(const itk::TetrahedronArrays & mesh, const MeshQualityOptions & options);
} // namespace mmm

#endif
