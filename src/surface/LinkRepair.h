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
#ifndef mmmLinkRepair_h
#define mmmLinkRepair_h

#include "indicators/IndicatorSet.h"
#include "particles/Particles.h"
#include "surface/LinkDefects.h"

namespace mmm
{
struct LinkRepairReport
{
  LinkDefects found;
  LinkDefects left;
  /** Tetrahedra that changed. */
  std::size_t relabelled{ 0 };
};

/** Gives tetrahedra at defects to another material around them, as long as that leaves fewer defects: of several ways
 * one with as few corners as possible that lie
 * on no cell of the material, and of these the one that disagrees least with the indicators. No material is lost. */
LinkRepairReport
RepairLinks(const IndicatorSet &         indicators,
            const ParticleSet &          particles,
            const TetrahedronAdjacency & adjacency,
            Material                     outside,
            TetrahedralMesh &            mesh);
} // namespace mmm

#endif
