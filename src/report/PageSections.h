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
#ifndef mmmPageSections_h
#define mmmPageSections_h

#include "itkMeshPage.h"

#include <set>
#include <string>

namespace mmm
{
/** The parts of a page, as HTML. Those that take details show names and colors of labels. */

/** The labels that the mesh has or was to have. */
std::set<int>
LabelsOfPage(const itk::MeshFacts & facts);

/** The numbers that tell most. */
std::string
MakeKeyFigures(const itk::MeshFacts & facts);

/** What was warned of, each once. */
std::string
MakeWarningSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details);

/** Three cuts through the mesh, with the labels as legend. */
std::string
MakeCutSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details);

/** Volumes against the image's, parts, topology, by label. */
std::string
MakeLabelSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details);

/** Angles and radius ratios, of the mesh and by label, and the worst tetrahedra. */
std::string
MakeShapeSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details);

/** Where electrodes are, and their contact areas; empty if there are none. */
std::string
MakeElectrodeSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details);

/** Numbers expected and made, edge lengths asked for and got, how far particles are off. */
std::string
MakeSizeSection(const itk::MeshFacts & facts);

/** What was merged, lost or left, and where. */
std::string
MakeLossSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details);

/** Time and memory per stage. */
std::string
MakeStageSection(const itk::MeshFacts & facts);

/** The image, the run and the settings. */
std::string
MakeSettingSection(const itk::MeshPageDetails & details);

/** What makes the page look and move as it does; no network is needed. */
extern const char * const PageStyle;
extern const char * const PageScript;
} // namespace mmm

#endif
