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
#ifndef mmmGmshWriter2_h
#define mmmGmshWriter2_h

#include "io/CellMesh.h"
#include "io/FileComposer.h"

namespace mmm
{
/** The nodes and elements of version 2.2. Throws MeshFileError if there are more than it can number. */
void
WriteGmshSections2(FileComposer & file, const CellMesh & mesh, bool isBinary);
} // namespace mmm

#endif
