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
#include "report/PageSections.h"

#include "report/CutDrawing.h"
#include "report/HTML.h"
#include "report/LabelLook.h"

namespace mmm
{
namespace
{
std::string
Layer(const char * name, const char * text)
{
  return std::string("<label><input type=\"checkbox\" checked=\"checked\" data-layer=\"") + name + "\"/> " + text +
         "</label>\n";
}

/** Which layers and labels are shown; boxes to check appear with the script that obeys them. */
std::string
MakeLegend(const std::set<int> & labels, const LabelTable & table, bool hasTetrahedra)
{
  std::string legend = "<div class=\"layers\" hidden=\"hidden\">" + Layer("voxels", "voxels") +
                       (hasTetrahedra ? Layer("mesh", "mesh") : "") + Layer("edges", "edges") +
                       "<span class=\"hint\">Click a cut, then zoom by the wheel or the keys + and \xE2\x88\x92, and "
                       "move it by dragging or the arrow keys.</span></div>\n<ul class=\"legend\">\n";
  for (const int label : labels)
  {
    legend += "<li><label><input type=\"checkbox\" checked=\"checked\" hidden=\"hidden\" data-show=\"" +
              std::to_string(label) + "\"/> " + LabelHTML(label, table) + "</label></li>\n";
  }
  return legend + "</ul>\n";
}
} // namespace

std::string
MakeCutSection(const itk::MeshFacts & facts, const itk::MeshPageDetails & details)
{
  CutSubject subject{ &facts, &details, {}, LabelsOfPage(facts) };
  subject.points = subject.HasTetrahedra() ? ToContinuousIndices(*facts.tetrahedra, *facts.image)
                                           : ToContinuousIndices(*facts.surface, *facts.image);
  if (subject.points.empty())
  {
    return SectionHTML("cuts", "Cuts", ParagraphHTML("The mesh is empty."));
  }
  std::string figures;
  for (const CutFrame & frame : MakeCutFrames(*facts.image, subject.points))
  {
    figures += DrawCut(frame, subject);
  }
  return SectionHTML("cuts",
                     "Cuts",
                     MakeLegend(subject.labels, details.labels, subject.HasTetrahedra()) + "<div class=\"cuts\">\n" +
                       figures + "</div>\n");
}
} // namespace mmm
