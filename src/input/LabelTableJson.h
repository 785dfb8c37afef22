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
#ifndef mmmLabelTableJson_h
#define mmmLabelTableJson_h

#include "input/JsonValue.h"
#include "input/LabelTableSource.h"

namespace mmm
{
/** The object of a JSON text in which BIDS ("LabelMap") and nnU-Net ("labels") have the names of labels; else null. */
const JsonValue *
FindLabelMap(const JsonValue & value);

/** Adds what the members of an object say of labels, see ParseLabelTable(). */
void
AddLabels(LabelTableSource & source, const JsonValue & object);
} // namespace mmm

#endif
