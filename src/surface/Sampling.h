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

#include "MultiMaterialMeshingExport.h"
#include "mesh/InterfaceMesh.h"
#include "particles/Particles.h"

#include <array>
#include <vector>

namespace mmm
{
/** Distances of particles to their cells, in units of the smallest voxel spacing; all are 0 without particles. */
struct ResidualReport
{
  /** A particle that is further away than this has left its cell. */
  static constexpr double Largest = 0.01;

  double maximum{ 0.0 };
  double percentile99{ 0.0 };
  /** The share of the particles that have left their cell, or whose cell is not found within a voxel. */
  double leftShare{ 0.0 };
};

struct SamplingReport
{
  /** The smallest and the largest spacing that count as near to what was asked for. */
  static constexpr double LeastNear = 0.6;
  static constexpr double MostNear = 1.6;

  /** Lengths of the surface's edges in units of h at their middle, 0 without edges. */
  double medianSpacing{ 0.0 };
  double percentile1Spacing{ 0.0 };
  double percentile99Spacing{ 0.0 };
  /** The share of edges whose spacing is near 1. */
  double nearShare{ 0.0 };
};

/** \brief How well the points of a surface follow h. */
MultiMaterialMeshing_EXPORT SamplingReport
MeasureSampling(const SizingField & sizing, const InterfaceMesh & interfaces, const std::vector<Vector> & points);

/** Of the particles on 1- and 2-cells; [0] is unused. */
using ResidualReports = std::array<ResidualReport, 3>;

/** \brief How near particles are to their cells. */
MultiMaterialMeshing_EXPORT ResidualReports
MeasureResiduals(const IndicatorSet & indicators, const ParticleSet & particles);
} // namespace mmm

#endif
