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
#ifndef mmmFunctionImages_h
#define mmmFunctionImages_h

#include "base/Monitor.h"
#include "itkIndicatorImageStages.h"
#include "itkLabelImageStages.h"

namespace mmm
{
/** The indicators of labels from functions of them, see FunctionIndicators. `image` has the labels, sorted in
 * `present`, of which one stands for all of `exteriorLabels`. */
std::vector<FloatImage::Pointer>
ComputeFunctionIndicators(const IndicatorInputs &  functions,
                          const std::vector<int> & exteriorLabels,
                          const std::vector<int> & present,
                          const LabelImage *       image,
                          Monitor &                monitor);
} // namespace mmm

#endif
