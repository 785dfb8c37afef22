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
#ifndef Outcome_h
#define Outcome_h

#include "run/MeshFilter.h"
#include "itkLabelHullMeshFilter.h"
#include "MultiMaterialMeshingQuality.h"

#include <string>
#include <vector>

namespace cli
{
/** Numbers of the tetrahedra, and how many of these are outside of the image that they are from. */
struct CellDataRecord
{
  std::string         name;
  std::vector<double> values;
  std::size_t         outside{ 0 };
  std::size_t         partlyOutside{ 0 };
};

/** \brief All that a run has produced: what is written, reported and summed up. */
struct Outcome
{
  Settings            settings;
  Input               input;
  MeshFilter::Pointer filter;
  /** Disconnected from the filter. The tetrahedra are empty with --surface-only. */
  itk::LabelTetrahedralMesh::Pointer tetrahedra;
  itk::LabelInterfaceMesh::Pointer   surface;
  itk::LabelParticleMesh::Pointer    particles;
  itk::LabelJunctionMesh::Pointer    junctions;
  /** Null for elements of first order. */
  itk::LabelMidNodeMesh::Pointer midNodes;
  /** In the order of the settings' hulls. */
  std::vector<itk::LabelHullMeshFilter::Pointer> hulls;
  std::vector<CellDataRecord>                    cellData;
  mmm::MeshQualityReport                         quality;
  mmm::Distribution                              surfaceQuality;
  std::vector<mmm::StageRecord>                  stages;
  double                                         seconds{ 0.0 };
  /** Those that are written, in this order. */
  std::vector<std::string> files;
};
} // namespace cli

#endif
