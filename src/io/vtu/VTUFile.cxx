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
#include "io/vtu/VTUFile.h"
#include "base/EscapedXML.h"
#include "itkOutputFile.h"
#include "io/vtu/VTUFormat.h"

#include "itkByteSwapper.h"

namespace mmm
{
namespace
{
void
CheckCounts(const VTUContent & content)
{
  if (!content.pointData.empty() && content.numberOfPointPixels != content.numberOfPoints)
  {
    throw MeshFileError("it has data of " + std::to_string(content.numberOfPointPixels) + " points, but " +
                        std::to_string(content.numberOfPoints) + " points");
  }
  if (!content.cellData.empty() && content.numberOfCellPixels != content.numberOfCells)
  {
    throw MeshFileError("it has data of " + std::to_string(content.numberOfCellPixels) + " cells, but " +
                        std::to_string(content.numberOfCells) + " cells");
  }
}

std::string
DataTag(const std::string & tag, const std::string & scalars)
{
  return "      <" + tag + (scalars.empty() ? "" : " Scalars=\"" + EscapedXML(scalars) + '"') + ">\n";
}

std::string
OpeningTags(const VTUContent & content)
{
  const std::string byteOrder = itk::ByteSwapper<int>::SystemIsBigEndian() ? "BigEndian" : "LittleEndian";
  const std::string compressor =
    content.encoding == VTUEncoding::CompressedBase64 ? " compressor=\"vtkZLibDataCompressor\"" : "";
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"" + byteOrder +
         "\" header_type=\"UInt64\"" + compressor + ">\n  <UnstructuredGrid>\n" + content.fieldData +
         "    <Piece NumberOfPoints=\"" + std::to_string(content.numberOfPoints) + "\" NumberOfCells=\"" +
         std::to_string(content.numberOfCells) + "\">\n";
}

std::string
FieldArray(const std::string & attributes, const std::string & values)
{
  return "      <DataArray " + attributes + " format=\"ascii\">\n" + values + "      </DataArray>\n";
}
} // namespace

std::string
VTUFieldData(bool hasSpace, const LabelTable & labels)
{
  // The character codes of LPS, zero-terminated.
  std::string arrays = hasSpace ? "      <Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">\n"
                                  "        76 80 83 0\n"
                                  "      </Array>\n"
                                : "";
  std::string colors;
  std::size_t numberOfColors = 0;
  for (const auto & [label, entry] : labels)
  {
    const std::string number = "        " + std::to_string(label);
    if (!entry.name.empty())
    {
      arrays +=
        FieldArray("type=\"Int32\" Name=\"" + EscapedXML(entry.name) + "\" NumberOfTuples=\"2\"", number + " 3\n");
    }
    if (entry.color)
    {
      colors += number;
      for (const double component : *entry.color)
      {
        AppendNumber(colors += ' ', component);
      }
      colors += '\n';
      ++numberOfColors;
    }
  }
  if (numberOfColors > 0)
  {
    arrays += FieldArray("type=\"Float64\" Name=\"label_colors\" NumberOfComponents=\"4\" NumberOfTuples=\"" +
                           std::to_string(numberOfColors) + '"',
                         colors);
  }
  return arrays.empty() ? "" : "    <FieldData>\n" + arrays + "    </FieldData>\n";
}

void
WriteVTUFile(const std::string & fileName, const VTUContent & content)
{
  CheckCounts(content);
  itk::OutputFile file(fileName);
  file.Write(OpeningTags(content) + DataTag("PointData", content.pointScalars));
  file.Write(content.pointData);
  file.Write("      </PointData>\n" + DataTag("CellData", content.cellScalars));
  file.Write(content.cellData);
  file.Write("      </CellData>\n"
             "      <Points>\n");
  file.Write(content.points);
  file.Write("      </Points>\n"
             "      <Cells>\n");
  file.Write(VTUArrayElement("Int64", "connectivity", 1, content.encoding, content.cells.connectivity));
  file.Write(VTUArrayElement("Int64", "offsets", 1, content.encoding, content.cells.offsets));
  file.Write(VTUArrayElement("UInt8", "types", 1, content.encoding, content.cells.types));
  file.Write("      </Cells>\n"
             "    </Piece>\n"
             "  </UnstructuredGrid>\n"
             "</VTKFile>\n");
  file.Commit();
}
} // namespace mmm
