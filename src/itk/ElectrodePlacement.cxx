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
#include "itk/ElectrodePlacement.h"

#include "electrodes/ElectrodeSolid.h"
#include "electrodes/Skin.h"
#include "electrodes/TenTen.h"
#include "indicators/IndicatorSet.h"
#include "itk/ElectrodeChecks.h"
#include "itk/ElectrodeOverlaps.h"
#include "itk/ElectrodeSkin.h"
#include "itk/GridGeometry.h"
#include "itk/LabelDomain.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace mmm
{
namespace
{
using Point = Electrode::PointType;
using Region = itk::ImageRegion<3>;

/** Edges around a circle that are asked for, and the least length of them, in voxels. */
constexpr double EdgesAround = 32.0;
constexpr double LeastSize = 0.4;
/** Voxels around an electrode, for the band of its distance. */
constexpr int Margin = 4;

/** How long edges of a rim are where a size is asked for, both in voxels, as measured for sizes of 0.4 to 1.2. */
double
EdgeOf(double size)
{
  return size > 0.0 ? std::hypot(1.2 * size, 0.6) : 0.0;
}

class ElectrodePlacer
{
public:
  ElectrodePlacer(const LabelImage *                        labels,
                  const std::vector<int> &                  exteriorLabels,
                  const LabelSizeRules &                    sizes,
                  const std::optional<ElectrodeFiducials> & fiducials)
    : m_Labels(labels)
    , m_Exterior(exteriorLabels)
    , m_Asked(sizes)
    , m_Geometry(labels, WithExteriorAround(labels->GetLargestPossibleRegion()))
    , m_Checks(labels, exteriorLabels, m_Geometry.GetUnit() * m_Geometry.GetGrid().spacing.maxCoeff())
    , m_Fiducials(fiducials)
  {
    m_Placed.region = labels->GetLargestPossibleRegion();
    m_Hidden = exteriorLabels;
  }

  void
  Place(const Electrode & electrode)
  {
    m_Checks.Verify(electrode);
    this->AskForSize(electrode);
    m_Placed.reports.emplace_back();
    m_Placed.reports.back().name = electrode.name;
    m_Placed.reports.back().label = electrode.label;
    electrode.IsOnSkin() ? this->PlaceOnSkin(electrode) : this->PlaceImplant(electrode);
    for (const int label : LabelsOf(electrode))
    {
      m_Hidden.push_back(label);
    }
  }

  PlacedElectrodes
  Take()
  {
    return std::move(m_Placed);
  }

private:
  ElectrodeLengths
  LengthsOf(const Electrode & electrode) const
  {
    const double unit = m_Geometry.GetUnit();
    return { electrode.shape,
             electrode.radius / unit,
             electrode.innerRadius / unit,
             { electrode.size[0] / unit, electrode.size[1] / unit, electrode.size[2] / unit },
             electrode.thickness / unit,
             electrode.gel ? electrode.gel->thickness / unit : 0.0,
             electrode.isRounded,
             electrode.bodyLabel.has_value(),
             EdgeOf(this->SizeOf(electrode) / unit) };
  }

  /** In mm; 0 where users ask for something else, and of what is not round. */
  double
  SizeOf(const Electrode & electrode) const
  {
    const bool isRound = electrode.shape == ElectrodeShape::Disc || electrode.shape == ElectrodeShape::Ring ||
                         electrode.shape == ElectrodeShape::Cylinder;
    if (!isRound || m_Asked.count(electrode.label) != 0)
    {
      return 0.0;
    }
    const auto   known = m_Placed.sizes.find(electrode.label);
    const double size =
      std::max(double(2.0 * EIGEN_PI) * electrode.radius / EdgesAround, LeastSize * m_Geometry.GetUnit());
    return known == m_Placed.sizes.end() ? size : std::min(size, known->second.maximumSize);
  }

  void
  AskForSize(const Electrode & electrode)
  {
    const double size = this->SizeOf(electrode);
    for (const int label : LabelsOf(electrode))
    {
      if (size > 0.0 && m_Asked.count(label) == 0)
      {
        m_Placed.sizes[label].maximumSize = size;
      }
    }
  }

  const Skin &
  GetSkin()
  {
    if (!m_Skin)
    {
      m_Skin = MakeSkin(*m_Labels, m_Exterior, m_Geometry);
    }
    return *m_Skin;
  }

  /** In the grid. */
  Vector
  PlaceOf(const Electrode & electrode)
  {
    if (electrode.site.empty())
    {
      return m_Geometry.ToGridPoint(electrode.position);
    }
    if (!m_Fiducials)
    {
      ElectrodeChecks::Fail(
        electrode, "site", "a site needs fiducials: nasion, inion, left and right; or give a position instead");
    }
    if (!m_Sites)
    {
      const auto project = [this](const Point & point) {
        return this->GetSkin().Project(m_Geometry.ToGridPoint(point));
      };
      const auto up =
        itk::CrossProduct(m_Fiducials->left - m_Fiducials->right, m_Fiducials->inion - m_Fiducials->nasion);
      m_Sites = std::make_unique<TenTen>(this->GetSkin(),
                                         project(m_Fiducials->nasion),
                                         project(m_Fiducials->inion),
                                         project(m_Fiducials->left),
                                         project(m_Fiducials->right),
                                         m_Geometry.ToGridPoint(m_Fiducials->nasion + up) -
                                           m_Geometry.ToGridPoint(m_Fiducials->nasion));
    }
    const auto place = m_Sites->Find(electrode.site);
    if (!place)
    {
      ElectrodeChecks::Fail(
        electrode,
        "site",
        '\'',
        electrode.site,
        "' is no site of the 10-10 system, such as Fp1, AFz, C3 or TP8; upper and lower case count");
    }
    return *place;
  }

  void
  PlaceOnSkin(const Electrode & electrode)
  {
    ElectrodeReport & report = m_Placed.reports.back();
    const Vector      place = this->PlaceOf(electrode);
    const Vector      foot = this->GetSkin().Project(place);
    report.position = m_Geometry.ToPhysicalPoint(foot);
    report.projection = (place - foot).norm() * m_Geometry.GetUnit();
    ElectrodeChecks::VerifyProjection(electrode, report.projection);
    // up, if nothing else is asked for
    Point towards = report.position;
    towards[2] += 1000.0;
    const SkinFrame frame =
      MakeSkinFrame(this->GetSkin(), foot, m_Geometry.ToGridPoint(electrode.end ? *electrode.end : towards));
    const ElectrodeOnSkin placed(this->LengthsOf(electrode), this->GetSkin(), frame);
    if (!placed.IsComplete())
    {
      ElectrodeChecks::Fail(
        electrode,
        "position",
        "there is no skin under a part of it, which falls away or overhangs there; choose another place or make it "
        "smaller");
    }
    m_Checks.VerifyBulge(electrode, "thickness", placed.LeastThickness() * m_Geometry.GetUnit());

    const auto body = placed.Body();
    report.expectedArea = this->ToArea(body.area);
    this->Add(electrode, body, electrode.label, m_Hidden);
    if (electrode.gel)
    {
      m_Checks.VerifyBulge(electrode, "gel.thickness", placed.LeastGelThickness() * m_Geometry.GetUnit());
      const auto gel = placed.Gel();
      report.expectedGelArea = this->ToArea(gel.area);
      this->Add(electrode, gel, electrode.gel->label, { electrode.label });
    }
  }

  void
  PlaceImplant(const Electrode & electrode)
  {
    ElectrodeLengths lengths = this->LengthsOf(electrode);
    const auto       toGrid = [this](const Point & point) { return m_Geometry.ToGridPoint(point); };
    SkinFrame        frame{ toGrid(electrode.position), {} };
    if (electrode.shape == ElectrodeShape::Cylinder)
    {
      const Vector along = toGrid(*electrode.end) - frame.origin;
      lengths.size[0] = along.norm();
      m_Checks.VerifyLength(
        electrode, "to", lengths.size[0] * m_Geometry.GetUnit(), ElectrodeChecks::LeastVoxelsOf(electrode));
      frame.origin += 0.5 * along;
      frame.axes[0] = along.normalized();
      frame.axes[1] = frame.axes[0].unitOrthogonal();
      frame.axes[2] = frame.axes[0].cross(frame.axes[1]);
    }
    else
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        Point beside = electrode.position;
        beside[axis] += m_Geometry.GetUnit();
        frame.axes[axis] = (toGrid(beside) - frame.origin).normalized();
      }
    }
    const auto        solid = MakeImplant(lengths, frame);
    ElectrodeReport & report = m_Placed.reports.back();
    report.position = m_Geometry.ToPhysicalPoint(frame.origin);
    report.expectedArea = this->ToArea(solid.area);
    if (!m_Placed.region.IsInside(this->RegionOf(solid, 0)))
    {
      ElectrodeChecks::Fail(electrode, "", "it is not all within the image");
    }
    std::vector<int> hidden;
    if (electrode.bodyLabel)
    {
      this->BodyOf(electrode).expectedArea -= report.expectedArea;
      hidden.push_back(*electrode.bodyLabel);
    }
    this->Add(electrode, solid, electrode.label, hidden);
  }

  /** What is told of the implant that a contact is a part of, the last one before it with that label. */
  ElectrodeReport &
  BodyOf(const Electrode & contact)
  {
    const auto found = std::find_if(std::next(m_Placed.reports.rbegin()),
                                    m_Placed.reports.rend(),
                                    [&](const ElectrodeReport & report) { return report.label == *contact.bodyLabel; });
    if (found == m_Placed.reports.rend())
    {
      ElectrodeChecks::Fail(
        contact, "", "there is no implant before it with the label ", *contact.bodyLabel, " of its body");
    }
    return *found;
  }

  double
  ToArea(double area) const
  {
    return area * m_Geometry.GetUnit() * m_Geometry.GetUnit();
  }

  /** The voxels around a solid, in the image's indices. */
  Region
  RegionOf(const ElectrodeSolid & solid, int margin) const
  {
    const auto & spacing = m_Geometry.GetGrid().spacing;
    Region       region;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto first = m_Geometry.GetRegion().GetIndex(axis);
      const auto lower = first + std::lround(std::floor(solid.lower[axis] / spacing[axis])) - margin;
      const auto upper = first + std::lround(std::ceil(solid.upper[axis] / spacing[axis])) + margin;
      region.SetIndex(axis, lower);
      region.SetSize(axis, static_cast<itk::SizeValueType>(upper - lower + 1));
    }
    return region;
  }

  void
  Add(const Electrode & electrode, const ElectrodeSolid & solid, int label, const std::vector<int> & hidden)
  {
    const Region region = this->RegionOf(solid, Margin);
    const auto   image = FloatImage::New();
    image->CopyInformation(m_Labels);
    image->SetRegions(region);
    image->Allocate();
    const double unit = m_Geometry.GetUnit();
    const Grid & grid = m_Geometry.GetGrid();
    const auto & origin = m_Geometry.GetRegion().GetIndex();
    bool         isThere = false;
    for (itk::ImageRegionIteratorWithIndex<FloatImage> it(image, region); !it.IsAtEnd(); ++it)
    {
      const auto & at = it.GetIndex();
      const double distance =
        solid.distance(grid.Position({ { int(at[0] - origin[0]), int(at[1] - origin[1]), int(at[2] - origin[2]) } }));
      it.Set(static_cast<float>(std::max(-IndicatorBandWidth, std::min(distance, IndicatorBandWidth)) * unit));
      isThere = isThere || distance > 0.0;
    }
    if (!isThere)
    {
      ElectrodeChecks::Fail(electrode, "", "no voxel's centre is within it; the image needs smaller voxels");
    }
    m_Placed.surfaces.distances.push_back(image.GetPointer());
    m_Placed.surfaces.labels.push_back(label);
    m_Placed.surfaces.replaced.push_back(hidden);
    if (electrode.IsOnSkin())
    {
      this->Grow(region);
    }
  }

  void
  Grow(const Region & region)
  {
    auto lower = m_Placed.region.GetIndex();
    auto upper = m_Placed.region.GetUpperIndex();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = std::min(lower[axis], region.GetIndex(axis));
      upper[axis] = std::max(upper[axis], region.GetUpperIndex()[axis]);
    }
    m_Placed.region.SetIndex(lower);
    m_Placed.region.SetUpperIndex(upper);
  }

  const LabelImage *                      m_Labels;
  const std::vector<int> &                m_Exterior;
  const LabelSizeRules &                  m_Asked;
  const GridGeometry                      m_Geometry;
  const ElectrodeChecks                   m_Checks;
  const std::optional<ElectrodeFiducials> m_Fiducials;
  std::unique_ptr<Skin>                   m_Skin;
  std::unique_ptr<TenTen>                 m_Sites;
  PlacedElectrodes                        m_Placed;
  /** Labels that the next one on the skin may hide: exterior and earlier ones. */
  std::vector<int> m_Hidden;
};
} // namespace

PlacedElectrodes
PlaceElectrodes(const Electrodes &       electrodes,
                const LabelImage *       labels,
                const std::vector<int> & exteriorLabels,
                const LabelSizeRules &   sizes)
{
  const auto      list = WithBodies(electrodes.list);
  ElectrodePlacer placer(labels, exteriorLabels, sizes, electrodes.fiducials);
  for (const Electrode & electrode : list)
  {
    placer.Place(electrode);
  }
  PlacedElectrodes placed = placer.Take();
  ReportCovered(list, placed);
  return placed;
}
} // namespace mmm
