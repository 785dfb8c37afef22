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
#ifndef mmmHeadPhantomFolds_h
#define mmmHeadPhantomFolds_h

#include "phantom/HeadPhantom.h"

/** Thin sheets of fluid that cut into the brain. Each function bounds the distance, in mm, to its sheets. */
namespace mmm::phantom
{
/** Between the hemispheres down to the corpus callosum, and the cingulate sulcus that branches off it. */
double
MidlineFissures(const Vector & point);

/** Between the temporal lobe and the rest, widening to the plane of the insula at its bottom. */
double
LateralFissure(const Vector & point);

/** The folds of the cerebral cortex; `depth` is the distance to the skull. */
double
Sulci(const Vector & point, double depth);

/** The folds of the cerebellar cortex; `depth` is the distance to the surface of the cerebellum. */
double
Folia(const Vector & point, double depth);
} // namespace mmm::phantom

#endif
