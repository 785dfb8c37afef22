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
#ifndef mmmHeadPhantom_h
#define mmmHeadPhantom_h

#include "itk_eigen.h"
#include ITK_EIGEN(Dense)

namespace mmm
{
using Vector = Eigen::Vector3d;

/** The labels of HeadPhantomLabel(), those of the common six-tissue head models. */
enum class HeadTissue : unsigned char
{
  Outside = 0,
  Scalp = 1,
  Skull = 2,
  CerebrospinalFluid = 3,
  GrayMatter = 4,
  WhiteMatter = 5,
  Air = 6
};

/** \brief The tissue of a synthetic head at a point: a pure function, in closed form.
 *
 * Points are in mm, x to the left, y to the back, z upwards (LPS). The brain surrounds the origin. The vertex is at
 * z = 87, the chin at z = -135, the nose tip at y = -112, the back of the head at y = 102 and the ears at x = -85 and
 * 85; the neck continues downwards without end. Bone is 2 mm thick where it is thinnest, the fluid below it 1.7 mm. */
HeadTissue
HeadPhantomTissue(const Vector & point);

/** Bounds, in mm, the distance of a point to the ventricles, the only CSF that white matter touches: negative inside.
 */
double
HeadPhantomVentricles(const Vector & point);
} // namespace mmm

#endif
