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
#include "itkTetrahedronImageSampler.h"

#include "base/Parallel.h"
#include "fields/TetrahedronQuadrature.h"

#include "itkLinearInterpolateImageFunction.h"
#include "itkNearestNeighborInterpolateImageFunction.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace itk
{
namespace
{
constexpr std::size_t Grain = 4096;

using ImageType = TetrahedronImageSampler::ImageType;
using Interpolator = InterpolateImageFunction<ImageType, double>;

Interpolator::Pointer
MakeInterpolator(bool isNearest)
{
  if (isNearest)
  {
    return NearestNeighborInterpolateImageFunction<ImageType, double>::New().GetPointer();
  }
  return LinearInterpolateImageFunction<ImageType, double>::New().GetPointer();
}

/** What a tetrahedron got: a number, and how much of it was in the image. */
struct Value
{
  double value{ std::numeric_limits<double>::quiet_NaN() };
  double share{ 0.0 };
};

Value
ValueIn(const mmm::TetrahedronCorners & corners, int parts, const Interpolator & interpolator)
{
  double sum = 0.0;
  double inside = 0.0;
  double all = 0.0;
  mmm::VisitTetrahedron(corners, parts, [&](const ContinuousIndex<double, 3> & point, double weight) {
    all += weight;
    if (interpolator.IsInsideBuffer(point))
    {
      inside += weight;
      sum += weight * interpolator.EvaluateAtContinuousIndex(point);
    }
  });
  return inside > 0.0 ? Value{ sum / inside, inside / all } : Value{};
}
} // namespace

const std::vector<std::string> &
TetrahedronImageSampler::GetModes()
{
  static const std::vector<std::string> modes{ "mean", "nearest", "linear" };
  return modes;
}

std::vector<double>
TetrahedronImageSampler::Sample(const ImageType * image)
{
  if (!m_Mesh || image == nullptr || image->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    itkExceptionMacro("There is no mesh, or no image, to sample on it.");
  }
  if (std::find(GetModes().begin(), GetModes().end(), m_Mode) == GetModes().end())
  {
    itkExceptionMacro("There is no mode '" << m_Mode << "'; it has to be mean, nearest or linear.");
  }
  const std::size_t count = m_Mesh->GetNumberOfCells();
  const bool        isMean = m_Mode == "mean";
  const auto        interpolator = MakeInterpolator(m_Mode == "nearest");
  interpolator->SetInputImage(image);
  std::vector<double>      values(count);
  std::vector<std::size_t> outside((count + Grain - 1) / Grain);
  std::vector<std::size_t> partly(outside.size());
  mmm::ParallelFor(count, Grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto * const cell = m_Mesh->GetCells()->ElementAt(n);
      if (cell->GetNumberOfPoints() != 4)
      {
        itkExceptionMacro("Cell " << n << " of the mesh is no tetrahedron.");
      }
      mmm::TetrahedronCorners corners;
      std::transform(cell->PointIdsBegin(), cell->PointIdsEnd(), corners.begin(), [&](IdentifierType point) {
        ContinuousIndex<double, 3> index;
        // whether it is inside is asked for each point of the quadrature
        static_cast<void>(image->TransformPhysicalPointToContinuousIndex(m_Mesh->GetPoints()->ElementAt(point), index));
        return index;
      });
      const Value value = ValueIn(corners, isMean ? mmm::PartsOfEdges(corners) : 1, *interpolator);
      values[n] = value.value;
      outside[begin / Grain] += value.share == 0.0;
      partly[begin / Grain] += value.share > 0.0 && value.share < 1.0;
    }
  });
  m_NumberOutside = std::accumulate(outside.begin(), outside.end(), SizeValueType{ 0 });
  m_NumberPartlyOutside = std::accumulate(partly.begin(), partly.end(), SizeValueType{ 0 });
  return values;
}

std::vector<double>
TetrahedronImageSampler::SampleTensors(const TensorImageType * image)
{
  constexpr unsigned int size = 3;
  if (image == nullptr)
  {
    itkExceptionMacro("There is no image of tensors to sample.");
  }
  const auto component = ImageType::New();
  component->CopyInformation(image);
  component->SetRegions(image->GetBufferedRegion());
  component->Allocate();
  const std::size_t   voxels = image->GetBufferedRegion().GetNumberOfPixels();
  std::vector<double> tensors;
  for (unsigned int row = 0; row < size; ++row)
  {
    for (unsigned int column = row; column < size; ++column)
    {
      std::transform(image->GetBufferPointer(),
                     image->GetBufferPointer() + voxels,
                     component->GetBufferPointer(),
                     [&](const TensorImageType::PixelType & tensor) { return tensor(row, column); });
      const auto values = this->Sample(component);
      tensors.resize(size * size * values.size());
      for (std::size_t n = 0; n < values.size(); ++n)
      {
        tensors[size * size * n + size * row + column] = values[n];
        tensors[size * size * n + size * column + row] = values[n];
      }
    }
  }
  return tensors;
}

void
TetrahedronImageSampler::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Mesh: " << m_Mesh.GetPointer() << '\n';
  os << indent << "Mode: " << m_Mode << '\n';
  os << indent << "NumberOutside: " << m_NumberOutside << '\n';
  os << indent << "NumberPartlyOutside: " << m_NumberPartlyOutside << '\n';
}
} // end namespace itk
