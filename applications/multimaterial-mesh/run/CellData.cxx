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
#include "run/CellData.h"

#include "console/Warnings.h"
#include "itkTetrahedronImageSampler.h"

#include "itkSymmetricSecondRankTensor.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cli
{
namespace
{
std::vector<double>
ConductivityOfTetrahedra(const Outcome & outcome)
{
  const auto &        labels = outcome.tetrahedra->GetCellData()->CastToSTLConstContainer();
  std::vector<double> values(labels.size());
  std::transform(
    labels.begin(), labels.end(), values.begin(), [&](int label) { return outcome.input.conductivity.at(label); });
  return values;
}

void
WarnOfOutside(const CellDataRequest & request, const CellDataRecord & record, std::size_t tetrahedra)
{
  if (record.outside > 0)
  {
    Warn(request.file + ": " + std::to_string(record.outside) + " of " + std::to_string(tetrahedra) +
         " tetrahedra are outside of the image; their " + request.name + " is NaN");
  }
  if (record.partlyOutside > 0)
  {
    Warn(request.file + ": " + std::to_string(record.partlyOutside) + " of " + std::to_string(tetrahedra) +
         " tetrahedra are partly outside of the image; their " + request.name + " is that of the part inside");
  }
}

using Tensor = itk::SymmetricSecondRankTensor<double, 3>;

double
LowestEigenvalue(const Tensor & tensor)
{
  Tensor::EigenValuesArrayType values;
  tensor.ComputeEigenValues(values);
  return *std::min_element(values.Begin(), values.End());
}

/** Of those that are not positive definite, unless they are 0, as outside of what was measured. */
void
WarnOfTensors(const CellDataRequest &           request,
              const std::vector<double> &       values,
              const itk::LabelTetrahedralMesh & mesh)
{
  constexpr std::size_t size = 9;
  std::size_t           count = 0;
  std::size_t           zeros = 0;
  std::size_t           first = 0;
  for (std::size_t n = 0; size * n < values.size(); ++n)
  {
    const double * const matrix = &values[size * n];
    Tensor               tensor;
    for (unsigned int c = 0; c < size; ++c)
    {
      tensor(c / 3, c % 3) = matrix[c];
    }
    const bool isZero = std::all_of(matrix, matrix + size, [](double value) { return value == 0.0; });
    zeros += isZero;
    // without number where it is outside
    if (!isZero && std::isfinite(matrix[0]) && LowestEigenvalue(tensor) <= 0.0 && count++ == 0)
    {
      first = n;
    }
  }
  const std::string all = " of " + std::to_string(values.size() / size) + " tetrahedra";
  if (zeros > 0)
  {
    Warn(request.file + ": the tensor is 0 in " + std::to_string(zeros) + all);
  }
  if (count > 0)
  {
    const auto         point = mesh.GetPoints()->ElementAt(*mesh.GetCells()->ElementAt(first)->PointIdsBegin());
    std::ostringstream text;
    text << request.file << ": the tensor is not positive definite in " << count << all << " (the first one at "
         << point[0] << ", " << point[1] << ", " << point[2] << " mm); it is written as it is";
    Warn(text.str());
  }
}
} // namespace

void
MakeCellData(Outcome & outcome)
{
  const auto & requests = outcome.settings.cellData;
  if (!outcome.input.conductivity.empty())
  {
    outcome.cellData.push_back({ "conductivity", ConductivityOfTetrahedra(outcome) });
  }
  const auto sampler = itk::TetrahedronImageSampler::New();
  sampler->SetMesh(outcome.tetrahedra);
  for (std::size_t n = 0; n < requests.size(); ++n)
  {
    sampler->SetMode(requests[n].mode);
    const SampledImage & image = outcome.input.cellData[n];
    CellDataRecord       record{ requests[n].name,
                           image.scalars ? sampler->Sample(image.scalars) : sampler->SampleTensors(image.tensors) };
    record.outside = sampler->GetNumberOutside();
    record.partlyOutside = sampler->GetNumberPartlyOutside();
    if (image.tensors)
    {
      WarnOfTensors(requests[n], record.values, *outcome.tetrahedra);
    }
    WarnOfOutside(requests[n], record, outcome.tetrahedra->GetNumberOfCells());
    outcome.cellData.push_back(std::move(record));
  }
}
} // namespace cli
