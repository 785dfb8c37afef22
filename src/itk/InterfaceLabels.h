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
#ifndef mmmInterfaceLabels_h
#define mmmInterfaceLabels_h

#include "mesh/Junctions.h"
#include "particles/Particles.h"
#include "mesh/TetrahedralMesh.h"

#include <algorithm>
#include <array>
#include <vector>

namespace mmm
{
/** \brief Labels of materials: those of the image, and one for the outside, which stands for the exterior material, for
 * the faces of the image's box and for the number that no material has. */
class InterfaceLabels
{
public:
  /** `exterior` is the material that is not meshed, or -1. Then the outside gets the label `wanted` or, if that is one
   * of `labels`, 0 or, if that is, too, the one below the smallest label. */
  InterfaceLabels(const std::vector<int> & labels, int exterior, int wanted);

  int
  GetOutside() const
  {
    return m_Outside;
  }

  int
  OfMaterial(Material material) const
  {
    return material < m_Labels.size() ? m_Labels[material] : m_Outside;
  }

  /** Those of several materials, sorted, each once. */
  template <typename TMaterials>
  std::vector<int>
  OfMaterials(const TMaterials & materials) const
  {
    std::vector<int> labels;
    for (const auto material : materials)
    {
      labels.push_back(this->OfMaterial(Material(material)));
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    return labels;
  }

  /** The labels of a triangle's sides, the lower one first. */
  std::array<int, 2>
  OfSides(const std::array<Material, 2> & sides) const;

  /** The dimension of a particle's cell and the labels that meet there, sorted, the last one repeated to fill. */
  std::array<int, 5>
  OfParticle(const Cell & cell) const;

  /** The number of labels that meet at a junction and the first four of them, sorted, the last one repeated to fill. */
  std::array<int, 5>
  OfJunction(const MaterialList & materials) const;

private:
  std::vector<int> m_Labels;
  int              m_Outside;
};
} // namespace mmm

#endif
