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
#ifndef itkTriangleSurfaceToDistanceImageFilter_hxx
#define itkTriangleSurfaceToDistanceImageFilter_hxx

#include "itkImageConversion.h"

#include <algorithm>
#include <cmath>

namespace itk
{
template <typename TInputMesh, typename TOutputImage>
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::TriangleSurfaceToDistanceImageFilter()
{
  this->SetNumberOfRequiredInputs(1);
}

template <typename TInputMesh, typename TOutputImage>
void
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::SetInput(const TInputMesh * mesh)
{
  this->ProcessObject::SetNthInput(0, const_cast<TInputMesh *>(mesh));
}

template <typename TInputMesh, typename TOutputImage>
const TInputMesh *
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::GetInput() const
{
  return dynamic_cast<const TInputMesh *>(this->GetPrimaryInput());
}

template <typename TInputMesh, typename TOutputImage>
void
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::VerifyPreconditions() const
{
  Superclass::VerifyPreconditions();
  if (m_ReferenceImage.IsNull())
  {
    itkExceptionMacro("There is no ReferenceImage, which says at which voxels the distance is to be known.");
  }
  if (!std::isnan(m_BandWidth) && !(m_BandWidth > 0.0 && std::isfinite(m_BandWidth)))
  {
    itkExceptionMacro("The band width is " << m_BandWidth << " mm. It must be finite and positive.");
  }
}

template <typename TInputMesh, typename TOutputImage>
void
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::GenerateOutputInformation()
{
  if (m_ReferenceImage.IsNotNull())
  {
    TOutputImage * output = this->GetOutput();
    output->CopyInformation(m_ReferenceImage);
    output->SetLargestPossibleRegion(m_ReferenceImage->GetLargestPossibleRegion());
  }
}

template <typename TInputMesh, typename TOutputImage>
void
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TInputMesh, typename TOutputImage>
mmm::SurfaceTriangles
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::GetTriangles() const
{
  const TInputMesh *    mesh = this->GetInput();
  mmm::SurfaceTriangles surface;
  if (const auto * points = mesh->GetPoints())
  {
    for (auto it = points->Begin(); it != points->End(); ++it)
    {
      surface.points.resize(std::max<std::size_t>(surface.points.size(), it.Index() + 1));
      surface.points[it.Index()].CastFrom(it.Value());
    }
  }
  if (const auto * cells = mesh->GetCells())
  {
    for (auto it = cells->Begin(); it != cells->End(); ++it)
    {
      const auto & cell = *it.Value();
      if (cell.GetNumberOfPoints() != 3)
      {
        itkExceptionMacro("Cell " << it.Index() << " has " << cell.GetNumberOfPoints()
                                  << " points. A surface of triangles is needed.");
      }
      std::array<IdentifierType, 3> triangle;
      std::copy(cell.PointIdsBegin(), cell.PointIdsEnd(), triangle.begin());
      surface.triangles.push_back(triangle);
    }
  }
  return surface;
}

template <typename TInputMesh, typename TOutputImage>
void
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::GenerateData()
{
  const auto distance = mmm::ComputeSurfaceDistance(this, this->GetTriangles(), m_ReferenceImage, m_BandWidth, m_Facts);
  FromFloats(distance.GetPointer(), this->GetOutput());
}

template <typename TInputMesh, typename TOutputImage>
void
TriangleSurfaceToDistanceImageFilter<TInputMesh, TOutputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(ReferenceImage);
  os << indent << "BandWidth: " << m_BandWidth << std::endl;
  os << indent << "NumberOfBoundaryEdges: " << m_Facts.boundaryEdges << std::endl;
  os << indent << "NumberOfTurnedTriangles: " << m_Facts.turnedTriangles << std::endl;
  os << indent << "HasOverlaps: " << (m_Facts.hasOverlaps ? "true" : "false") << std::endl;
  os << indent << "Overshoot: " << m_Facts.overshoot << std::endl;
  os << indent << "NumberOfVoxelsInside: " << m_Facts.voxelsInside << std::endl;
}
} // namespace itk

#endif
