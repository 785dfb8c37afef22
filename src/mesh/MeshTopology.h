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
#ifndef mmmMeshTopology_h
#define mmmMeshTopology_h

#include "MultiMaterialMeshingQuality.h"
#include "mesh/TetrahedralMesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mmm
{
/** A face on the boundary of a region: behind it is another one, or nothing. A face between two regions is listed once
 * for each of them. */
struct BoundaryFace
{
  /** Ascending. */
  std::array<std::uint32_t, 3> points;
  /** The one inside the region. */
  std::uint32_t tetrahedron;
  /** The one on the other side, or NoTetrahedron. */
  std::uint32_t neighbor;
  /** Whether it is the first time that the face is listed. */
  bool first;
};

/** \brief The topology of one region, the union of the closed tetrahedra of a label. */
struct RegionTopology
{
  /** Parts that tetrahedra with a common face hold together. */
  std::size_t components{ 0 };
  std::size_t boundaryFaces{ 0 };
  /** Edges with an odd number of boundary faces. A mesh whose faces have one or two tetrahedra each has none. */
  std::size_t openEdges{ 0 };
  /** Edges with more than two boundary faces: the region touches itself there. */
  std::size_t nonManifoldEdges{ 0 };
  /** The Betti numbers of the closed set, if asked for: components, tunnels and cavities. As it is closed, a common
   * point is enough to hold two components together, and a cavity is not open to the outside, or to another cavity, by
   * way of an edge or a point. They assume positive volumes and that tetrahedra meet only in common faces, edges and
   * points. */
  BettiNumbers betti{ { 0, 0, 0 } };
};

struct MeshTopology
{
  std::vector<BoundaryFace>   boundaryFaces;
  std::vector<RegionTopology> regions;
  /** Faces with more than two tetrahedra. On the boundary of a region are those that it shares with another one. */
  std::size_t overusedFaces{ 0 };
};

/** \brief Finds the faces, components and, on request, Betti numbers of the regions of a mesh.
 *
 * `regions` gives each tetrahedron's region, below `numberOfRegions`. All of the result is the same for any number of
 * threads. The Betti numbers follow from counts: b0 is the number of components, b2 that of the boundary's sheets, less
 * one for each part that common edges hold together, and b1 = b0 + b2 - chi. A sheet runs on across an edge to the face
 * on the other side of the same wedge of complement.
 *
 * \throw std::length_error for more than 2^32 - 2 tetrahedra. */
MeshTopology
ComputeMeshTopology(const std::vector<Vector> &        points,
                    const std::vector<Tetrahedron> &   tetrahedra,
                    const std::vector<std::uint32_t> & regions,
                    std::size_t                        numberOfRegions,
                    bool                               withBettiNumbers = false);

/** The topology of each material of a mesh, with Betti numbers; materials are up to `numberOfMaterials`, which stands
 * for what is none of them. */
MeshTopology
ComputeMeshTopology(const std::vector<Vector> & points, const TetrahedralMesh & mesh, std::size_t numberOfMaterials);
} // namespace mmm

#endif
