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
#ifndef mmmMeshOutput_h
#define mmmMeshOutput_h

#include "itk/GridGeometry.h"
#include "itk/InterfaceLabels.h"
#include "itkIndicatorImageStages.h"
#include "pipeline/Mesher.h"

namespace mmm
{
/** Fills all outputs but the tetrahedra. Where the surface was not reached, the particles are all that there is. */
void
SetSurfaceAndParticles(const MeshingResult &   result,
                       const GridGeometry &    geometry,
                       const InterfaceLabels & labels,
                       const MeshingOutputs &  outputs);

/** The tetrahedra in physical space; takes them out of the result. `labels` are those of the materials. */
itk::TetrahedronArrays
TakeTetrahedra(MeshingResult & result, const GridGeometry & geometry, const std::vector<int> & labels);
} // namespace mmm

#endif
