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
#ifndef mmmMeshCut_h
#define mmmMeshCut_h

#include "itkMultiMaterialMeshTypes.h"
#include "base/Grid.h"
#include "report/PlanarCells.h"

#include "itkImageRegion.h"

#include <functional>
#include <set>
#include <vector>

namespace mmm
{
/** A plane across an axis of coordinates, and the axes along it in whose coordinates a cut is. */
struct CutPlane
{
  int                normal{ 2 };
  std::array<int, 2> along{ { 0, 1 } };
  double             position{ 0.0 };
};

/** A triangle or quadrilateral for each tetrahedron that has points on both sides of the plane. Points in the plane
 * count as above it, so that the cells cover what the plane cuts of the mesh once.
 *
 * \param points the mesh's points in the coordinates that the plane refers to, by identifier */
PlanarCells
CutTetrahedra(const itk::LabelTetrahedralMesh & mesh, const std::vector<Vector> & points, const CutPlane & plane);

/** A segment for each triangle that has points on both sides of the plane. */
PlanarEdges
CutTriangles(const itk::LabelInterfaceMesh & mesh, const std::vector<Vector> & points, const CutPlane & plane);

/** The voxels of these labels in the layer around the plane, as squares: in continuous indices, in which a voxel's
 * center is a whole number. Empty where the plane is outside of the region. */
PlanarCells
CutVoxels(const std::function<int(const itk::Index<3> &)> & labelAt,
          const itk::ImageRegion<3> &                       region,
          const std::set<int> &                             labels,
          const CutPlane &                                  plane);
} // namespace mmm

#endif
