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
#include "image/SliceInterpolation.h"

#include "base/IndexBox.h"
#include "base/Parallel.h"
#include "image/SliceGap.h"

#include <algorithm>
#include <cassert>

namespace mmm
{
namespace
{
/** The slices of an image, which may be const, across an axis. */
template <typename TImage>
class Slices
{
public:
  Slices(TImage & image, int axis)
    : m_Image(image)
    , m_Axis(axis)
  {}

  SlicePlane
  Plane() const
  {
    const int a = m_Axis == 0 ? 1 : 0;
    const int b = m_Axis == 2 ? 1 : 2;
    return { { { m_Image.grid.size[a], m_Image.grid.size[b] } },
             { { m_Image.grid.spacing[a], m_Image.grid.spacing[b] } } };
  }

  Slice
  Get(int number) const
  {
    Slice slice;
    slice.reserve(this->Plane().NumberOfPixels());
    this->Visit(number, [&](Material m) { slice.push_back(m); });
    return slice;
  }

  void
  Set(int number, const Slice & slice)
  {
    auto next = slice.begin();
    this->Visit(number, [&](Material & m) { m = *next++; });
  }

private:
  template <typename TVisit>
  void
  Visit(int number, const TVisit & visit) const
  {
    Index lower{ { 0, 0, 0 } };
    Index upper{ { m_Image.grid.size[0] - 1, m_Image.grid.size[1] - 1, m_Image.grid.size[2] - 1 } };
    lower[m_Axis] = upper[m_Axis] = number;
    IndexBox{ lower, upper }.Visit([&](const Index & at) { visit(m_Image.materials[m_Image.grid.Offset(at)]); });
  }

  TImage &  m_Image;
  const int m_Axis;
};
} // namespace

MaterialImage
InterpolateSlices(const MaterialImage & image, int axis, int parts)
{
  assert(parts > 0);
  MaterialImage fine;
  fine.grid = image.grid;
  fine.grid.size[axis] *= parts;
  fine.grid.spacing[axis] /= parts;
  fine.numberOfMaterials = image.numberOfMaterials;
  fine.materials.assign(fine.grid.NumberOfNodes(), 0);

  const Slices<const MaterialImage> from(image, axis);
  Slices<MaterialImage>             to(fine, axis);
  const auto                        plane = from.Plane();
  const int                         last = image.grid.size[axis] - 1;
  // gap g is below slice g; before the first one and after the last one, there is nothing to go to
  ParallelFor(std::size_t(last) + 2, 1, [&](std::size_t begin, std::size_t end) {
    for (int gap = int(begin); gap < int(end); ++gap)
    {
      const SliceGap between(
        plane, image.grid.spacing[axis], from.Get(std::max(0, gap - 1)), from.Get(std::min(gap, last)));
      for (int part = 0; part < parts; ++part)
      {
        // counted in halves of a thinner slice from the middle of the slice below
        const int place = 2 * part + (parts % 2 == 0 ? 1 : 0);
        const int number = (gap - 1) * parts + parts / 2 + part;
        if (number >= 0 && number < fine.grid.size[axis])
        {
          to.Set(number, place == 0 ? from.Get(std::max(0, gap - 1)) : between.At(0.5 * place / parts));
        }
      }
    }
  });
  return fine;
}
} // namespace mmm
