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
#ifndef mmmElectrodeSkin_h
#define mmmElectrodeSkin_h

#include "electrodes/Skin.h"
#include "itk/GridGeometry.h"
#include "itk/LabelDomain.h"

#include <memory>
#include <vector>

namespace mmm
{
/** A region and some voxels around it, all exterior, so that heads have skin where the image cuts them. */
itk::ImageRegion<3>
WithExteriorAround(itk::ImageRegion<3> region);

/** The skin in a geometry of such a region. Throws itk::ExceptionObject if the image has no exterior. */
std::unique_ptr<Skin>
MakeSkin(const LabelImage & labels, const std::vector<int> & exteriorLabels, const GridGeometry & geometry);
} // namespace mmm

#endif
