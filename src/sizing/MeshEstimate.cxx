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
#include "sizing/MeshEstimate.h"

#include "base/Parallel.h"
#include "base/PeakMemory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace mmm
{
namespace
{
/** Bins of sizes and of thicknesses, from these on, in units of the smallest spacing. */
constexpr int    BinsPerOctave = 16;
constexpr double SmallestBin = 1.0 / 64.0;
constexpr int    SizeBins = 16 * BinsPerOctave;
constexpr int    ThicknessesPerOctave = 4;
constexpr int    ThicknessBins = 3 * ThicknessesPerOctave + 1;

/** Thin parts are sampled at this part of their thickness, whatever the sizes. Sizes that are coarser than this part of
 * it lose them at first; their interfaces are found again with triangles of about the thickness. */
constexpr double SizePerThickness = 0.8;
constexpr double CoarseSize = 1.5;

/** This part of an edge length, on both sides together, belongs to the interfaces: tetrahedra there are fewer, because
 * they share their corners with two materials. */
constexpr double EdgesAtRims = 0.5;

/** The area of voxel faces between materials, by that of the smooth interface: the average over all directions. */
constexpr double FaceArea = 1.5;

constexpr double TrianglesPerArea = 2.3;
constexpr double TetrahedraPerVolume = 8.9;
constexpr double PointsPerTetrahedron = 0.166;
constexpr double PointsPerTriangle = 0.13;
/** Of the memory that images took, this part is still taken when the mesh is made. */
constexpr double ShareOfImages = 0.7;
constexpr double BytesPerTetrahedron = 190.0;
constexpr double BytesPerTriangle = 1000.0; // where only the surface is wanted
constexpr double Gigabyte = 1024.0 * 1024.0 * 1024.0;

/** Planes of the grid that are summed up together: their number is no matter of threads. */
constexpr int PlaneRanges = 16;

std::uint8_t
ThicknessBin(double thickness)
{
  return std::uint8_t(std::min(std::max(std::log2(thickness), 0.0) * ThicknessesPerOctave, ThicknessBins - 1.0));
}

/** A bin for each node: of the shortest run of its material along an axis, but for runs that the border cuts. */
std::vector<std::uint8_t>
Thicknesses(const IndicatorSet & indicators)
{
  const Grid &              grid = indicators.GetGrid();
  std::vector<std::uint8_t> bins(grid.NumberOfNodes(), ThicknessBins - 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int  first = axis == 0 ? 1 : 0;
    const int  second = axis == 2 ? 1 : 2;
    const int  length = grid.size[axis];
    const auto stride = axis == 0 ? std::size_t(1) : std::size_t(grid.size[0]) * (axis == 1 ? 1 : grid.size[1]);
    ParallelFor(grid.size[second], 1, [&](std::size_t begin, std::size_t end) {
      for (int k = int(begin); k < int(end); ++k)
      {
        for (int j = 0; j < grid.size[first]; ++j)
        {
          Index start{ { 0, 0, 0 } };
          start[first] = j;
          start[second] = k;
          const std::size_t line = grid.Offset(start);
          for (int i = 0; i < length;)
          {
            const Material material = indicators.MaterialAtNode(line + i * stride);
            int            past = i + 1;
            while (past < length && indicators.MaterialAtNode(line + past * stride) == material)
            {
              ++past;
            }
            if (i > 0 && past < length)
            {
              const std::uint8_t bin = ThicknessBin((past - i) * grid.spacing[axis]);
              for (int n = i; n < past; ++n)
              {
                bins[line + n * stride] = std::min(bins[line + n * stride], bin);
              }
            }
            i = past;
          }
        }
      }
    });
  }
  return bins;
}

std::size_t
SizeBin(double size)
{
  const double octaves = std::log2(std::max(size, SmallestBin) / SmallestBin);
  return std::size_t(std::min(octaves * BinsPerOctave, SizeBins - 1.0));
}

/** With as many decimals as leave two digits. */
std::string
TwoDigits(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(value < 10.0 ? 1 : 0) << value;
  return text.str();
}
} // namespace

std::string
DescribeCount(double count)
{
  if (count >= 999500.0)
  {
    return TwoDigits(count / 1e6) + " million";
  }
  return count >= 9950.0 ? TwoDigits(count / 1e3) + " thousand" : TwoDigits(std::round(count / 10.0) * 10.0);
}

std::string
Describe(const MeshEstimate & estimate)
{
  return DescribeCount(estimate.points) + " points, " +
         (estimate.tetrahedra > 0.0 ? DescribeCount(estimate.tetrahedra) + " tetrahedra"
                                    : DescribeCount(estimate.triangles) + " triangles") +
         " and " +
         (estimate.memory < 0.95 ? TwoDigits(estimate.memory * 1024.0) + " MB" : TwoDigits(estimate.memory) + " GB");
}

double
RoundUp(double value)
{
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit * (1.0 - 1e-9)) * unit;
}

MeshEstimator::MeshEstimator(const IndicatorSet & indicators,
                             int                  exterior,
                             const SizingField &  sizing,
                             bool                 surfaceOnly)
  : m_Bins(SizeBins * ThicknessBins)
  , m_SurfaceOnly(surfaceOnly)
  , m_MemoryOfImages(PeakMemory() / 1024.0)
{
  const Grid &                  grid = indicators.GetGrid();
  const float * const           sizes = sizing.Values();
  const double                  voxel = grid.spacing.prod();
  const auto                    thicknesses = Thicknesses(indicators);
  const int                     planes = grid.size[2];
  const int                     grain = (planes + PlaneRanges - 1) / PlaneRanges;
  std::vector<std::vector<Bin>> ranges((planes + grain - 1) / grain);
  ParallelFor(planes, grain, [&](std::size_t begin, std::size_t end) {
    auto & bins = ranges[begin / grain];
    bins.resize(m_Bins.size());
    const auto binOf = [&](double size, std::uint8_t thickness) -> Bin & {
      return bins[SizeBin(size) * ThicknessBins + thickness];
    };
    for (int k = int(begin); k < int(end); ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          const Index       at{ { i, j, k } };
          const std::size_t n = grid.Offset(at);
          const Material    own = indicators.MaterialAtNode(n);
          const bool        isMeshed = int(own) != exterior;
          if (isMeshed)
          {
            binOf(sizes[n], thicknesses[n]).volume += voxel;
          }
          for (int a = 0; a < 3; ++a)
          {
            const double face = voxel / grid.spacing[a];
            Index        after = at;
            ++after[a];
            if (isMeshed && (at[a] == 0 || after[a] == grid.size[a]))
            {
              // the box cuts along voxel faces
              binOf(sizes[n], thicknesses[n]).area += face;
            }
            const std::size_t other = after[a] < grid.size[a] ? grid.Offset(after) : n;
            if (indicators.MaterialAtNode(other) != own)
            {
              binOf(0.5 * (sizes[n] + sizes[other]), std::min(thicknesses[n], thicknesses[other])).area +=
                face / FaceArea;
            }
          }
        }
      }
    }
  });
  for (const auto & range : ranges)
  {
    for (std::size_t b = 0; b < m_Bins.size(); ++b)
    {
      m_Bins[b].area += range[b].area;
      m_Bins[b].volume += range[b].volume;
    }
  }
}

MeshEstimate
MeshEstimator::Estimate(double smallestSize, double factor) const
{
  double area = 0.0;
  double volume = 0.0;
  for (int s = 0; s < SizeBins; ++s)
  {
    const double wanted = std::max(factor * SmallestBin * std::pow(2.0, (s + 0.5) / BinsPerOctave), smallestSize);
    for (int t = 0; t < ThicknessBins; ++t)
    {
      const Bin &  bin = m_Bins[s * ThicknessBins + t];
      const double thickness = t + 1 < ThicknessBins ? std::pow(2.0, double(t) / ThicknessesPerOctave) : 1e30;
      const bool   isLost = wanted > CoarseSize * thickness;
      const double onInterface = isLost ? thickness : wanted;
      const double inside = std::min(wanted, SizePerThickness * thickness);
      area += bin.area / std::pow(onInterface, 2);
      volume += bin.volume / std::pow(inside, 3) * (1.0 - EdgesAtRims * inside / thickness);
    }
  }
  MeshEstimate estimate;
  estimate.triangles = TrianglesPerArea * area;
  estimate.tetrahedra = m_SurfaceOnly ? 0.0 : TetrahedraPerVolume * volume;
  estimate.points = m_SurfaceOnly ? 0.5 * estimate.triangles
                                  : PointsPerTetrahedron * estimate.tetrahedra + PointsPerTriangle * estimate.triangles;
  const double bytes =
    m_SurfaceOnly ? BytesPerTriangle * estimate.triangles : BytesPerTetrahedron * estimate.tetrahedra;
  estimate.memory = std::max(m_MemoryOfImages, ShareOfImages * m_MemoryOfImages + bytes / Gigabyte);
  return estimate;
}

double
MeshEstimator::FactorFor(double tetrahedra) const
{
  double below = 0.0;
  double above = 1.0;
  if (this->Estimate(0.0, above).tetrahedra >= tetrahedra)
  {
    return above;
  }
  constexpr int Halvings = 30;
  for (int n = 0; n < Halvings; ++n)
  {
    const double middle = 0.5 * (below + above);
    (this->Estimate(0.0, middle).tetrahedra >= tetrahedra ? below : above) = middle;
  }
  return above;
}

double
MeshEstimator::SmallestSizeFor(double tetrahedra, double memory) const
{
  // larger sizes need not give smaller meshes: what they lose is found again
  constexpr double step = 1.03;
  for (double size = 0.5; size < 1000.0; size *= step)
  {
    const MeshEstimate estimate = this->Estimate(size);
    if (estimate.tetrahedra <= tetrahedra && estimate.memory <= memory)
    {
      return size;
    }
  }
  return std::numeric_limits<double>::infinity();
}
} // namespace mmm
