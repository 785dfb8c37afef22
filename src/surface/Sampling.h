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
#ifndef mmmSampling_h
#define mmmSampling_h

#include "MultiMaterialMeshingReports.h"
#include "mesh/InterfaceMesh.h"
#include "particles/Particles.h"

#include <vector>

namespace mmm
{
/** \brief How well the points of a surface follow h. */
SamplingReport
MeasureSampling(const SizingField & sizing, const InterfaceMesh & interfaces, const std::vector<Vector> & points);

/** \brief How near particles are to their cells. */
ResidualReports
MeasureResiduals(const IndicatorSet & indicators, const ParticleSet & particles);
} // namespace mmm

#endif
