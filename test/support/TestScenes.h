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
#ifndef mmmTestScenes_h
#define mmmTestScenes_h

#include "indicators/IndicatorSet.h"
#include "indicators/IndicatorSmoothing.h"
#include "sizing/Sizing.h"
#include "support/TestShapes.h"
#include "indicators/VolumeCorrection.h"

#include <memory>

/** Small scenes in the terms of the geometry core: materials by a function of position, and what is computed of them.
 */
namespace mmmtest
{
template <typename TFunction>
mmm::MaterialImage
MakeMaterials(const mmm::Index & size, const mmm::Vector & spacing, std::size_t count, const TFunction & materialAt)
{
  mmm::MaterialImage image;
  image.grid.size = size;
  image.grid.spacing = spacing;
  image.numberOfMaterials = count;
  image.materials.resize(image.grid.NumberOfNodes());
  for (std::size_t n = 0; n < image.materials.size(); ++n)
  {
    image.materials[n] = mmm::Material(materialAt(image.grid.Position(image.grid.IndexAt(n))));
  }
  return image;
}

/** An image and its indicators. */
struct Scene
{
  mmm::MaterialImage                 image;
  std::unique_ptr<mmm::IndicatorSet> indicators;

  explicit Scene(mmm::MaterialImage materials, double radius = 0.5)
    : image(std::move(materials))
  {
    const auto                     boxes = mmm::ComputeMaterialBoxes(image);
    std::vector<mmm::Block<float>> blocks;
    for (std::size_t m = 0; m < boxes.size(); ++m)
    {
      blocks.push_back(mmm::ComputeSmoothIndicator(image, mmm::Material(m), boxes[m], radius));
    }
    if (radius > 0.0)
    {
      mmm::CorrectVolumes(image, blocks);
    }
    indicators = std::make_unique<mmm::IndicatorSet>(mmm::MakeIndicatorSet(image.grid, blocks));
  }
};

/** Material 1 in a ball around `centre`, 0 outside. */
inline mmm::MaterialImage
MakeBallMaterials(int size, const mmm::Vector & centre, double radius)
{
  return MakeMaterials({ { size, size, size } }, mmm::Vector::Ones(), 2, [=](const mmm::Vector & x) {
    return (x - centre).norm() < radius ? 1 : 0;
  });
}
} // namespace mmmtest

#endif
