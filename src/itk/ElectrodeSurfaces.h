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
#ifndef mmmElectrodeSurfaces_h
#define mmmElectrodeSurfaces_h

#include "itk/LabelDomain.h"
#include "itkLabelMeshing.h"

#include <map>
#include <vector>

namespace mmm
{
/** \brief The electrodes of what is meshed, as the last of its surfaces. */
class ElectrodeSurfaces
{
public:
  /** Places the electrodes of `inputs`: adds them to its surfaces, their sizes to its sizes, and exterior to its labels
   * so that they are all in the image. */
  ElectrodeSurfaces(LabelMeshingInputs & inputs, std::vector<ElectrodeReport> & reports);

  /** Electrodes are no islands, however few voxels they have: gives them back to `labels`, of which islands were merged
   * and which begins where the domain does. */
  void
  Restore(const SurfaceInputs &         surfaces,
          const LabelDomain &           domain,
          LabelImage *                  labels,
          std::map<int, IslandRecord> & records) const;

private:
  std::size_t m_First;
};

/** The labels of `inputs` with one for all exterior, the first that there is, as merging of islands takes it as well.
 */
LabelImage::ConstPointer
UniteExterior(const LabelMeshingInputs & inputs);
} // namespace mmm

#endif
