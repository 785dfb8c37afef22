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
#include "mmmIndicatorSet.h"

#include "mmmParallel.h"

#include <cmath>

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
  int    node[3][4];
  double weight[3][4];
  double slope[3][4];
};

IndicatorSet::IndicatorSet(const Grid &                        grid,
                           std::vector<BlockView<const float>> indicators,
                           double                              outside,
                           double                              scale)
  : m_Grid(grid)
  , m_Indicators(std::move(indicators))
  , m_Outside(outside)
  , m_Scale(scale)
{
  this->ListCandidates();
}

void
IndicatorSet::ListCandidates()
{
  const std::size_t  count = m_Grid.NumberOfNodes();
  const float        scale = float(m_Scale);
  std::vector<float> largest(count, float(m_Outside) - 1.0f);
  m_NodeMaterials.assign(count, 0);
  for (std::size_t m = 0; m < m_Indicators.size(); ++m)
  {
    const auto & block = m_Indicators[m];
    ParallelFor(block.size[2], 1, [&](std::size_t begin, std::size_t end) {
      for (int k = int(begin); k < int(end); ++k)
      {
        for (int j = 0; j < block.size[1]; ++j)
        {
          const float * values = block.values + (std::size_t(k) * block.size[1] + j) * block.size[0];
          const auto    row = m_Grid.Offset(block.lower[0], block.lower[1] + j, block.lower[2] + k);
          for (int i = 0; i < block.size[0]; ++i)
          {
            const float value = values[i] * scale;
            if (value > largest[row + i])
            {
              largest[row + i] = value;
              m_NodeMaterials[row + i] = Material(m);
            }
          }
        }
      }
    });
  }

  std::size_t bricks = 1;
  for (int a = 0; a < 3; ++a)
  {
    m_Bricks[a] = (m_Grid.size[a] + BrickSize - 1) / BrickSize;
    bricks *= m_Bricks[a];
  }
  // A point of a brick is interpolated from nodes up to two beyond it, but its own material is decided one node around.
  std::vector<std::vector<Material>> lists(bricks);
  for (std::size_t m = 0; m < m_Indicators.size(); ++m)
  {
    const auto & block = m_Indicators[m];
    if (block.size[0] == 0)
    {
      continue;
    }
    const auto firstBrick = [&](int a) { return std::max(0, (block.lower[a] - 1) / BrickSize); };
    const auto lastBrick = [&](int a) {
      return std::min(m_Bricks[a] - 1, (block.lower[a] + block.size[a]) / BrickSize);
    };
    ParallelFor(lastBrick(2) - firstBrick(2) + 1, 1, [&](std::size_t begin, std::size_t end) {
      for (int bk = firstBrick(2) + int(begin); bk < firstBrick(2) + int(end); ++bk)
      {
        for (int bj = firstBrick(1); bj <= lastBrick(1); ++bj)
        {
          for (int bi = firstBrick(0); bi <= lastBrick(0); ++bi)
          {
            const int brick[3] = { bi, bj, bk };
            int       low[3];
            int       high[3];
            for (int a = 0; a < 3; ++a)
            {
              low[a] = std::max(brick[a] * BrickSize - 1, block.lower[a]);
              high[a] = std::min(brick[a] * BrickSize + BrickSize + 1, block.lower[a] + block.size[a]);
            }
            bool found = false;
            for (int k = low[2]; k < high[2] && !found; ++k)
            {
              for (int j = low[1]; j < high[1] && !found; ++j)
              {
                const float * values =
                  block.values +
                  (std::size_t(k - block.lower[2]) * block.size[1] + (j - block.lower[1])) * block.size[0] -
                  block.lower[0];
                const auto row = m_Grid.Offset(0, j, k);
                for (int i = low[0]; i < high[0] && !found; ++i)
                {
                  found = values[i] * scale > largest[row + i] - CandidateMargin;
                }
              }
            }
            if (found)
            {
              lists[(std::size_t(bk) * m_Bricks[1] + bj) * m_Bricks[0] + bi].push_back(Material(m));
            }
          }
        }
      }
    });
  }
  m_BrickStart.assign(bricks + 1, 0);
  for (std::size_t b = 0; b < bricks; ++b)
  {
    m_BrickStart[b + 1] = m_BrickStart[b] + std::uint32_t(lists[b].size());
  }
  m_BrickMaterials.reserve(m_BrickStart.back());
  for (const auto & list : lists)
  {
    m_BrickMaterials.insert(m_BrickMaterials.end(), list.begin(), list.end());
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
    for (int n = 0; n < 4; ++n)
    {
      stencil.node[a][n] = std::min(std::max(base - 1 + n, 0), last);
    }
  }
  return stencil;
}

double
IndicatorSet::Evaluate(Material m, const Stencil & stencil) const
{
  Vector gradient;
  return this->Evaluate(m, stencil, gradient);
}

double
IndicatorSet::Evaluate(Material m, const Stencil & stencil, Vector & gradient) const
{
  const auto & block = m_Indicators[m];
  bool         inside = true;
  int          local[3][4];
  for (int a = 0; a < 3; ++a)
  {
    for (int n = 0; n < 4; ++n)
    {
      local[a][n] = stencil.node[a][n] - block.lower[a];
      inside = inside && local[a][n] >= 0 && local[a][n] < block.size[a];
    }
  }
  const double outside = m_Outside / m_Scale;
  double       value = 0.0;
  gradient.setZero();
  for (int k = 0; k < 4; ++k)
  {
    double planeValue = 0.0;
    double planeX = 0.0;
    double planeY = 0.0;
    for (int j = 0; j < 4; ++j)
    {
      double rowValue = 0.0;
      double rowX = 0.0;
      if (inside)
      {
        const float * row = block.values + (std::size_t(local[2][k]) * block.size[1] + local[1][j]) * block.size[0];
        for (int i = 0; i < 4; ++i)
        {
          const double f = row[local[0][i]];
          rowValue += stencil.weight[0][i] * f;
          rowX += stencil.slope[0][i] * f;
        }
      }
      else
      {
        const bool rowInside =
          local[1][j] >= 0 && local[1][j] < block.size[1] && local[2][k] >= 0 && local[2][k] < block.size[2];
        for (int i = 0; i < 4; ++i)
        {
          const bool   known = rowInside && local[0][i] >= 0 && local[0][i] < block.size[0];
          const double f =
            known ? block.values[(std::size_t(local[2][k]) * block.size[1] + local[1][j]) * block.size[0] + local[0][i]]
                  : outside;
          rowValue += stencil.weight[0][i] * f;
          rowX += stencil.slope[0][i] * f;
        }
      }
      planeValue += stencil.weight[1][j] * rowValue;
      planeX += stencil.weight[1][j] * rowX;
      planeY += stencil.slope[1][j] * rowValue;
    }
    value += stencil.weight[2][k] * planeValue;
    gradient[0] += stencil.weight[2][k] * planeX;
    gradient[1] += stencil.weight[2][k] * planeY;
    gradient[2] += stencil.slope[2][k] * planeValue;
  }
  gradient *= m_Scale;
  return value * m_Scale;
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
