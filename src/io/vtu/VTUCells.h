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
#ifndef mmmVTUCells_h
#define mmmVTUCells_h

#include "io/vtu/VTUArrayEncoder.h"
#include "io/vtu/VTUDocument.h"

#include "itkIntTypes.h"
#include "itkCommonEnums.h"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace mmm
{
/** The cells of a file as itk::MeshIOBase passes them: type, number of points, point identifiers, type, ... */
struct VTUCells
{
  std::vector<itk::IdentifierType> buffer;
  std::size_t                      count{ 0 };
  /** For each cell the cell of the file it is of; empty if they are the same. */
  std::vector<std::size_t> sources;
};

/** Throws MeshFileError unless all cells are complete and refer to points of the file. */
VTUCells
ReadVTUCells(std::istream & file, const VTUDocument & document);

/** The contents of the three arrays of `<Cells>`. */
struct EncodedVTUCells
{
  std::string connectivity;
  std::string offsets;
  std::string types;
};

/** Encodes a buffer of itk::MeshIOBase. Throws MeshFileError if a cell has no VTK type or refers to a point that is
 * none. */
EncodedVTUCells
EncodeVTUCells(const void *         buffer,
               itk::IOComponentEnum type,
               std::size_t          bufferSize,
               std::size_t          numberOfCells,
               std::size_t          numberOfPoints,
               VTUEncoding          encoding);

/** One vertex per point. */
EncodedVTUCells
EncodeVTUVertices(std::size_t numberOfPoints, VTUEncoding encoding);
} // namespace mmm

#endif
