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
#ifndef Hulls_h
#define Hulls_h

#include "run/Outcome.h"

namespace cli
{
/** Throws if a hull has no label that the image has, and warns of each that it has not. */
void
CheckHullLabels(const Settings & settings, const Input & input);

/** Makes the hulls, and warns of what boundary elements do not take. */
void
MakeHulls(Outcome & outcome);
} // namespace cli

#endif
