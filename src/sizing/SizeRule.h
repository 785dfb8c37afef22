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
#ifndef mmmSizeRule_h
#define mmmSizeRule_h

#include "MultiMaterialMeshingExport.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace mmm
{
/** \brief What is asked of the edge lengths in a label or a region. A bound that is not a number is not given. */
struct SizeRule
{
  double factor{ 1.0 };
  double minimumSize{ std::numeric_limits<double>::quiet_NaN() };
  double maximumSize{ std::numeric_limits<double>::quiet_NaN() };

  /** Whether it asks for anything. */
  bool
  IsGiven() const;
};

/** Rules by label. */
using LabelSizeRules = std::map<int, SizeRule>;

/** \brief Rules from a text such as "3:factor=0.5:max=2,7:min=1".
 *
 * Labels are separated by commas. What is asked of each follows after colons: factor, min and max, in any order. An
 * empty text has no rules. Throws itk::ExceptionObject that tells what cannot be read. Values are not checked. */
MultiMaterialMeshing_EXPORT LabelSizeRules
ParseLabelSizeRules(const std::string & text);

/** The text that gives these rules. */
MultiMaterialMeshing_EXPORT std::string
                            ToText(const LabelSizeRules & rules);

/** What is wrong with a rule, in a sentence that calls its place, such as "label 3", by name; empty if nothing is. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeError(const SizeRule & rule, const std::string & place);

/** Which rules are for labels that are not in the list, and what is in it, in a sentence; empty if all are. */
MultiMaterialMeshing_EXPORT std::string
                            DescribeUnknownLabels(const LabelSizeRules & rules, std::vector<int> labels);
} // namespace mmm

#endif
