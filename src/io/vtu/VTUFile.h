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
#ifndef mmmVTUFile_h
#define mmmVTUFile_h

#include "io/vtu/VTUArrayEncoder.h"
#include "io/vtu/VTUCells.h"
#include "MultiMaterialMeshingLabels.h"

#include <cstddef>
#include <string>

namespace mmm
{
/** The encoded parts of a .vtu file. */
struct VTUContent
{
  VTUEncoding encoding{ VTUEncoding::CompressedBase64 };
  /** The whole element, see VTUFieldData(). */
  std::string     fieldData;
  std::size_t     numberOfPoints{ 0 };
  std::size_t     numberOfCells{ 0 };
  std::size_t     numberOfPointPixels{ 0 };
  std::size_t     numberOfCellPixels{ 0 };
  std::string     points;
  EncodedVTUCells cells;
  std::string     pointData;
  std::string     cellData;
  /** The arrays that viewers show first. */
  std::string pointScalars;
  std::string cellScalars;
};

/** The field data: whether the points are in LPS, and what labels are called, see itk::VTUMeshIO. Empty if there are
 * none. */
std::string
VTUFieldData(bool hasSpace, const LabelTable & labels);

/** Writes the file, or throws and leaves none. */
void
WriteVTUFile(const std::string & fileName, const VTUContent & content);
} // namespace mmm

#endif
