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

#include "itkOutputFile.h"
#include "report/HTML.h"
#include "report/LabelLook.h"
#include "report/PageSections.h"

#include "itksys/SystemTools.hxx"

#include <set>

namespace mmm
{
namespace
{
/** JSON for use in a script element, on one line: without what could end the element, and without indentation. */
std::string
EmbeddedJson(const std::string & json)
{
  std::string embedded;
  for (std::size_t c = 0; c < json.size(); ++c)
  {
    switch (json[c])
    {
      // these are in texts only, which have no ends of lines
      case '<':
        embedded += "\\u003c";
        break;
      case '>':
        embedded += "\\u003e";
        break;
      case '&':
        embedded += "\\u0026";
        break;
      case '\n':
        while (c + 1 < json.size() && json[c + 1] == ' ')
        {
          ++c;
        }
        break;
      default:
        embedded += json[c];
    }
  }
  return embedded;
}

/** Labels that the page speaks of, in the mesh or not. */
std::set<int>
LabelsWithColor(const itk::MeshFacts & facts)
{
  std::set<int> labels = LabelsOfPage(facts);
  labels.insert(facts.outsideLabel);
  labels.insert(facts.absentExteriorLabels.begin(), facts.absentExteriorLabels.end());
  for (const auto & entry : *facts.islands)
  {
    labels.insert(entry.first);
  }
  return labels;
}

/** Nothing is loaded from anywhere, and nothing is sent. */
const char * const Policy =
  "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; script-src "
  "'unsafe-inline'; img-src data:\"/>\n";

std::string
MakeHead(const itk::MeshFacts & facts, const itk::MeshPageDetails & details, const std::string & title)
{
  return "<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n" +
         std::string(Policy) + "<title>" + title + "</title>\n<style>" + PageStyle +
         LabelRules(LabelsWithColor(facts), details.labels) + "</style>\n</head>\n";
}
} // namespace
} // namespace mmm

namespace itk
{
std::string
MakeMeshPage(const MeshFacts & facts, const MeshPageDetails & details)
{
  using namespace mmm;
  const std::string title = EscapedHTML(details.title.empty() ? "Mesh" : "Mesh of " + details.title);
  return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n" +
         MakeHead(facts, details, title) + "<body>\n<main>\n<h1>" + title + "</h1>\n" + MakeKeyFigures(facts) +
         MakeWarningSection(facts, details) + MakeCutSection(facts, details) + MakeLabelSection(facts, details) +
         MakeElectrodeSection(facts, details) + MakeShapeSection(facts, details) + MakeSizeSection(facts) +
         MakeLossSection(facts, details) + MakeStageSection(facts) + MakeSettingSection(details) +
         "<p class=\"save\" hidden=\"hidden\"><a id=\"save\" download=\"report.json\" href=\"#\">All numbers, as "
         "JSON</a></p>\n</main>\n<script type=\"application/json\" id=\"report\">" +
         EmbeddedJson(details.json.empty() ? MakeMeshReport(facts) : details.json) +
         "</script>\n<script>//<![CDATA[\n" + PageScript + "//]]></script>\n</body>\n</html>\n";
}

bool
IsMeshPage(const std::string & fileName)
{
  const std::string extension = itksys::SystemTools::LowerCase(itksys::SystemTools::GetFilenameLastExtension(fileName));
  return extension == ".html" || extension == ".htm";
}

void
WriteMeshReport(const std::string & fileName, const MeshFacts & facts, const MeshPageDetails & details)
{
  OutputFile::WriteWhole(fileName,
                         IsMeshPage(fileName)   ? MakeMeshPage(facts, details)
                         : details.json.empty() ? MakeMeshReport(facts)
                                                : details.json);
}
} // end namespace itk
