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
#include "itkMeditMeshIO.h"

#include "io/FileCursor.h"
#include "io/medit/Medit.h"

namespace itk
{
MeditMeshIO::MeditMeshIO()
  : Superclass(".mesh")
{
  m_FileType = IOFileEnum::ASCII;
}

MeditMeshIO::~MeditMeshIO() = default;

void
MeditMeshIO::ReadFile(mmm::CellMesh & mesh)
{
  mmm::ReadMedit(mmm::ReadWholeFile(m_FileName), mesh);
}

void
MeditMeshIO::WriteFile(const mmm::CellMesh & mesh)
{
  mmm::WriteMedit(m_FileName, mesh);
}
} // end namespace itk
