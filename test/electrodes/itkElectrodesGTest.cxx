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
// Electrodes and implants as exact shapes on top of a label image, in LabelImageToTetrahedralMeshFilter.
#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "itkTetrahedralMeshQualityCalculator.h"
#include "support/TestLabelImages.h"
#include "support/TestMeshes.h"

#include <cmath>
#include <map>
#include <set>

namespace
{
using mmm::Electrode;
using mmm::ElectrodeShape;
using mmm::Vector;
using LabelImage = itk::Image<short, 3>;
using FilterType = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

constexpr int    Size = 36;
constexpr double Radius = 14.0;
const Vector     Middle = Vector::Constant(0.5 * (Size - 1));

itk::Point<double, 3>
At(const Vector & x)
{
  itk::Point<double, 3> point;
  std::copy_n(x.data(), 3, point.GetDataPointer());
  return point;
}

Electrode
MakeDisc(const Vector & direction, double radius, double thickness = 3.0)
{
  Electrode electrode;
  electrode.name = "disc";
  electrode.label = 7;
  electrode.position = At(Middle + direction.normalized() * (Radius + 1.0));
  electrode.radius = radius;
  electrode.thickness = thickness;
  return electrode;
}

FilterType::Pointer
MakeFilter(const std::vector<Electrode> & electrodes, int size = Size, double radius = Radius)
{
  const auto filter = FilterType::New();
  filter->SetInput(mmmtest::MakeBall<LabelImage>(size, radius));
  filter->SetElectrodes({ electrodes, {} });
  return filter;
}

double
CapArea(double radius)
{
  return 2.0 * EIGEN_PI * Radius * (Radius - std::sqrt(Radius * Radius - radius * radius));
}

std::map<int, double>
VolumesOf(FilterType & filter)
{
  const auto calculator = itk::TetrahedralMeshQualityCalculator<itk::LabelTetrahedralMesh>::New();
  calculator->SetMesh(filter.GetOutput());
  calculator->Compute();
  EXPECT_GT(calculator->GetReport().tetrahedra.smallestAngle.minimum, 10.0);
  std::map<int, double> volumes;
  for (const auto & label : calculator->GetReport().labels)
  {
    volumes[label.label] = label.tetrahedra.volume;
    EXPECT_EQ(label.openEdges, 0u);
  }
  return volumes;
}

/** Points where three labels meet. */
std::vector<Vector>
Junction(FilterType & filter, const std::set<int> & labels)
{
  const auto *               surface = filter.GetSurface();
  const auto                 points = mmmtest::PointsOf(surface);
  const auto                 triangles = mmmtest::CellsOf<3>(surface);
  std::vector<std::set<int>> around(points.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto & sides = surface->GetCellData()->ElementAt(t);
    for (const auto corner : triangles[t])
    {
      around[corner].insert({ sides[0], sides[1] });
    }
  }
  std::vector<Vector> found;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    if (around[n] == labels)
    {
      found.push_back(points[n]);
    }
  }
  return found;
}
} // namespace

TEST(Electrodes, DiscsHaveTheirContactAreaAndRim)
{
  const Vector direction(0.3, -0.5, 1.0);
  const auto   filter = MakeFilter({ MakeDisc(direction, 5.0) });
  filter->Update();
  ASSERT_EQ(filter->GetElectrodeReports().size(), 1u);
  const mmm::ElectrodeReport & report = filter->GetElectrodeReports().front();
  EXPECT_NEAR(report.projection, 1.0, 0.15);
  EXPECT_NEAR(report.expectedArea / CapArea(5.0), 1.0, 0.01);
  EXPECT_NEAR(report.contactArea / report.expectedArea, 1.0, 0.01);

  const auto   rim = Junction(*filter, { 0, 1, 7 });
  const Vector axis = direction.normalized();
  double       squares = 0.0;
  ASSERT_GT(rim.size(), 15u);
  for (const Vector & x : rim)
  {
    squares += std::pow((x - Middle).cross(axis).norm() - 5.0, 2);
  }
  EXPECT_LT(std::sqrt(squares / rim.size()), 0.06);
  VolumesOf(*filter);
}

TEST(Electrodes, LeaveTheTissuesAsTheyAre)
{
  const auto with = MakeFilter({ MakeDisc({ 1.0, 0.2, 0.1 }, 5.0), MakeDisc({ -1.0, 0.2, 0.1 }, 4.0) });
  with->Update();
  const auto without = MakeFilter({});
  without->Update();
  EXPECT_NEAR(VolumesOf(*with).at(1) / VolumesOf(*without).at(1), 1.0, 0.002);
  EXPECT_EQ(with->GetElectrodeReports().size(), 2u);
  EXPECT_TRUE(without->GetElectrodeReports().empty());
}

TEST(Electrodes, GelIsBetweenThemAndTheSkin)
{
  Electrode disc = MakeDisc({ 0.0, 1.0, 0.3 }, 5.0, 2.0);
  disc.gel = { "gel", 8, 2.0 };
  const auto filter = MakeFilter({ disc });
  filter->Update();
  const mmm::ElectrodeReport & report = filter->GetElectrodeReports().front();
  EXPECT_NEAR(report.expectedArea / (EIGEN_PI * 25.0), 1.0, 0.01);
  EXPECT_NEAR(report.contactArea / report.expectedArea, 1.0, 0.015);
  EXPECT_NEAR(report.gelContactArea / CapArea(5.0), 1.0, 0.015);
  EXPECT_TRUE(Junction(*filter, { 0, 1, 7 }).empty());
  EXPECT_EQ(VolumesOf(*filter).size(), 3u);
}

TEST(Electrodes, RingsAndRectanglesHaveTheirContactArea)
{
  Electrode ring = MakeDisc({ 1.0, 0.0, 0.2 }, 7.0);
  ring.shape = ElectrodeShape::Ring;
  ring.innerRadius = 4.0;
  ring.thickness = 4.0;
  Electrode pad = MakeDisc({ -1.0, 0.3, 0.2 }, 0.0, 2.5);
  pad.shape = ElectrodeShape::Rectangle;
  pad.size = { { 12.0, 8.0, 0.0 } };
  pad.label = 9;
  const auto filter = MakeFilter({ ring, pad });
  filter->Update();
  const auto & reports = filter->GetElectrodeReports();
  EXPECT_NEAR(reports[0].expectedArea / (CapArea(7.0) - CapArea(4.0)), 1.0, 0.015);
  EXPECT_NEAR(reports[0].contactArea / reports[0].expectedArea, 1.0, 0.015);
  EXPECT_NEAR(reports[1].contactArea / reports[1].expectedArea, 1.0, 0.025);
  // the pad follows the skin: all of its top is as far from it
  const auto * surface = filter->GetSurface();
  const auto   points = mmmtest::PointsOf(surface);
  const auto   triangles = mmmtest::CellsOf<3>(surface);
  double       highest = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const bool isOfPad = surface->GetCellData()->ElementAt(t)[1] == 9;
    highest = isOfPad ? std::max(highest, (points[triangles[t][0]] - Middle).norm()) : highest;
  }
  EXPECT_NEAR(highest, Radius + 2.5, 0.4);
}

TEST(Electrodes, ImplantsHideWhatIsThere)
{
  Electrode ball;
  ball.name = "ball";
  ball.label = 3;
  ball.shape = ElectrodeShape::Sphere;
  ball.position = At(Middle + Vector(5.0, 0.0, 0.0));
  ball.radius = 4.0;
  Electrode lead = ball;
  lead.label = 4;
  lead.shape = ElectrodeShape::Cylinder;
  lead.position = At(Middle + Vector(-5.0, -6.0, 1.0));
  lead.end = At(Middle + Vector(-4.0, 6.0, -2.0));
  lead.radius = 2.0;
  Electrode box = ball;
  box.label = 5;
  box.shape = ElectrodeShape::Box;
  box.position = At(Middle + Vector(0.0, 0.0, 8.0));
  box.size = { { 6.0, 5.0, 4.0 } };
  const auto filter = MakeFilter({ ball, lead, box });
  filter->Update();
  auto volumes = VolumesOf(*filter);
  EXPECT_NEAR(volumes[3] / (4.0 / 3.0 * EIGEN_PI * 64.0), 1.0, 0.02);
  EXPECT_NEAR(volumes[4] / (EIGEN_PI * 4.0 * std::sqrt(154.0)), 1.0, 0.03);
  EXPECT_NEAR(volumes[5] / 120.0, 1.0, 0.15);
  EXPECT_NEAR(filter->GetElectrodeReports()[0].expectedArea, 4.0 * EIGEN_PI * 16.0, 1e-6);
  EXPECT_TRUE(std::isnan(filter->GetElectrodeReports()[0].projection));
}

TEST(Electrodes, ContactsOfALeadHaveTheirAreaAndDoNotTouch)
{
  constexpr double spacing = 0.6;
  const auto       image = mmmtest::MakeHalves<LabelImage>(40, 15.0);
  const double     voxel[] = { spacing, spacing, spacing };
  image->SetSpacing(voxel);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  const auto dimensions = mmm::LeadDimensionsOf("Medtronic 3389");
  auto       list = mmm::MakeLead("lead", 51, 50, At({ 11.0, 12.0, 7.0 }), At({ 13.0, 9.0, 19.0 }), dimensions);
  // the shafts have a label in common
  const auto other = mmm::MakeLead("other", 61, 50, At({ 16.0, 14.0, 8.0 }), At({ 17.0, 12.0, 19.0 }), dimensions);
  list.insert(list.end(), other.begin(), other.end());
  filter->SetElectrodes({ list, {} });
  filter->Update();
  const auto   volumes = VolumesOf(*filter);
  const auto & reports = filter->GetElectrodeReports();
  ASSERT_EQ(reports.size(), 10u);
  mmm::ElectrodeReport shafts;
  shafts.contactArea = 0.0;
  shafts.expectedArea = 0.0;
  for (const auto & report : reports)
  {
    EXPECT_TRUE(report.covered.empty()) << report.name;
    if (report.label == 50)
    {
      shafts.contactArea += report.contactArea;
      shafts.expectedArea += report.expectedArea;
    }
    else
    {
      EXPECT_NEAR(report.contactArea / report.expectedArea, 1.0, 0.03) << report.name;
    }
  }
  EXPECT_NEAR(shafts.contactArea / shafts.expectedArea, 1.0, 0.03);
  EXPECT_NEAR(reports[1].expectedArea, EIGEN_PI * 1.27 * 1.5, 1e-9);
  const auto * surface = filter->GetSurface();
  for (itk::SizeValueType t = 0; t < surface->GetNumberOfCells(); ++t)
  {
    const auto & sides = surface->GetCellData()->ElementAt(t);
    EXPECT_FALSE(sides[0] > 50 && sides[1] > 50) << sides;
  }
}

TEST(Electrodes, LeadsThatCrossSaySoOnce)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(40, 15.0);
  image->SetSpacing(std::vector<double>(3, 0.6).data());
  const auto filter = FilterType::New();
  filter->SetInput(image);
  const auto dimensions = mmm::LeadDimensionsOf("Medtronic 3389");
  auto       list = mmm::MakeLead("one", 51, 50, At({ 11.0, 12.0, 7.0 }), At({ 13.0, 9.0, 19.0 }), dimensions);
  const auto other = mmm::MakeLead("other", 61, 60, At({ 7.0, 11.0, 11.0 }), At({ 18.0, 11.0, 11.0 }), dimensions);
  list.insert(list.end(), other.begin(), other.end());
  filter->SetElectrodes({ list, {} });
  filter->SetSurfaceOnly(true);
  filter->Update();
  std::vector<std::string> covered;
  for (const auto & report : filter->GetElectrodeReports())
  {
    covered.insert(covered.end(), report.covered.begin(), report.covered.end());
  }
  EXPECT_EQ(covered, std::vector<std::string>{ "one" });
}

TEST(Electrodes, CylindersThatArePartsOfAnEarlierOneAreItsContacts)
{
  Electrode shaft;
  shaft.name = "shaft";
  shaft.label = 3;
  shaft.shape = ElectrodeShape::Cylinder;
  shaft.position = At(Middle + Vector(-1.0, -2.0, -6.0));
  shaft.end = At(Middle + Vector(1.0, 2.0, 6.0));
  shaft.radius = 1.5;
  Electrode contact = shaft;
  contact.name = "contact";
  contact.label = 4;
  contact.position = At(Middle + Vector(-0.5, -1.0, -3.0));
  contact.end = At(Middle);
  const auto filter = MakeFilter({ shaft, contact });
  filter->Update();
  const auto & report = filter->GetElectrodeReports()[1];
  EXPECT_NEAR(report.contactArea / (2.0 * EIGEN_PI * 1.5 * std::sqrt(10.25)), 1.0, 0.03);
  EXPECT_TRUE(report.covered.empty());
}

TEST(Electrodes, ImplantsNeedNoExterior)
{
  Electrode lead;
  lead.name = "lead";
  lead.label = 4;
  lead.shape = ElectrodeShape::Cylinder;
  lead.position = At({ 12.0, 13.0, 20.0 });
  lead.end = At({ 8.0, 8.0, 12.0 });
  lead.radius = 2.0;
  const auto filter = FilterType::New();
  filter->SetInput(mmmtest::MakeImage<LabelImage>(24, 24, 24, [](int i, int, int) { return 1 + i / 12; }));
  filter->SetExteriorLabels({});
  filter->SetElectrodes({ { lead }, {} });
  filter->Update();
  const auto volumes = VolumesOf(*filter);
  EXPECT_EQ(volumes.size(), 3u); // nothing is added around the image
  EXPECT_NEAR(volumes.at(4) / (EIGEN_PI * 4.0 * std::sqrt(105.0)), 1.0, 0.03);
  filter->SetElectrodes({ { MakeDisc({ 1.0, 0.0, 0.0 }, 5.0) }, {} });
  mmmtest::ExpectException([&] { filter->Update(); }, "no label is exterior");
}

TEST(Electrodes, ThatGoBeyondTheImageExtendIt)
{
  // the ball ends a voxel before the border
  const auto      filter = MakeFilter({ MakeDisc({ 0.0, 0.0, 1.0 }, 5.0) }, 30);
  mmm::Electrodes electrodes = filter->GetElectrodes();
  electrodes.list.front().position = At({ 14.5, 14.5, 29.0 });
  filter->SetElectrodes(electrodes);
  filter->Update();
  const mmm::ElectrodeReport & report = filter->GetElectrodeReports().front();
  EXPECT_NEAR(report.contactArea / CapArea(5.0), 1.0, 0.015);
  EXPECT_GT(filter->GetMeshedRegion().GetSize(2), 30u);
  double highest = 0.0;
  for (const Vector & x : mmmtest::PointsOf(filter->GetSurface()))
  {
    highest = std::max(highest, x[2]);
  }
  EXPECT_NEAR(highest, 14.5 + Radius + 3.0, 0.3);
}

TEST(Electrodes, WithALabelInCommonHaveAreasOfTheirOwn)
{
  const auto filter = MakeFilter({ MakeDisc({ 1.0, 0.0, 0.0 }, 5.0), MakeDisc({ 0.0, 0.0, -1.0 }, 3.0) });
  filter->Update();
  const auto & reports = filter->GetElectrodeReports();
  EXPECT_NEAR(reports[0].contactArea / CapArea(5.0), 1.0, 0.015);
  EXPECT_NEAR(reports[1].contactArea / CapArea(3.0), 1.0, 0.04);
}

TEST(Electrodes, LaterOnesWinAndSaySo)
{
  Electrode later = MakeDisc({ 1.0, 0.35, 0.0 }, 4.0);
  later.label = 9;
  later.name = "later";
  const auto filter = MakeFilter({ MakeDisc({ 1.0, 0.0, 0.0 }, 4.0), later });
  filter->Update();
  const auto & reports = filter->GetElectrodeReports();
  EXPECT_TRUE(reports[0].covered.empty());
  EXPECT_EQ(reports[1].covered, std::vector<std::string>{ "disc" });
  EXPECT_LT(reports[0].contactArea, 0.8 * reports[0].expectedArea);
  EXPECT_NEAR(reports[1].contactArea / reports[1].expectedArea, 1.0, 0.03);
}

TEST(Electrodes, StandAtSitesOfThe1020System)
{
  mmm::Electrodes electrodes;
  electrodes.fiducials = { At(Middle - Vector(0.0, 15.0, 0.0)),
                           At(Middle + Vector(0.0, 15.0, 0.0)),
                           At(Middle + Vector(15.0, 0.0, 0.0)),
                           At(Middle - Vector(15.0, 0.0, 0.0)) };
  // on a sphere they are where angles are in proportion
  const std::map<std::string, Vector> known = { { "Cz", { 0.0, 0.0, 1.0 } },
                                                { "Fz", { 0.0, -std::sin(0.2 * EIGEN_PI), std::cos(0.2 * EIGEN_PI) } },
                                                { "C3", { std::sin(0.2 * EIGEN_PI), 0.0, std::cos(0.2 * EIGEN_PI) } },
                                                { "POz",
                                                  { 0.0, std::sin(0.3 * EIGEN_PI), std::cos(0.3 * EIGEN_PI) } } };
  for (const auto & entry : known)
  {
    electrodes.list.push_back(MakeDisc({ 1.0, 0.0, 0.0 }, 2.0, 2.0));
    electrodes.list.back().site = entry.first;
  }
  const auto filter = MakeFilter({});
  filter->SetElectrodes(electrodes);
  filter->SetSurfaceOnly(true);
  filter->Update();
  std::size_t n = 0;
  for (const auto & entry : known)
  {
    const Vector place(filter->GetElectrodeReports()[n++].position.GetDataPointer());
    EXPECT_LT((place - (Middle + Radius * entry.second)).norm(), 0.4) << entry.first;
  }
  electrodes.list.front().site = "Q3";
  filter->SetElectrodes(electrodes);
  mmmtest::ExpectException([&] { filter->Update(); }, ".site: 'Q3' is no site of the 10-10 system");
  electrodes.fiducials.reset();
  filter->SetElectrodes(electrodes);
  mmmtest::ExpectException([&] { filter->Update(); }, ".site: a site needs fiducials");
}

TEST(Electrodes, StandOnHeadsThatTheImageCuts)
{
  // the ball is cut on the left, on the right and above
  const Vector middle(12.5, 17.5, 17.5);
  const auto   filter = FilterType::New();
  filter->SetInput(mmmtest::MakeImage<LabelImage>(
    26, 36, 31, [&](int i, int j, int k) { return (Vector(i, j, k) - middle).norm() < Radius ? 1 : 0; }));
  mmm::Electrodes electrodes;
  electrodes.fiducials = { At(middle - Vector(0.0, 15.0, 0.0)),
                           At(middle + Vector(0.0, 15.0, 0.0)),
                           At(middle + Vector(13.0, 0.0, 0.0)),
                           At(middle - Vector(13.0, 0.0, 0.0)) };
  for (const std::string site : { "Cz", "Fz", "F3", "C4", "PO3" })
  {
    electrodes.list.push_back(MakeDisc({ 1.0, 0.0, 0.0 }, 2.0, 2.0));
    electrodes.list.back().site = site;
  }
  filter->SetElectrodes(electrodes);
  filter->SetSurfaceOnly(true);
  filter->Update();
  for (const auto & report : filter->GetElectrodeReports())
  {
    const Vector place = Vector(report.position.GetDataPointer()) - middle;
    const double beyond = std::max({ std::abs(place[0]) - 13.0, place[2] - 13.0, place.norm() - Radius });
    EXPECT_NEAR(beyond, 0.0, 0.5) << report.name;
    EXPECT_LT(report.projection, 1.0) << report.name;
    EXPECT_GT(report.contactArea, 3.0 * EIGEN_PI) << report.name;
  }
}

TEST(Electrodes, ThatLaterOnesCoverAreRefused)
{
  Electrode small;
  small.label = 3;
  small.shape = ElectrodeShape::Sphere;
  small.position = At(Middle);
  small.radius = 2.0;
  Electrode large = small;
  large.label = 4;
  large.radius = 4.0;
  const auto filter = MakeFilter({ small, large });
  mmmtest::ExpectException([&] { filter->Update(); }, "The electrode of label 3 is covered by later ones");
}

TEST(Electrodes, ThatCannotBePlacedAreRefused)
{
  const auto expect = [](const Electrode & electrode, const std::string & words) {
    const auto filter = MakeFilter({ electrode });
    mmmtest::ExpectException([&] { filter->Update(); }, words);
  };
  const Electrode good = MakeDisc({ 1.0, 0.0, 0.0 }, 5.0);
  Electrode       bad = good;
  bad.label = 1;
  expect(bad, "electrode 'disc'.label: the image has the label 1 already");
  bad.label = 0;
  expect(bad, "electrode 'disc'.label: 0 is the label of the exterior");
  bad = good;
  bad.source = "cap.json: electrodes[0]";
  bad.thickness = 1.0;
  expect(bad, "cap.json: electrodes[0].thickness: 1 mm is too small for voxels of 1 mm; it has to be 1.5 mm or more");
  bad = good;
  bad.radius = 0.5;
  expect(bad, ".radius: 0.5 mm is too small for voxels of 1 mm; it has to be 0.75 mm or more");
  bad.radius = 1e9;
  expect(bad, ".radius: 1e+09 mm is too large; it can be 500 mm at most");
  bad.radius = std::numeric_limits<double>::quiet_NaN();
  expect(bad, ".radius: nan mm is too small");
  bad = good;
  bad.position = At(Middle + Vector(100.0, 0.0, 0.0));
  expect(bad, ".position: the skin is 85");
  bad = good;
  bad.radius = 15.0;
  expect(bad, ".position: there is no skin under a part of it");
  bad = good;
  bad.gel = { "gel", 7, 0.5 };
  bad.gel->label = 8;
  expect(bad, ".gel.thickness: 0.5 mm is too small");
  bad = good;
  bad.shape = ElectrodeShape::Sphere;
  bad.position = At({ 0.0, 0.0, 0.0 });
  expect(bad, "electrode 'disc': it is not all within the image");
  bad.shape = ElectrodeShape::Cylinder;
  expect(bad, "electrode 'disc'.to: it is missing");
  bad.end = At({ 9.0, 9.0, 9.0 });
  bad.bodyLabel = 70;
  bad.radius = 2.0;
  bad.position = At(Middle);
  expect(bad, "electrode 'disc': there is no implant before it with the label 70 of its body");
}
