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
#ifndef mmmElectrodeContacts_h
#define mmmElectrodeContacts_h

#include "itkElectrodes.h"
#include "itkMultiMaterialMeshTypes.h"

#include <vector>

namespace mmm
{
/** Measures the contact areas of electrodes in a mesh, one report for each of them. Where several have a label in
 * common, a triangle is that of the nearest one. */
void
MeasureContacts(const Electrodes &              electrodes,
                const itk::LabelInterfaceMesh * surface,
                const std::vector<int> &        exteriorLabels,
                int                             outsideLabel,
                std::vector<ElectrodeReport> &  reports);
} // namespace mmm

#endif
