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
#ifndef mmmVTUDocument_h
#define mmmVTUDocument_h

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace mmm
{
/** A `<DataArray>`, or a string `<Array>`: what it says of itself and where in the file its values are. */
struct VTUArray
{
  std::string   name;
  std::string   type;
  std::string   format;
  std::uint64_t numberOfComponents{ 1 };
  /** The bytes of the file between the tags. */
  std::uint64_t begin{ 0 };
  std::uint64_t end{ 0 };
  /** Of appended values: where they begin in the appended data. */
  std::optional<std::uint64_t> offset;
};

/** The structure of a .vtu file, without values. */
struct VTUDocument
{
  bool          bigEndian{ false };
  bool          compressed{ false };
  unsigned int  headerSize{ 4 };
  std::uint64_t numberOfPoints{ 0 };
  std::uint64_t numberOfCells{ 0 };

  std::vector<VTUArray> fieldData;
  std::vector<VTUArray> pointData;
  std::vector<VTUArray> cellData;
  std::vector<VTUArray> points;
  std::vector<VTUArray> cells;

  bool                         appendedBase64{ false };
  std::optional<std::uint64_t> appendedBegin;
  std::uint64_t                fileSize{ 0 };
};

/** Reads the tags of a file; throws MeshFileError if it is no .vtu file or has parts that are not supported. */
VTUDocument
ParseVTUDocument(std::istream & file);
} // namespace mmm

#endif
