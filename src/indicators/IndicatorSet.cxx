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
#include "indicators/IndicatorSet.h"

#include "base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mmm
{
namespace
{
/** Materials are listed for bricks of this many nodes along each axis. */
constexpr int BrickSize = 4;
/** A material this much below the largest at a node cannot be the largest within a voxel of it. */
constexpr float CandidateMargin = 2.5f;
} // namespace

/** The nodes around a point and their weights, an axis at a time. */
struct IndicatorSet::Stencil
{
  Index  brick; // of the first node
  Index  place;
  double weight[3][4];
  double slope[3][4];
};

/** The materials that are candidates in each brick of a layer. */
struct IndicatorSet::CandidateLayer
{
  std::vector<std::uint32_t> counts;
  std::vector<Material>      materials;
};

IndicatorSet::IndicatorSet(const Grid & grid, std::vector<IndicatorBricks> indicators, double outside)
  : m_Grid(grid)
  , m_Indicators(std::move(indicators))
  , m_Outside(outside)
{
  this->ListCandidates();
}

void
IndicatorSet::ListCandidates()
{
  for (int a = 0; a < 3; ++a)
  {
    m_Bricks[a] = (m_Grid.size[a] + BrickSize - 1) / BrickSize;
  }
  m_NodeMaterials.assign(m_Grid.NumberOfNodes(), 0);
  std::vector<CandidateLayer> layers(m_Bricks[2]);
  ParallelFor(layers.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t layer = begin; layer < end; ++layer)
    {
      this->ListCandidates(int(layer), layers[layer]);
    }
  });
  m_BrickStart.assign(1, 0);
  for (const auto & layer : layers)
  {
    for (const auto count : layer.counts)
    {
      m_BrickStart.push_back(m_BrickStart.back() + count);
    }
    m_BrickMaterials.insert(m_BrickMaterials.end(), layer.materials.begin(), layer.materials.end());
  }
}

void
IndicatorSet::ListCandidates(int layer, CandidateLayer & list)
{
  // A point of a brick is interpolated from nodes up to two beyond it, but its own material is decided one node around.
  constexpr int Reach = BrickSize + 2;
  using Values = std::array<float, Reach * Reach * Reach>;
  Index      lower;
  Index      upper;
  const auto setRange = [&](int axis, int brick) {
    lower[axis] = std::max(brick * BrickSize - 1, 0);
    upper[axis] = std::min((brick + 1) * BrickSize + 1, m_Grid.size[axis]);
  };
  const auto overlaps = [&](Material m, int axis) {
    return m_Indicators[m].GetLower()[axis] < upper[axis] && m_Indicators[m].GetUpper()[axis] > lower[axis];
  };
  std::vector<Material> inLayer;
  std::vector<Material> inRow;
  std::vector<Material> here;
  std::vector<Values>   values;

  setRange(2, layer);
  for (std::size_t m = 0; m < m_Indicators.size(); ++m)
  {
    if (overlaps(Material(m), 2))
    {
      inLayer.push_back(Material(m));
    }
  }
  for (int bj = 0; bj < m_Bricks[1]; ++bj)
  {
    setRange(1, bj);
    inRow.clear();
    std::copy_if(inLayer.begin(), inLayer.end(), std::back_inserter(inRow), [&](Material m) { return overlaps(m, 1); });
    for (int bi = 0; bi < m_Bricks[0]; ++bi)
    {
      setRange(0, bi);
      here.clear();
      std::copy_if(inRow.begin(), inRow.end(), std::back_inserter(here), [&](Material m) {
        return overlaps(m, 0) && !m_Indicators[m].IsOutside(lower, upper);
      });
      values.resize(here.size());
      std::array<Material, Reach * Reach * Reach> materials{};
      Values                                      largest;
      largest.fill(float(m_Outside) - 1.0f);
      for (std::size_t n = 0; n < here.size(); ++n)
      {
        std::size_t place = 0;
        for (int k = lower[2]; k < upper[2]; ++k)
        {
          for (int j = lower[1]; j < upper[1]; ++j)
          {
            for (int i = lower[0]; i < upper[0]; ++i, ++place)
            {
              const float value = here.size() > 1 ? m_Indicators[here[n]].At(Index{ { i, j, k } }) : 0.0f;
              values[n][place] = value;
              if (value > largest[place])
              {
                largest[place] = value;
                materials[place] = here[n];
              }
            }
          }
        }
      }
      std::size_t place = 0;
      for (int k = lower[2]; k < upper[2]; ++k)
      {
        for (int j = lower[1]; j < upper[1]; ++j)
        {
          for (int i = lower[0]; i < upper[0]; ++i, ++place)
          {
            if (i / BrickSize == bi && j / BrickSize == bj && k / BrickSize == layer)
            {
              m_NodeMaterials[m_Grid.Offset(i, j, k)] = materials[place];
            }
          }
        }
      }
      const auto before = list.materials.size();
      for (std::size_t n = 0; n < here.size(); ++n)
      {
        const auto & own = values[n];
        const auto   isCandidate = [&](std::size_t p) { return own[p] > largest[p] - CandidateMargin; };
        std::size_t  p = 0;
        while (p < place && !isCandidate(p))
        {
          ++p;
        }
        if (p < place)
        {
          list.materials.push_back(here[n]);
        }
      }
      list.counts.push_back(std::uint32_t(list.materials.size() - before));
    }
  }
}

std::pair<const Material *, const Material *>
IndicatorSet::Candidates(const Vector & x) const
{
  std::size_t at[3];
  for (int a = 0; a < 3; ++a)
  {
    const int nearest = int(std::floor(x[a] / m_Grid.spacing[a] + 0.5));
    at[a] = std::min(std::max(nearest, 0), m_Grid.size[a] - 1) / BrickSize;
  }
  const auto brick = (at[2] * m_Bricks[1] + at[1]) * m_Bricks[0] + at[0];
  return { m_BrickMaterials.data() + m_BrickStart[brick], m_BrickMaterials.data() + m_BrickStart[brick + 1] };
}

IndicatorSet::Stencil
IndicatorSet::StencilAt(const Vector & x) const
{
  Stencil stencil;
  for (int a = 0; a < 3; ++a)
  {
    const int    last = m_Grid.size[a] - 1;
    const double position = x[a] / m_Grid.spacing[a];
    const bool   within = position > 0.0 && position < last;
    const double u = std::min(std::max(position, 0.0), double(last));
    const int    base = std::min(int(u), std::max(last - 1, 0));
    const double t = u - base;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double scale = within ? 1.0 / m_Grid.spacing[a] : 0.0;
    stencil.weight[a][0] = -0.5 * t + t2 - 0.5 * t3;
    stencil.weight[a][1] = 1.0 - 2.5 * t2 + 1.5 * t3;
    stencil.weight[a][2] = 0.5 * t + 2.0 * t2 - 1.5 * t3;
    stencil.weight[a][3] = -0.5 * t2 + 0.5 * t3;
    stencil.slope[a][0] = (-0.5 + 2.0 * t - 1.5 * t2) * scale;
    stencil.slope[a][1] = (-5.0 * t + 4.5 * t2) * scale;
    stencil.slope[a][2] = (0.5 + 4.0 * t - 4.5 * t2) * scale;
    stencil.slope[a][3] = (-t + 1.5 * t2) * scale;
    stencil.brick[a] = IndicatorBricks::BrickOf(base - 1);
    stencil.place[a] = IndicatorBricks::PlaceOf(base - 1);
  }
  return stencil;
}

template <typename TBody>
void
IndicatorSet::ForEachRow(Material m, const Stencil & stencil, const TBody & body) const
{
  const auto &  indicator = m_Indicators[m];
  const Index & brick = stencil.brick;
  const Index & place = stencil.place;
  // the stencil's rows lie in up to four bricks
  const int     beyond[2] = { place[1] > IndicatorBricks::Edge - 4, place[2] > IndicatorBricks::Edge - 4 };
  const float * values[2][2];
  for (int k = 0; k <= beyond[1]; ++k)
  {
    for (int j = 0; j <= beyond[0]; ++j)
    {
      values[k][j] = indicator.Values(brick[0], brick[1] + j, brick[2] + k) + place[0];
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    const int z = place[2] + k;
    for (int j = 0; j < 4; ++j)
    {
      const int y = place[1] + j;
      body(k,
           j,
           values[z / IndicatorBricks::Edge][y / IndicatorBricks::Edge] +
             IndicatorBricks::RowPlace(y % IndicatorBricks::Edge, z % IndicatorBricks::Edge));
    }
  }
}

double
IndicatorSet::Evaluate(Material m, const Stencil & stencil) const
{
  if (m_Indicators[m].IsOutside(stencil.brick))
  {
    return m_Outside;
  }
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  this->ForEachRow(m, stencil, [&](int k, int j, const float * row) {
    const double weight = stencil.weight[2][k] * stencil.weight[1][j];
    for (int i = 0; i < 4; ++i)
    {
      sums[i] += weight * row[i];
    }
  });
  double value = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    value += stencil.weight[0][i] * sums[i];
  }
  return value;
}

double
IndicatorSet::Evaluate(Material m, const Stencil & stencil, Vector & gradient) const
{
  gradient.setZero();
  if (m_Indicators[m].IsOutside(stencil.brick))
  {
    return m_Outside;
  }
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  double alongY[4] = { 0.0, 0.0, 0.0, 0.0 };
  double alongZ[4] = { 0.0, 0.0, 0.0, 0.0 };
  this->ForEachRow(m, stencil, [&](int k, int j, const float * row) {
    const double weight = stencil.weight[2][k] * stencil.weight[1][j];
    const double y = stencil.weight[2][k] * stencil.slope[1][j];
    const double z = stencil.slope[2][k] * stencil.weight[1][j];
    for (int i = 0; i < 4; ++i)
    {
      sums[i] += weight * row[i];
      alongY[i] += y * row[i];
      alongZ[i] += z * row[i];
    }
  });
  double value = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    value += stencil.weight[0][i] * sums[i];
    gradient[0] += stencil.slope[0][i] * sums[i];
    gradient[1] += stencil.weight[0][i] * alongY[i];
    gradient[2] += stencil.weight[0][i] * alongZ[i];
  }
  return value;
}

double
IndicatorSet::Value(Material m, const Vector & x) const
{
  return this->IsPlane(m) ? this->PlaneValue(m, x) : this->Evaluate(m, this->StencilAt(x));
}

double
IndicatorSet::ValueAndGradient(Material m, const Vector & x, Vector & gradient) const
{
  if (this->IsPlane(m))
  {
    const auto plane = m - m_Indicators.size();
    gradient = Vector::Unit(plane / 2) * (plane % 2 ? 1.0 : -1.0);
    return this->PlaneValue(m, x);
  }
  return this->Evaluate(m, this->StencilAt(x), gradient);
}

double
IndicatorSet::Difference(Material first, Material last, const Vector & x) const
{
  if (this->IsPlane(first) || this->IsPlane(last))
  {
    return this->Value(first, x) - this->Value(last, x);
  }
  const Stencil stencil = this->StencilAt(x);
  return this->Evaluate(first, stencil) - this->Evaluate(last, stencil);
}

double
IndicatorSet::PlaneValue(Material plane, const Vector & x) const
{
  const auto number = plane - m_Indicators.size();
  const int  axis = int(number / 2);
  return number % 2 ? x[axis] - m_Grid.UpperFace(axis) : m_Grid.LowerFace(axis) - x[axis];
}

Material
IndicatorSet::MaterialAt(const Vector & x) const
{
  Material outermost = 0;
  double   furthest = 0.0;
  for (int p = 0; p < 6; ++p)
  {
    const auto   plane = Material(m_Indicators.size() + p);
    const double value = this->PlaneValue(plane, x);
    if (value > furthest)
    {
      furthest = value;
      outermost = plane;
    }
  }
  if (furthest > 0.0)
  {
    return outermost;
  }
  const auto range = this->Candidates(x);
  if (range.second - range.first == 1)
  {
    return *range.first;
  }
  const Stencil stencil = this->StencilAt(x);
  Material      best = 0;
  double        largest = -1e300;
  for (auto m = range.first; m != range.second; ++m)
  {
    const double value = this->Evaluate(*m, stencil);
    if (value > largest)
    {
      largest = value;
      best = *m;
    }
  }
  return best;
}

double
IndicatorSet::InsideOutside(Material m, const Vector & x) const
{
  const Stencil stencil = this->StencilAt(x);
  double        others = m_Outside;
  const auto    range = this->Candidates(x);
  for (auto j = range.first; j != range.second; ++j)
  {
    if (*j != m)
    {
      others = std::max(others, this->Evaluate(*j, stencil));
    }
  }
  return this->Evaluate(m, stencil) - others;
}

double
IndicatorSet::CellIndicator(const Cell & cell, const Vector & x) const
{
  double sum = 0.0;
  for (const Material m : cell)
  {
    const double g = this->IsPlane(m) ? this->PlaneValue(m, x) : this->InsideOutside(m, x);
    sum += g * g;
  }
  return sum;
}

int
IndicatorSet::Residuals(const Cell & cell, const Vector & x, double * values, Vector * gradients) const
{
  const Stencil stencil = this->StencilAt(x);
  double        firstValue = 0.0;
  Vector        firstGradient = Vector::Zero();
  int           count = 0;
  bool          first = true;
  for (const Material m : cell)
  {
    if (this->IsPlane(m))
    {
      values[count] = this->ValueAndGradient(m, x, gradients[count]);
      ++count;
    }
    else if (first)
    {
      firstValue = this->Evaluate(m, stencil, firstGradient);
      first = false;
    }
    else
    {
      Vector gradient;
      values[count] = firstValue - this->Evaluate(m, stencil, gradient);
      gradients[count] = firstGradient - gradient;
      ++count;
    }
  }
  return count;
}

bool
IndicatorSet::GaussNewtonStep(const Cell & cell, const Vector & x, Vector & step, Vector & direction) const
{
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;

  if (cell.count > 4)
  {
    return false; // no such place is known but the one where its junctions were joined
  }
  double    values[4];
  Vector    gradients[4];
  const int count = this->Residuals(cell, x, values, gradients);
  if (count == 1)
  {
    const double square = gradients[0].squaredNorm();
    if (square < 1e-6)
    {
      return false;
    }
    step = -values[0] / square * gradients[0];
    direction = gradients[0] / (this->IsPlane(cell.materials[1]) ? std::sqrt(square) : -std::sqrt(square));
  }
  else
  {
    Jacobian j(count, 3);
    Column   r(count);
    for (int n = 0; n < count; ++n)
    {
      j.row(n) = gradients[n].transpose();
      r[n] = values[n];
    }
    Square a = j * j.transpose();
    a.diagonal().array() += 1e-6 * a.trace();
    step = -(j.transpose() * a.ldlt().solve(r));
    direction = gradients[0].cross(gradients[1]).normalized();
  }
  return step.squaredNorm() < 1e6;
}

bool
IndicatorSet::Project(const Cell & cell, Vector & x, double reach) const
{
  constexpr int    MaximumSteps = 12;
  constexpr double Accuracy = 1e-4;
  constexpr double LongestStep = 0.7;

  const Vector start = x;
  for (int n = 0; n < MaximumSteps; ++n)
  {
    Vector step;
    Vector direction;
    if (!this->GaussNewtonStep(cell, x, step, direction))
    {
      return false;
    }
    const double length = step.norm();
    if (length < Accuracy)
    {
      x += step;
      this->SnapToPlanes(cell, x);
      return (x - start).norm() <= reach;
    }
    x += length > LongestStep ? Vector(step * (LongestStep / length)) : step;
    if ((x - start).norm() > 2.0 * reach)
    {
      return false;
    }
  }
  return false;
}

bool
IndicatorSet::Approach(const Cell & cell, Vector & x, Vector & direction) const
{
  constexpr double LongestStep = 0.5;
  Vector           step;
  if (!this->GaussNewtonStep(cell, x, step, direction) || step.squaredNorm() > LongestStep * LongestStep)
  {
    return false;
  }
  x += step;
  this->SnapToPlanes(cell, x);
  return true;
}

void
IndicatorSet::SnapToPlanes(const Cell & cell, Vector & x) const
{
  for (const Material m : cell)
  {
    if (this->IsPlane(m))
    {
      const auto number = m - m_Indicators.size();
      const int  axis = int(number / 2);
      x[axis] = number % 2 ? m_Grid.UpperFace(axis) : m_Grid.LowerFace(axis);
    }
  }
}

bool
IndicatorSet::IsMaximal(const Cell & cell, const Vector & x, double tolerance) const
{
  for (int p = 0; p < 6; ++p)
  {
    const auto plane = Material(m_Indicators.size() + p);
    if (this->PlaneValue(plane, x) > (cell.Has(plane) ? tolerance : 0.0))
    {
      return false;
    }
  }
  const Stencil stencil = this->StencilAt(x);
  double        own = 0.0;
  int           count = 0;
  for (const Material m : cell)
  {
    if (!this->IsPlane(m))
    {
      own += this->Evaluate(m, stencil);
      ++count;
    }
  }
  own /= std::max(count, 1);
  const auto range = this->Candidates(x);
  for (auto m = range.first; m != range.second; ++m)
  {
    if (!cell.Has(*m) && this->Evaluate(*m, stencil) > own + tolerance)
    {
      return false;
    }
  }
  return count > 0;
}

Vector
IndicatorSet::Normal(const Cell & cell, const Vector & x) const
{
  double values[4];
  Vector gradients[4];
  this->Residuals(cell, x, values, gradients);
  // f_low - f_high falls towards the higher material; a plane's own function rises towards it
  const Vector normal = this->IsPlane(cell.materials[1]) ? gradients[0] : Vector(-gradients[0]);
  const double length = normal.norm();
  return length > 0.0 ? Vector(normal / length) : Vector::UnitZ();
}

Vector
IndicatorSet::Tangent(const Cell & cell, const Vector & x) const
{
  double values[4];
  Vector gradients[4];
  this->Residuals(cell, x, values, gradients);
  const Vector tangent = gradients[0].cross(gradients[1]);
  const double length = tangent.norm();
  return length > 0.0 ? Vector(tangent / length) : Vector::UnitZ();
}
} // namespace mmm
