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
#ifndef mmmTopologyComparison_h
#define mmmTopologyComparison_h

#include "MultiMaterialMeshingReports.h"
#include "mesh/MeshTopology.h"
#include "topology/TopologyDifferences.h"

namespace mmm
{
/** \brief Compares the topology of meshes with that of the argmax partition of the indicators.
 *
 * A mesh's Betti numbers are exact, see ComputeMeshTopology(); the partition's are those of samples, corrected
 * where more samples show that the mesh is right, see TopologyDifferenceFinder: if no place is left for a material,
 * its numbers are the mesh's, otherwise its tunnels change. The places are found there, too; their changes add up to
 * the difference of the Euler characteristics, or else what is left unexplained is told. */
class TopologyComparison
{
public:
  /** The indicators have to stay. What is of `exterior` in a mesh is not looked at; there may be nothing instead.
   * `samplesPerVoxel` is along each axis, 2 or 4. */
  TopologyComparison(const IndicatorSet & indicators, Material exterior, int samplesPerVoxel);

  const SampleLattice &
  GetLattice() const
  {
    return m_Lattice;
  }
  const SampledMaterials &
  GetPartition() const
  {
    return m_Partition;
  }

  /** See TopologyDifferenceFinder::Find(). */
  TopologyDifferences
  FindDifferences(const std::vector<Vector> &  points,
                  const TetrahedralMesh &      mesh,
                  const TetrahedronAdjacency & adjacency)
  {
    return m_Finder.Find(points, mesh, adjacency);
  }
  /** The same with Betti numbers. */
  TopologyReport
  Compare(const std::vector<Vector> & points, const TetrahedralMesh & mesh, const TetrahedronAdjacency & adjacency);

private:
  const SampleLattice      m_Lattice;
  const SampledMaterials   m_Partition;
  const Material           m_Exterior;
  TopologyDifferenceFinder m_Finder;
};
} // namespace mmm

#endif
