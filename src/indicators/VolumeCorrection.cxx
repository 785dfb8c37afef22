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
#include "indicators/VolumeCorrection.h"

#include "indicators/IndicatorSmoothing.h"
#include "base/ParallelCollect.h"
#include "indicators/BlockValue.h"
#include "indicators/PartVolumes.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
using Parameters = VolumeParameters;

constexpr std::size_t Grain = 1024;
constexpr std::size_t VoxelsPerRange = 65536;
constexpr float       BandWidth = float(IndicatorBandWidth);
/** An offset that is not known. */
constexpr float Unknown = 1e9f;

class VolumeCorrection
{
public:
  VolumeCorrection(const MaterialImage & image, std::vector<Block<float>> & indicators)
    : m_Image(image)
    , m_Indicators(indicators)
    , m_Parts(FindImageParts(image))
    , m_Volumes(image, m_Parts, indicators)
    , m_IsSettled(m_Parts.parts.size(), 0)
  {
    this->FindRim();
  }

  void
  Run()
  {
    for (int round = 0; round < Parameters::Rounds; ++round)
    {
      const auto shares = m_Volumes.Measure(m_Rim);
      const auto lacks = this->ComputeLacks(shares);
      if (std::all_of(lacks.begin(), lacks.end(), [](double lack) { return lack == 0.0; }))
      {
        break;
      }
      this->SettleParts(shares, lacks);
      const auto offsets = this->SolveForOffsets(shares, lacks);
      ParallelFor(m_Indicators.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t m = begin; m < end; ++m)
        {
          this->Offset(Material(m), offsets);
        }
      });
      this->KeepMargins();
    }
  }

private:
  void
  FindRim()
  {
    const Grid & grid = m_Image.grid;
    m_Rim = ParallelCollect<std::size_t>(
      grid.NumberOfNodes(), VoxelsPerRange, [&](std::size_t n, std::vector<std::size_t> & found) {
        if (m_Volumes.IsRim(grid.IndexAt(n)))
        {
          found.push_back(n);
        }
      });
    for (const auto & part : m_Parts.parts)
    {
      m_CoreVolumes.push_back(double(part.voxels));
    }
    for (const auto n : m_Rim)
    {
      m_CoreVolumes[m_Parts.numbers[n]] -= 1.0;
    }
    m_Margins.resize(m_Rim.size());
    ParallelFor(m_Rim.size(), Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
      {
        // centres that smoothing took to the other side stay there
        const Index at = grid.IndexAt(m_Rim[v]);
        const float gap = m_Volumes.Gap(at);
        m_Margins[v] = gap < 0.0f ? gap : CentreMarginOf(m_Image, at);
      }
    });
  }

  /** Per part the volume that it lacks, beyond what is tolerated; negative where it has too much. */
  std::vector<double>
  ComputeLacks(const PartShares & shares) const
  {
    std::vector<double> lacks(m_CoreVolumes);
    for (const auto & entry : shares.volumes)
    {
      lacks[entry.first] += entry.second;
    }
    for (std::size_t r = 0; r < lacks.size(); ++r)
    {
      const double voxels = double(m_Parts.parts[r].voxels);
      const double lack = voxels - lacks[r];
      lacks[r] =
        m_IsSettled[r] ? 0.0 : std::copysign(std::max(0.0, std::abs(lack) - Parameters::Tolerance * voxels), lack);
    }
    return lacks;
  }

  /** Parts that lack nothing, and that what others lack means little to, stay as they are from now on. */
  void
  SettleParts(const PartShares & shares, const std::vector<double> & lacks)
  {
    std::vector<double> changes(lacks.size(), 0.0);
    for (const auto & entry : shares.areas)
    {
      changes[entry.first.first] += std::abs(lacks[entry.first.second]);
      changes[entry.first.second] += std::abs(lacks[entry.first.first]);
    }
    for (std::size_t r = 0; r < lacks.size(); ++r)
    {
      m_IsSettled[r] |= lacks[r] == 0.0 && changes[r] < Parameters::Tolerance * double(m_Parts.parts[r].voxels);
    }
    std::size_t kept = 0;
    for (std::size_t v = 0; v < m_Rim.size(); ++v)
    {
      const auto nearby = m_Volumes.FindNearby(m_Image.grid.IndexAt(m_Rim[v]));
      if (std::any_of(
            nearby.parts, nearby.parts + nearby.count, [&](std::uint32_t part) { return !m_IsSettled[part]; }))
      {
        m_Rim[kept] = m_Rim[v];
        m_Margins[kept++] = m_Margins[v];
      }
    }
    m_Rim.resize(kept);
    m_Margins.resize(kept);
  }

  /** Per part what its indicator is to be raised by: the interface between two parts moves by half the difference of
   * their offsets, which changes their volumes by that times its area. By Gauss and Seidel's method. */
  std::vector<double>
  SolveForOffsets(const PartShares & shares, const std::vector<double> & lacks) const
  {
    std::vector<double>                                        areas(lacks.size(), 0.0);
    std::vector<std::vector<std::pair<std::uint32_t, double>>> contacts(lacks.size());
    for (const auto & entry : shares.areas)
    {
      const auto a = entry.first.first;
      const auto b = entry.first.second;
      areas[a] += entry.second;
      areas[b] += entry.second;
      contacts[a].push_back({ b, entry.second });
      contacts[b].push_back({ a, entry.second });
    }
    const auto & parts = m_Parts.parts;
    const auto   largest =
      std::max_element(
        parts.begin(), parts.end(), [](const ImagePart & a, const ImagePart & b) { return a.voxels < b.voxels; }) -
      parts.begin();
    std::vector<double> offsets(lacks.size(), 0.0);
    for (int sweep = 0; sweep < Parameters::Sweeps; ++sweep)
    {
      for (std::size_t r = 0; r < offsets.size(); ++r)
      {
        if (std::ptrdiff_t(r) == largest || m_IsSettled[r] || !(areas[r] > 0.0))
        {
          continue;
        }
        double sum = 2.0 * lacks[r];
        for (const auto & contact : contacts[r])
        {
          sum += contact.second * offsets[contact.first];
        }
        offsets[r] = std::min(std::max(sum / areas[r], -Parameters::LongestOffset), Parameters::LongestOffset);
      }
    }
    return offsets;
  }

  /** Offsets an indicator: by its parts' offsets within them, and likewise around them. */
  void
  Offset(Material m, const std::vector<double> & offsets)
  {
    auto &                   block = m_Indicators[m];
    std::vector<float>       field(block.values.size(), Unknown);
    std::vector<std::size_t> open;
    bool                     isMoved = false;
    std::size_t              n = 0;
    for (int k = 0; k < block.size[2]; ++k)
    {
      for (int j = 0; j < block.size[1]; ++j)
      {
        for (int i = 0; i < block.size[0]; ++i, ++n)
        {
          const auto voxel = m_Image.grid.Offset(i + block.lower[0], j + block.lower[1], k + block.lower[2]);
          if (m_Image.materials[voxel] == m)
          {
            field[n] = float(offsets[m_Parts.numbers[voxel]]);
            isMoved = isMoved || field[n] != 0.0f;
          }
          else if (block.values[n] > -BandWidth)
          {
            open.push_back(n);
          }
        }
      }
    }
    if (!isMoved)
    {
      return;
    }
    ContinueOffsets(block.size, std::move(open), field);
    for (n = 0; n < field.size(); ++n)
    {
      float &     value = block.values[n];
      const float depth = std::abs(value);
      if (field[n] != Unknown && depth < BandWidth)
      {
        value += field[n] * std::min(1.0f, (BandWidth - depth) / (BandWidth - Parameters::WholeDepth));
      }
    }
  }

  /** Gives nodes of a block the average of the offsets that their neighbours have already, from these outwards. */
  static void
  ContinueOffsets(const Index & size, std::vector<std::size_t> open, std::vector<float> & field)
  {
    const std::ptrdiff_t strides[3] = { 1, size[0], std::ptrdiff_t(size[0]) * size[1] };
    std::vector<float>   found;
    for (int round = 0; round < Parameters::Continuation; ++round)
    {
      found.assign(open.size(), Unknown);
      for (std::size_t o = 0; o < open.size(); ++o)
      {
        const auto n = std::ptrdiff_t(open[o]);
        const int  at[3] = { int(n % strides[1]), int(n / strides[1] % size[1]), int(n / strides[2]) };
        float      sum = 0.0f;
        int        count = 0;
        for (int a = 0; a < 3; ++a)
        {
          for (const int step : { -1, 1 })
          {
            if (at[a] + step >= 0 && at[a] + step < size[a] && field[n + step * strides[a]] != Unknown)
            {
              sum += field[n + step * strides[a]];
              ++count;
            }
          }
        }
        found[o] = count > 0 ? sum / float(count) : Unknown;
      }
      std::size_t left = 0;
      for (std::size_t o = 0; o < open.size(); ++o)
      {
        field[open[o]] = found[o];
        if (found[o] == Unknown)
        {
          open[left++] = open[o];
        }
      }
      open.resize(left);
    }
  }

  void
  KeepMargins()
  {
    const Grid & grid = m_Image.grid;
    ParallelFor(m_Rim.size(), Grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
      {
        const Index at = grid.IndexAt(m_Rim[v]);
        const float gap = m_Volumes.Gap(at);
        if (gap < m_Margins[v])
        {
          // nobody else looks at the own material's value here
          *FindValue(m_Indicators[m_Image.materials[m_Rim[v]]], at) += 2.0f * (m_Margins[v] - gap);
        }
      }
    });
  }

  const MaterialImage &       m_Image;
  std::vector<Block<float>> & m_Indicators;
  ImageParts                  m_Parts;
  PartVolumes                 m_Volumes;
  std::vector<char>           m_IsSettled;
  std::vector<double>         m_CoreVolumes; // of the voxels that no interface gets near to
  std::vector<std::size_t>    m_Rim;         // the others, as long as one of the parts around is not settled
  std::vector<float>          m_Margins;     // how far the interface has to stay from the centres of these
};
} // namespace

void
CorrectVolumes(const MaterialImage & image, std::vector<Block<float>> & indicators)
{
  VolumeCorrection(image, indicators).Run();
}
} // namespace mmm
