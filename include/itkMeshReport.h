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
#ifndef itkMeshReport_h
#define itkMeshReport_h

#include "itkElectrodes.h"
#include "itkMultiMaterialMeshTypes.h"
#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingQuality.h"
#include "MultiMaterialMeshingReports.h"

#include "itkImageBase.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \brief What a mesh and its making are told by. All is as from the getters of LabelImageToTetrahedralMeshFilter. */
struct MeshFacts
{
  const mmm::MeshingReport *               meshing;
  const std::map<int, mmm::IslandRecord> * islands;
  const mmm::LabelCounts *                 vanishedLabels;
  const std::vector<mmm::StageRecord> *    stages;
  std::vector<int>                         absentExteriorLabels;
  int                                      outsideLabel{ 0 };
  const LabelTetrahedralMesh *             tetrahedra;
  const LabelInterfaceMesh *               surface;
  /** The image that was meshed, and the region of it that the mesh fills. */
  const ImageBase<3> * image;
  ImageRegion<3>       meshedRegion;
  /** Null, or empty, if there are none. */
  const std::vector<mmm::ElectrodeReport> * electrodes{ nullptr };
  /** Null if there is the surface only. */
  const mmm::MeshQualityReport * quality{ nullptr };
  mmm::Distribution              surfaceQuality;
};

/** Of the radius ratios of the triangles. */
MultiMaterialMeshing_EXPORT mmm::Distribution
                            ComputeSurfaceQuality(const LabelInterfaceMesh & surface);

/** A JSON object of counts, topology, quality, and time and memory per stage; the program's documentation has its
 * members. */
MultiMaterialMeshing_EXPORT std::string
                            MakeMeshReport(const MeshFacts & facts);
} // end namespace itk

#endif
