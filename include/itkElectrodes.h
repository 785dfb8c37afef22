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
#ifndef itkElectrodes_h
#define itkElectrodes_h

#include "MultiMaterialMeshingExport.h"
#include "MultiMaterialMeshingLabels.h"

#include "itkPoint.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/** Electrodes and implants by their shapes, in mm and LPS: what LabelImageToTetrahedralMeshFilter puts on top of a
 * label image. docs/electrodes.md has their file. */
namespace mmm
{
enum class ElectrodeShape
{
  /** On the skin. */
  Disc,
  Ring,
  Rectangle,
  /** In the head, or anywhere. */
  Sphere,
  Box,
  Cylinder
};

/** What fills the gap between an electrode and the skin. */
struct ElectrodeGel
{
  std::string name;
  int         label{ 0 };
  double      thickness{ 0.0 };
};

/** An electrode or an implant. What its shape has no use for is left as it is here. */
struct Electrode
{
  using PointType = itk::Point<double, 3>;

  std::string    name;
  int            label{ 0 };
  ElectrodeShape shape{ ElectrodeShape::Disc };
  /** Near the skin, or the middle of a sphere or a box, or an end of a cylinder. */
  PointType position;
  /** In place of a position on the skin: that of the 10-20 system, such as "Cz". */
  std::string site;
  /** The other end of a cylinder, or what the length of a rectangle points to; else it points up. */
  std::optional<PointType> end;
  double                   radius{ 0.0 };
  /** Of a ring; of a cylinder that is a tube. */
  double innerRadius{ 0.0 };
  /** Whether a cylinder begins, at its position, with half a sphere. */
  bool isRounded{ false };
  /** Of a contact that goes around an earlier implant of the same radius: the label of that, which is all that it
   * hides. */
  std::optional<int> bodyLabel;
  /** Length and width of a rectangle, edges of a box along x, y and z. */
  std::array<double, 3> size{ { 0.0, 0.0, 0.0 } };
  /** From the skin, or the gel, to the top. */
  double                      thickness{ 0.0 };
  std::optional<ElectrodeGel> gel;
  /** Where it was described, such as "cap.json: electrodes[3]"; for messages. */
  std::string source;

  bool
  IsOnSkin() const
  {
    return shape == ElectrodeShape::Disc || shape == ElectrodeShape::Ring || shape == ElectrodeShape::Rectangle;
  }
};

/** What the places of the 10-20 system follow from, near the skin. */
struct ElectrodeFiducials
{
  Electrode::PointType nasion;
  Electrode::PointType inion;
  Electrode::PointType left;
  Electrode::PointType right;
};

/** Later ones win over earlier ones. */
struct Electrodes
{
  std::vector<Electrode>            list;
  std::optional<ElectrodeFiducials> fiducials;
};

/** Of a lead for deep brain stimulation, in mm. Its contacts are bands, and its tip is round. */
struct LeadDimensions
{
  double diameter{ 0.0 };
  /** From the tip to the first contact. */
  double tipLength{ 0.0 };
  int    contacts{ 0 };
  double contactLength{ 0.0 };
  /** From contact to contact. */
  double spacing{ 0.0 };
};

/** Those that the makers publish: of "Medtronic 3387", "Medtronic 3389", "Medtronic 3391" and "Boston Scientific
 * DB-2201". Throws itk::ExceptionObject for another one. */
MultiMaterialMeshing_EXPORT LeadDimensions
LeadDimensionsOf(const std::string & model);

/** The shaft of a lead, from its tip to where it enters the head, and its contacts. The contact next to the tip has the
 * label `firstLabel`, the others have those that follow. */
MultiMaterialMeshing_EXPORT std::vector<Electrode>
                            MakeLead(const std::string &          name,
                                     int                          firstLabel,
                                     int                          shaftLabel,
                                     const Electrode::PointType & tip,
                                     const Electrode::PointType & entry,
                                     const LeadDimensions &       dimensions);

/** Reads a JSON file. Throws itk::ExceptionObject with the file, the place in it, what is wrong and what to do. */
MultiMaterialMeshing_EXPORT Electrodes
ReadElectrodes(const std::string & fileName);

/** The labels of electrodes and gels with their names. */
MultiMaterialMeshing_EXPORT LabelTable
NamesOf(const Electrodes & electrodes);

/** What became of an electrode. Areas are in mm^2; not a number where there is nothing to tell. */
struct ElectrodeReport
{
  static constexpr double None = std::numeric_limits<double>::quiet_NaN();

  std::string name;
  int         label{ 0 };
  /** On the skin, under its middle; of implants, where they are. */
  Electrode::PointType position;
  /** How far the skin was from the place that was asked for, in mm. */
  double projection{ None };
  /** The triangles between it and what is below: gel or tissue; of an implant, all around it but for other electrodes.
   */
  double contactArea{ None };
  /** The same as the shape says, on the skin as it is between the voxels. */
  double expectedArea{ None };
  /** Of its gel with the skin. */
  double gelContactArea{ None };
  double expectedGelArea{ None };
  /** Earlier electrodes that it covers in part. */
  std::vector<std::string> covered;
};
} // namespace mmm

#endif
