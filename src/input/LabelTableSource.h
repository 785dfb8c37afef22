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
#ifndef mmmLabelTableSource_h
#define mmmLabelTableSource_h

#include "MultiMaterialMeshingLabels.h"

#include <array>
#include <cstddef>
#include <string>

namespace mmm
{
constexpr double HighestByte = 255.0;

/** \brief Where one is in a file, and what was found so far. */
struct LabelTableSource
{
  using Color = std::array<double, 3>;

  std::string fileName;
  std::size_t line{ 0 };
  LabelTable  table;

  /** Throws itk::ExceptionObject with the file and the line. */
  [[noreturn]] void
  Fail(const std::string & what) const;

  /** Throws if the label has another entry. */
  void
  Add(int label, const LabelEntry & entry);

  /** "#cd3e4e"; throws if it is not of that form. */
  Color
  ParseHexadecimal(const std::string & text) const;
};

/** Whether all of a word is a label. */
bool
ParseLabel(const std::string & word, int & label);
} // namespace mmm

#endif
