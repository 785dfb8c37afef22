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
#include "itk/ReportTranslation.h"

#include "base/Points.h"

#include "itkMatrix.h"
#include "vnl/vnl_det.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mmm
{
namespace
{
void
Translate(const GridGeometry & geometry, MeshingPlace & place)
{
  place.position = geometry.ToPhysicalPoint(ToVector(place.position));
}

void
Translate(const GridGeometry & geometry, const InterfaceLabels & labels, std::vector<MeshingPlace> & places)
{
  for (MeshingPlace & place : places)
  {
    Translate(geometry, place);
    place.labels = labels.OfMaterials(place.labels);
  }
}

/** By label and in physical space instead of by material and in the grid's. */
void
Translate(const GridGeometry & geometry, const InterfaceLabels & labels, std::map<int, double> & volumes)
{
  const auto            origin = geometry.ToPhysicalPoint(Vector::Zero());
  itk::Matrix<double>   axes;
  std::map<int, double> translated;
  for (int a = 0; a < 3; ++a)
  {
    const auto axis = geometry.ToPhysicalPoint(Vector::Unit(a)) - origin;
    std::copy(axis.Begin(), axis.End(), axes[a]);
  }
  const double unit = std::abs(vnl_det(axes.GetVnlMatrix()));
  for (const auto & [material, volume] : volumes)
  {
    translated[labels.OfMaterial(Material(material))] = unit * volume;
  }
  volumes.swap(translated);
}
} // namespace

void
TranslateReport(const GridGeometry & geometry, const InterfaceLabels & labels, MeshingReport & report)
{
  Translate(geometry, labels, report.links.left);
  Translate(geometry, labels, report.inconsistentTriangles);
  Translate(geometry, labels, report.topology.cancelling);
  for (TopologyPlace & difference : report.topology.differences)
  {
    Translate(geometry, difference.place);
    for (int & label : difference.place.labels)
    {
      label = labels.OfMaterial(Material(label)); // not in order of the labels: each has its change
    }
  }
  for (LabelTopology & topology : report.topology.labels)
  {
    topology.label = labels.OfMaterial(Material(topology.label));
  }
  Translate(geometry, labels, report.curving.volumes);
}
} // namespace mmm
