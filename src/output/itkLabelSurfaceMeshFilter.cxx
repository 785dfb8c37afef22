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
#include "itkLabelSurfaceMeshFilter.h"

#include "output/OrientedTriangles.h"

#include <set>

namespace itk
{
auto
LabelSurfaceMeshFilter::FindLabels(const LabelInterfaceMesh * surface, int outsideLabel) -> LabelsType
{
  std::set<int> labels;
  for (const auto & sides : surface->GetCellData()->CastToSTLConstContainer())
  {
    labels.insert({ sides[0], sides[1] });
  }
  labels.erase(outsideLabel);
  return { labels.begin(), labels.end() };
}

void
LabelSurfaceMeshFilter::SetLabels(const LabelsType & labels)
{
  if (labels != m_Labels)
  {
    m_Labels = labels;
    this->Modified();
  }
}

void
LabelSurfaceMeshFilter::GenerateData()
{
  mmm::SetTriangles(*this->GetInput(), mmm::FindSurface(*this->GetInput(), m_Labels), this->GetOutput());
}

void
LabelSurfaceMeshFilter::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Labels:";
  for (const int label : m_Labels)
  {
    os << ' ' << label;
  }
  os << '\n';
}
} // end namespace itk
