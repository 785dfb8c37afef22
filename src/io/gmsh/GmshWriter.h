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
#ifndef mmmGmshWriter_h
#define mmmGmshWriter_h

#include "io/CellArrays.h"
#include "io/CellMesh.h"

#include <string>

namespace mmm
{
struct GmshFormat
{
  /** Whether it is version 2.2; else it is 4.1. */
  bool isVersion2{ false };
  bool isBinary{ true };
  /** Of physical groups. */
  bool hasNames{ true };
};

/** Writes a .msh file: tags are physical groups, 0 is none. Throws an exception and leaves no file if it cannot. */
void
WriteGmsh(const std::string & fileName, const CellMesh & mesh, const CellArrays & arrays, const GmshFormat & format);
} // namespace mmm

#endif
