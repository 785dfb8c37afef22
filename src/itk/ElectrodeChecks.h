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
#ifndef mmmElectrodeChecks_h
#define mmmElectrodeChecks_h

#include "itkElectrodes.h"
#include "itkLabelImageStages.h"

#include "itkMacro.h"

#include <array>
#include <sstream>
#include <vector>

namespace mmm
{
/** That of the electrode and that of its gel. */
inline std::array<int, 2>
LabelsOf(const Electrode & electrode)
{
  return { { electrode.label, electrode.gel ? electrode.gel->label : electrode.label } };
}

/** \brief Whether electrodes can be on top of a label image. What is wrong throws itk::ExceptionObject that begins with
 * the electrode's source. */
class ElectrodeChecks
{
public:
  /** `voxel` is the longest edge of a voxel, in mm. */
  ElectrodeChecks(const LabelImage * labels, const std::vector<int> & exteriorLabels, double voxel)
    : m_Counts(CountLabels(labels))
    , m_Exterior(exteriorLabels)
    , m_Voxel(voxel)
  {}

  /** Labels and lengths. */
  void
  Verify(const Electrode & electrode) const;
  /** A length in mm, of a key of the electrode, which is to be so many voxels at least. What is thinner may have no
   * voxel's centre in it, and gets holes. */
  static constexpr double LeastVoxels = 1.5;
  /** The same for the shafts and contacts of leads, which are of one piece. */
  static constexpr double LeastVoxelsOfLeads = 1.2;
  static double
  LeastVoxelsOf(const Electrode & electrode);
  void
  VerifyLength(const Electrode & electrode, const char * key, double length, double voxels = LeastVoxels) const;
  /** What the skin that bulges leaves of a thickness. */
  void
  VerifyBulge(const Electrode & electrode, const char * key, double least) const;
  /** How far it was from the skin. */
  static void
  VerifyProjection(const Electrode & electrode, double distance);

  template <typename... TWords>
  [[noreturn]] static void
  Fail(const Electrode & electrode, const char * key, const TWords &... words)
  {
    std::ostringstream text;
    (text << ... << words);
    const std::string source = electrode.source.empty() ? "electrode '" + electrode.name + "'" : electrode.source;
    itkGenericExceptionMacro(<< source << (*key == '\0' ? "" : ".") << key << ": " << text.str() << '.');
  }

private:
  void
  VerifyLabel(const Electrode & electrode, const char * key, int label) const;

  const LabelCounts        m_Counts;
  const std::vector<int> & m_Exterior;
  double                   m_Voxel;
};
} // namespace mmm

#endif
