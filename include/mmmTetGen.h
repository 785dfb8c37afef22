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
#ifndef mmmTetGen_h
#define mmmTetGen_h

#include "MultiMaterialMeshingExport.h"
#include "mmmTetrahedralMesh.h"

namespace mmm
{
/** The Delaunay tetrahedralization of a set of points, positively oriented. Throws itk::ExceptionObject with TetGen's
 * own words where it fails. */
MultiMaterialMeshing_EXPORT std::vector<Tetrahedron>
                            DelaunayTetrahedralization(const std::vector<Vector> & points);

/** A place in a region that the facets enclose, and the region's material. */
struct RegionSeed
{
  Vector   position;
  Material material;
};

/** \brief The constrained Delaunay tetrahedralization of closed facets, without Steiner points on them.
 *
 * `points` holds the facets' points and those of the interior. Each region takes the material of its seed; regions of
 * `exterior`, and what lies outside of all facets, stay empty. Points keep their numbers; those that TetGen had to add
 * to the interior in order to recover the facets are appended. Throws itk::ExceptionObject with TetGen's own words where
 * it fails. */
MultiMaterialMeshing_EXPORT TetrahedralMesh
                            TetrahedralizeRegions(std::vector<Vector> &           points,
                                                  const std::vector<Triangle> &   facets,
                                                  const std::vector<RegionSeed> & seeds,
                                                  Material                        exterior);
} // namespace mmm

#endif
