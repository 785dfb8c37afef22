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
#ifndef itkMeshPage_h
#define itkMeshPage_h

#include "itkMeshReport.h"
#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingLabels.h"

#include "itkIndex.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \brief What a page says of a mesh besides its facts. All of it may be left out. */
struct MeshPageDetails
{
  /** Names and values, in their order. */
  using RowsType = std::vector<std::pair<std::string, std::string>>;

  /** What was meshed, for instance the name of a file. */
  std::string title;
  /** What there is to know of the image and of the run. */
  RowsType input;
  RowsType settings;
  /** What was warned of, besides the warnings of the report. */
  std::vector<std::string> warnings;
  /** Names and colors of labels. */
  mmm::LabelTable labels;
  /** The voxels of each label whose volume in the mesh is to be compared with the image's. */
  mmm::LabelCounts voxels;
  /** The label of a voxel of the image, which is drawn under the cuts through the mesh. */
  std::function<int(const Index<3> &)> labelAt;
  /** The report as JSON, which the page has with it. Default: MakeMeshReport(). */
  std::string json;
};

/** A page of HTML to look at in a browser, complete in itself: labels with their volumes and shapes, three cuts through
 * the mesh as drawings over the voxels, sizes asked for and got, what was merged, lost or left and where, time and
 * memory per stage, settings and warnings. */
MultiMaterialMeshing_EXPORT std::string
                            MakeMeshPage(const MeshFacts & facts, const MeshPageDetails & details);

/** Whether a report of this name is a page: it ends with .html or .htm, in capitals or not. */
MultiMaterialMeshing_EXPORT bool
IsMeshPage(const std::string & fileName);

/** Writes a page if IsMeshPage(), else the JSON. The file appears when it is complete.
 *
 * \throw ExceptionObject if it cannot be written */
MultiMaterialMeshing_EXPORT void
WriteMeshReport(const std::string & fileName, const MeshFacts & facts, const MeshPageDetails & details);
} // end namespace itk

#endif
