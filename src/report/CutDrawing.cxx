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
#include "report/CutDrawing.h"

#include "report/HTML.h"
#include "report/LabelLook.h"
#include "report/PlanarLines.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace mmm
{
namespace
{
/** An edge takes 7 to 10 bytes, so that three cuts take less than 4.5 MB. */
constexpr std::size_t MostEdges = 150000;

/** What is cut of the mesh. */
struct Cut
{
  PlanarCells cells;
  PlanarEdges edges;
  /** Edges that are left out, and the length in mm below which they are. */
  std::size_t leftOut{ 0 };
  double      shortest{ 0.0 };
};

/** Keeps the longest edges, if there are too many. */
void
LimitEdges(const CutFrame & frame, Cut & cut)
{
  auto & edges = cut.edges.edges;
  if (edges.size() <= MostEdges)
  {
    return;
  }
  const auto length = [&](const PlanarEdge & edge) {
    const SvgPoint a = frame.ToDrawing(cut.edges.points[edge[0]]);
    const SvgPoint b = frame.ToDrawing(cut.edges.points[edge[1]]);
    return std::hypot(double(b[0] - a[0]), double(b[1] - a[1]));
  };
  std::vector<double> lengths;
  for (const PlanarEdge & edge : edges)
  {
    lengths.push_back(length(edge));
  }
  const auto shortest = lengths.begin() + std::ptrdiff_t(edges.size() - MostEdges);
  std::nth_element(lengths.begin(), shortest, lengths.end());
  const auto end =
    std::remove_if(edges.begin(), edges.end(), [&](const PlanarEdge & edge) { return length(edge) <= *shortest; });
  cut.leftOut = std::size_t(edges.end() - end);
  cut.shortest = *shortest * frame.unit;
  edges.erase(end, edges.end());
}

Cut
CutMesh(const CutFrame & frame, const CutSubject & subject)
{
  Cut cut;
  if (subject.HasTetrahedra())
  {
    cut.cells = CutTetrahedra(*subject.facts->tetrahedra, subject.points, frame.plane);
    cut.edges = { cut.cells.points, EdgesOf(cut.cells.cells) };
  }
  else
  {
    cut.edges = CutTriangles(*subject.facts->surface, subject.points, frame.plane);
  }
  LimitEdges(frame, cut);
  return cut;
}

/** Closed lines, or open ones, as the data of a path. */
std::string
PathData(const CutFrame &                 frame,
         const std::vector<PlanarPoint> & points,
         const std::vector<PlanarLine> &  lines,
         bool                             areClosed)
{
  SvgPath path;
  for (const PlanarLine & line : lines)
  {
    path.MoveTo(frame.ToDrawing(points[line.front()]));
    for (std::size_t p = 1; p < line.size(); ++p)
    {
      path.LineTo(frame.ToDrawing(points[line[p]]));
    }
    if (areClosed)
    {
      path.Close();
    }
  }
  return path.GetText();
}

/** A group with a path for each label. */
std::string
DrawAreas(const std::string & name, const CutFrame & frame, const PlanarCells & cells, const LabelTable & table)
{
  std::string group = "<g class=\"" + name + "\">\n";
  for (const auto & [label, lines] : OutlinesByLabel(cells.cells))
  {
    group += "<path class=\"" + LabelClass(label) + "\" data-label=\"" + std::to_string(label) + "\" d=\"" +
             PathData(frame, cells.points, lines, true) + "\"><title>" + EscapedHTML(LabelText(label, table)) +
             "</title></path>\n";
  }
  return group + "</g>\n";
}

std::string
AreaTable(const CutFrame & frame, const CutSubject & subject, const PlanarCells & mesh, const PlanarCells & voxels)
{
  const auto areas = AreasByLabel(mesh);
  const auto areasOfVoxels = AreasByLabel(voxels);
  HTMLTable  table("Areas in this cut", { { "Label", false }, { "Mesh (mm&#178;)" }, { "Voxels (mm&#178;)" } });
  for (const int label : subject.labels)
  {
    const auto find = [&](const std::map<int, double> & values) {
      const auto value = values.find(label);
      return NumberHTML(value == values.end() ? 0.0 : frame.voxelArea * value->second, 1);
    };
    table.AddRow({ LabelHTML(label, subject.details->labels), find(areas), find(areasOfVoxels) });
  }
  return DetailsHTML("Areas in this cut", table.ToText());
}

std::string
Describe(const Cut & cut)
{
  std::string text = cut.cells.cells.empty() ? CountHTML(cut.edges.edges.size()) + " segments of the surface"
                                             : CountHTML(cut.cells.cells.size()) + " tetrahedra are cut";
  if (cut.leftOut > 0)
  {
    text += "; " + CountHTML(cut.leftOut) + " edges of at most " + NumberHTML(cut.shortest, 2) +
            " mm are not drawn, to keep the page small";
  }
  return text;
}

std::string
Button(const char * action, const char * sign, const char * title)
{
  return std::string("<button type=\"button\" data-do=\"") + action + "\" title=\"" + title + "\" aria-label=\"" +
         title + "\">" + sign + "</button>";
}

const char * const Places[4] = { "left", "right", "top", "bottom" };
} // namespace

std::string
DrawCut(const CutFrame & frame, const CutSubject & subject)
{
  std::string id = frame.name;
  id.front() = char(std::tolower(static_cast<unsigned char>(id.front())));
  const Cut         cut = CutMesh(frame, subject);
  const PlanarCells voxels =
    subject.details->labelAt
      ? CutVoxels(
          subject.details->labelAt, subject.facts->image->GetLargestPossibleRegion(), subject.labels, frame.plane)
      : PlanarCells();
  const LabelTable & table = subject.details->labels;
  const std::string  width = std::to_string(frame.size[0]);
  const std::string  height = std::to_string(frame.size[1]);
  const std::string  title = frame.name + " cut at " + frame.axis + " = " + Decimal(frame.place, 1) + " mm";

  std::string figure = "<figure class=\"cut\" id=\"" + id + "\">\n<figcaption><strong>" + title +
                       "</strong>, through layer " + std::to_string(frame.layer) + " of the image's axis " +
                       std::to_string(frame.plane.normal) + ": " + Describe(cut) + "</figcaption>\n";
  figure += "<div class=\"frame\" style=\"aspect-ratio:" + width + '/' + height + "\">\n<svg viewBox=\"0 0 " + width +
            ' ' + height + "\" role=\"img\" tabindex=\"0\" aria-labelledby=\"" + id + "-title\" aria-describedby=\"" +
            id + "-text\">\n<title id=\"" + id + "-title\">" + title + "</title>\n<desc id=\"" + id +
            "-text\">The labels of the mesh and its edges over the voxels of the image; the areas are in a table below."
            "</desc>\n";
  figure += DrawAreas("voxels", frame, voxels, table) + DrawAreas("mesh", frame, cut.cells, table);
  figure += "<path class=\"edges\" d=\"" + PathData(frame, cut.edges.points, TrailsOf(cut.edges.edges), false) +
            "\"/>\n</svg>\n";
  for (int s = 0; s < 4; ++s)
  {
    figure += std::string("<span class=\"side ") + Places[s] + "\">" + frame.sides[s] + "</span>";
  }
  figure += "\n</div>\n<div class=\"tools\" hidden=\"hidden\">" + Button("in", "+", "Zoom in") +
            Button("out", "\xE2\x88\x92", "Zoom out") + Button("whole", "1:1", "Show all") +
            Button("large", "\xE2\xA4\xA2", "Large or small") + "</div>\n";
  return figure + AreaTable(frame, subject, cut.cells, voxels) + "</figure>\n";
}
} // namespace mmm
