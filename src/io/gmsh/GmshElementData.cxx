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
#include "io/gmsh/GmshElementData.h"

#include <algorithm>
#include <limits>

namespace mmm
{
void
WriteGmshElementData(FileComposer & file, const CellArrays & arrays, const std::vector<std::size_t> & order)
{
  if (!arrays.empty() && order.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw MeshFileError("it has more cells than such files can have data of");
  }
  for (const auto & array : arrays)
  {
    const std::size_t components = ComponentsOf(array, order.size());
    std::string       name = array.first;
    std::replace_if(name.begin(), name.end(), [](char c) { return c == '"' || c == '\n' || c == '\r'; }, ' ');
    // one text, the name; one real number, a time; three whole ones: step, numbers of a cell, cells
    file.Text("$ElementData\n1\n\"" + name + "\"\n1\n0\n3\n0\n" + std::to_string(components) + '\n' +
              std::to_string(order.size()) + '\n');
    int number = 0;
    for (const std::size_t cell : order)
    {
      file.Int(++number);
      for (std::size_t c = 0; c < components; ++c)
      {
        file.Real(array.second[components * cell + c]);
      }
      file.EndLine();
    }
    file.EndNumbers();
    file.Text("$EndElementData\n");
  }
}

void
TurnLPSAndRAS(CellArrays & arrays, std::size_t numberOfCells)
{
  const auto sign = [](std::size_t axis) { return axis < 2 ? -1.0 : 1.0; };
  for (auto & array : arrays)
  {
    const std::size_t components = ComponentsOf(array, numberOfCells);
    for (std::size_t n = 0; n < array.second.size() && components > 1; ++n)
    {
      const std::size_t c = n % components;
      array.second[n] *= components == 3 ? sign(c) : sign(c / 3) * sign(c % 3);
    }
  }
}
} // namespace mmm
