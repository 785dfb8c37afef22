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
#ifndef mmmSurfaceFile_h
#define mmmSurfaceFile_h

#include "itkSurfaceStages.h"

#include <string>
#include <vector>

namespace mmm
{
/** A surface as its file has it. */
struct SurfaceFile
{
  SurfaceTriangles surface;
  /** Whether the format says that points are in RAS. */
  bool isInRAS{ false };
  /** What a user should know. */
  std::vector<std::string> notes;
};

[[noreturn]] void
ThrowDamagedSurface(const std::string & fileName, const std::string & reason);

/** Throws itk::ExceptionObject unless a cell has three corners. */
void
CheckCorners(const std::string & fileName, std::size_t cell, std::size_t corners);

/** Whether the bytes are those of a surface of FreeSurfer. */
bool
IsFreeSurferSurface(const std::string & bytes);

/** From the bytes of a file. Throw itk::ExceptionObject if they are damaged. */
SurfaceFile
ParseFreeSurfer(const std::string & fileName, const std::string & bytes);
SurfaceFile
ParseOBJ(const std::string & fileName, const std::string & bytes);
SurfaceFile
ParseOFF(const std::string & fileName, const std::string & bytes);
SurfaceFile
ParseSTL(const std::string & fileName, const std::string & bytes);
} // namespace mmm

#endif
