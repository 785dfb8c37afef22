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
#ifndef mmmPoints_h
#define mmmPoints_h

#include "base/Grid.h"

#include "itkPoint.h"

#include <algorithm>
#include <vector>

namespace mmm
{
/** A point as reports have it. */
inline itk::Point<double, 3>
ToPoint(const Vector & x)
{
  itk::Point<double, 3> point;
  std::copy_n(x.data(), 3, point.GetDataPointer());
  return point;
}

/** A point of a report as the core has it. */
inline Vector
ToVector(const itk::Point<double, 3> & point)
{
  return Vector(point.GetDataPointer());
}

inline std::vector<itk::Point<double, 3>>
ToPoints(const std::vector<Vector> & vectors)
{
  std::vector<itk::Point<double, 3>> points(vectors.size());
  std::transform(vectors.begin(), vectors.end(), points.begin(), ToPoint);
  return points;
}

inline std::vector<Vector>
ToVectors(const std::vector<itk::Point<double, 3>> & points)
{
  std::vector<Vector> vectors(points.size());
  std::transform(points.begin(), points.end(), vectors.begin(), ToVector);
  return vectors;
}
} // namespace mmm

#endif
