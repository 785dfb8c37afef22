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
#include "itkMeshPage.h"

#include "itkLabelImageToTetrahedralMeshFilter.h"
#include "report/CutFrame.h"
#include "support/TestLabelImages.h"
#include "support/TestTetrahedra.h"

#include "itksys/SystemTools.hxx"

// The header of ITK's own or the system's expat: ITK installs the first name from version 6 on.
#if __has_include("itk_expat.h")
#  include "itk_expat.h"
#else
#  include "expat.h"
#endif

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace
{
using LabelImage = itk::Image<short, 3>;
using Filter = itk::LabelImageToTetrahedralMeshFilter<LabelImage>;

/** A ball of labels 1 and 2 that is meshed. */
Filter::Pointer
MeshHalves(bool surfaceOnly = false)
{
  const auto image = mmmtest::MakeHalves<LabelImage>(14, 5.0);
  // the mesh must not be needed to find the image in a place of its own
  mmmtest::SetObliqueGeometry(image.GetPointer(), 1.0, false);
  const auto filter = Filter::New();
  filter->SetInput(image);
  filter->SetSurfaceOnly(surfaceOnly);
  filter->SetCompareTopology(true);
  filter->Update();
  return filter;
}

/** The page of a mesh whose stages took what they never do, and that was expected to need no memory. */
std::string
MakePage(Filter & filter, const itk::MeshPageDetails * details = nullptr)
{
  const itk::FilterReport<Filter>     report(filter);
  const std::vector<mmm::StageRecord> stages{ { "reading", 1.5, 20.0 } };
  itk::MeshFacts                      facts = report.GetFacts();
  facts.stages = &stages;
  mmm::MeshingReport meshing = *facts.meshing;
  meshing.estimate.memory = 0.0;
  facts.meshing = &meshing;
  return itk::MakeMeshPage(facts, details != nullptr ? *details : report.GetDetails());
}

/** Expects well-formed XML. */
void
ExpectWellFormed(const std::string & page)
{
  const XML_Parser parser = XML_ParserCreate(nullptr);
  EXPECT_EQ(XML_Parse(parser, page.data(), int(page.size()), 1), XML_STATUS_OK)
    << XML_ErrorString(XML_GetErrorCode(parser)) << " in line " << XML_GetCurrentLineNumber(parser);
  XML_ParserFree(parser);
}

bool
Has(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

/** The number in a page after this text. */
double
NumberAfter(const std::string & page, const std::string & text, std::size_t from = 0)
{
  const auto place = page.find(text, from);
  EXPECT_NE(place, std::string::npos) << text;
  return place == std::string::npos ? 0.0 : std::stod(page.substr(place + text.size()));
}
} // namespace

TEST(MeshPage, IsWellFormedWithAndWithoutTetrahedra)
{
  ExpectWellFormed(MakePage(*MeshHalves()));
  ExpectWellFormed(MakePage(*MeshHalves(true)));
}

TEST(MeshPage, NeedsNothingFromElsewhere)
{
  const auto page = MakePage(*MeshHalves());
  for (const char * const part : { "src=", "<link", "@import", "url(", "<img", "<iframe" })
  {
    EXPECT_FALSE(Has(page, part)) << part;
  }
  // the name of XHTML is the only address
  const auto address = page.find("://");
  EXPECT_EQ(page.find("://", address + 1), std::string::npos);
}

TEST(MeshPage, HasTheNumbersOfTheMesh)
{
  const auto filter = MeshHalves();
  const auto page = MakePage(*filter);
  EXPECT_TRUE(Has(page, "<data value=\"" + std::to_string(filter->GetOutput()->GetNumberOfCells()) + "\">"));
  EXPECT_TRUE(Has(page, "<data value=\"" + std::to_string(filter->GetSurface()->GetNumberOfCells()) + "\">"));
  EXPECT_TRUE(Has(page, "<td>on</td>") || Has(page, "<td>off</td>"));
  EXPECT_TRUE(Has(page, "<th scope=\"row\">reading</th><td class=\"n\"><data value=\"1.5\">1.50</data>"));
}

TEST(MeshPage, AreasOfCutsAreThoseOfTheImage)
{
  const auto page = MakePage(*MeshHalves());
  for (const char * const cut : { "id=\"axial\"", "id=\"coronal\"", "id=\"sagittal\"" })
  {
    const auto  begin = page.find(cut);
    const auto  table = page.find("<caption>Areas in this cut", begin);
    double      mesh = 0.0;
    double      voxels = 0.0;
    std::size_t at = table;
    for (const char * const label : { ">1</th>", ">2</th>" })
    {
      at = page.find(label, at);
      ASSERT_NE(at, std::string::npos);
      const auto second = page.find("</td>", at);
      mesh += NumberAfter(page, "<data value=\"", at);
      voxels += NumberAfter(page, "<data value=\"", second);
    }
    // voxels of 1 mm, and a ball of radius 5 that is cut half a voxel off its center
    EXPECT_NEAR(voxels, 78.5, 8.0) << cut;
    EXPECT_NEAR(mesh, voxels, 0.08 * voxels) << cut;
  }
}

TEST(MeshPage, TextsAreEscaped)
{
  const auto           filter = MeshHalves();
  itk::MeshPageDetails details;
  details.title = "<a&b>.nrrd";
  details.input = { { "<name>", "\"value\"\xFF" } };
  details.warnings = { "1 < 2 & 3" };
  details.labels[1].name = "</title><script>alert(1)</script>";
  details.json = "{\n  \"file\": \"</script><!--&\"\n}\n";
  const auto page = MakePage(*filter, &details);
  ExpectWellFormed(page);
  EXPECT_TRUE(Has(page, "<h1>Mesh of &lt;a&amp;b&gt;.nrrd</h1>"));
  EXPECT_TRUE(Has(page, "<li>1 &lt; 2 &amp; 3</li>"));
  EXPECT_TRUE(Has(page, "{\"file\": \"\\u003c/script\\u003e\\u003c!--\\u0026\"}"));
  EXPECT_FALSE(Has(page, "<script>alert"));
}

TEST(MeshPage, IsTheSameForAnyNumberOfThreads)
{
  std::string pages[2];
  for (const int threads : { 1, 3 })
  {
    const mmmtest::ThreadCount count(threads);
    pages[threads / 2] = MakePage(*MeshHalves());
  }
  EXPECT_EQ(pages[0], pages[1]);
}

TEST(MeshPage, SaysWhichEdgesOfALargeMeshAreNotDrawn)
{
  mmm::Grid grid;
  grid.size = { { 200, 200, 3 } };
  const auto             tetrahedra = itk::LabelTetrahedralMesh::New();
  itk::TetrahedronArrays arrays;
  for (const auto & node : mmmtest::MakeNodes(grid))
  {
    arrays.points.emplace_back();
    std::copy_n(node.data(), 3, arrays.points.back().GetDataPointer());
  }
  arrays.tetrahedra = mmmtest::MakeFreudenthalTetrahedra(grid);
  arrays.labels.assign(arrays.tetrahedra.size(), 1);
  itk::FillMesh(arrays, tetrahedra.GetPointer());
  const auto                      filter = MeshHalves();
  const itk::FilterReport<Filter> report(*filter);
  itk::MeshFacts                  facts = report.GetFacts();
  const auto                      image = mmmtest::MakeBall<LabelImage>(8, 2.0);
  facts.tetrahedra = tetrahedra;
  facts.image = image;
  const auto page = itk::MakeMeshPage(facts, {});
  EXPECT_TRUE(Has(page, " mm are not drawn, to keep the page small"));
  EXPECT_LT(page.size(), 5000000u);
  EXPECT_FALSE(Has(MakePage(*filter), "are not drawn"));
}

TEST(MeshPage, CutsAreLookedAtFromTheSamePlaceWhateverTheImagesAxes)
{
  // image axes that run to the front, the head and the left
  const auto                image = LabelImage::New();
  LabelImage::DirectionType direction;
  direction.Fill(0.0);
  direction[1][0] = -1.0;
  direction[2][1] = 1.0;
  direction[0][2] = 1.0;
  image->SetDirection(direction);
  const auto frames = mmm::MakeCutFrames(*image, { mmm::Vector(0, 0, 0), mmm::Vector(10, 20, 31) });
  EXPECT_EQ(frames[0].name, "Axial");
  EXPECT_EQ(frames[0].plane.normal, 1);
  EXPECT_EQ(frames[0].layer, 10);
  EXPECT_EQ(frames[0].sides, (std::array<char, 4>{ { 'R', 'L', 'A', 'P' } }));
  EXPECT_EQ(frames[1].sides, (std::array<char, 4>{ { 'R', 'L', 'S', 'I' } }));
  EXPECT_EQ(frames[2].sides, (std::array<char, 4>{ { 'A', 'P', 'S', 'I' } }));
  // to the left of the patient, and to the back
  const auto & axial = frames[0];
  const auto   a = axial.ToDrawing({ { 5.0, 5.0 } });
  EXPECT_EQ(axial.plane.along, (std::array<int, 2>{ { 2, 0 } }));
  EXPECT_EQ(axial.ToDrawing({ { 6.0, 5.0 } }), (mmm::SvgPoint{ { a[0] + 100, a[1] } }));
  EXPECT_EQ(axial.ToDrawing({ { 5.0, 6.0 } }), (mmm::SvgPoint{ { a[0], a[1] - 100 } }));
}

TEST(MeshPage, FilterWritesAPageOrJsonByTheName)
{
  const auto        filter = MeshHalves();
  const std::string name = testing::TempDir() + "mesh-page-test";
  for (const char * const extension : { ".html", ".json" })
  {
    filter->WriteReport(name + extension);
    std::ifstream     file(name + extension, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(text.rfind(std::string(extension) == ".html" ? "<!DOCTYPE html>" : "{", 0), 0u);
    itksys::SystemTools::RemoveFile(name + extension);
  }
  EXPECT_TRUE(itk::IsMeshPage("a.b/C.HTM"));
  EXPECT_FALSE(itk::IsMeshPage("html"));
}

TEST(MeshPage, FilterHasNoReportBeforeUpdate)
{
  mmmtest::ExpectException([] { Filter::New()->WriteReport("never.html"); }, "Call Update() first");
}
