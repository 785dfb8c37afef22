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
#include "topology/PartitionTopology.h"

#include "base/DisjointSets.h"
#include "base/Parallel.h"
#include "topology/SampleCharacteristics.h"

#include <algorithm>

namespace mmm
{
namespace
{
using RowReader = std::function<void(int, int, std::vector<Material> &)>;

/** Samples [begin, end) of a row. */
struct Run
{
  int begin;
  int end;
};

/** The runs of one material, ascending by row. */
struct MaterialRuns
{
  std::vector<Run>         runs;
  std::vector<std::size_t> rows;
};

/** What a material has of simplices of 0 to 3 dimensions, with alternating signs. */
using Characteristics = std::vector<std::ptrdiff_t>;

/** Two neighbouring layers of samples with a frame of no material around them. */
class LayerReader
{
public:
  LayerReader(const Index & size, std::size_t numberOfMaterials, const RowReader & row)
    : m_Size(size)
    , m_Nothing(Material(numberOfMaterials))
    , m_Row(row)
    , m_Layers{ std::vector<Material>(std::size_t(size[0] + 2) * (size[1] + 2), m_Nothing),
                std::vector<Material>(std::size_t(size[0] + 2) * (size[1] + 2), m_Nothing) }
  {}

  /** Makes layer k the upper one and what was the upper one the lower. */
  void
  Advance(int k)
  {
    std::swap(m_Layers[0], m_Layers[1]);
    if (k < 0 || k >= m_Size[2])
    {
      std::fill(m_Layers[1].begin(), m_Layers[1].end(), m_Nothing);
      return;
    }
    for (int j = 0; j < m_Size[1]; ++j)
    {
      m_Row(j, k, m_Labels);
      std::copy(m_Labels.begin(), m_Labels.end(), m_Layers[1].begin() + this->Offset(0, j));
    }
  }

  /** A sample of the lower or the upper layer; the size is allowed. */
  Material
  At(int layer, int i, int j) const
  {
    return m_Layers[layer][this->Offset(i, j)];
  }

private:
  std::size_t
  Offset(int i, int j) const
  {
    return std::size_t(j + 1) * (m_Size[0] + 2) + (i + 1);
  }

  const Index           m_Size;
  const Material        m_Nothing;
  const RowReader &     m_Row;
  std::vector<Material> m_Layers[2];
  std::vector<Material> m_Labels;
};

/** A run and where it is. */
struct PlacedRun
{
  Material    material;
  std::size_t row;
  Run         run;
};

/** Adds the runs of a row of the lower layer. */
void
ListRuns(const LayerReader & reader, int rowLength, int j, std::size_t row, std::vector<PlacedRun> & runs)
{
  for (int i = 0; i < rowLength;)
  {
    const Material material = reader.At(0, i, j);
    const int      begin = i;
    for (++i; i < rowLength && reader.At(0, i, j) == material; ++i)
    {
    }
    runs.push_back({ material, row, { begin, i } });
  }
}

/** Reads the samples once: their Euler characteristics and their runs. */
Characteristics
ReadSamples(const Index & size, const RowReader & row, std::vector<MaterialRuns> & materials)
{
  constexpr int                       LayersPerRange = 8;
  const std::size_t                   numberOfMaterials = materials.size();
  const std::size_t                   ranges = (size[2] + LayersPerRange - 1) / LayersPerRange;
  std::vector<Characteristics>        sums(ranges, Characteristics(numberOfMaterials, 0));
  std::vector<std::vector<PlacedRun>> runs(ranges);
  ParallelFor(size[2], LayersPerRange, [&](std::size_t begin, std::size_t end) {
    const std::size_t range = begin / LayersPerRange;
    LayerReader       reader(size, numberOfMaterials, row);
    reader.Advance(int(begin));
    for (int k = int(begin); k < int(end); ++k)
    {
      reader.Advance(k + 1);
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const Material own = reader.At(0, i, j);
          if (own < numberOfMaterials)
          {
            unsigned same = 0;
            for (int n = 1; n < 8; ++n)
            {
              same |= unsigned(reader.At(n >> 2, i + (n & 1), j + (n >> 1 & 1)) == own) << (n - 1);
            }
            sums[range][own] += CountSimplices(same);
          }
        }
      }
      for (int j = 0; j < size[1]; ++j)
      {
        ListRuns(reader, size[0], j, std::size_t(k) * size[1] + j, runs[range]);
      }
    }
  });
  Characteristics total(numberOfMaterials, 0);
  for (std::size_t range = 0; range < ranges; ++range)
  {
    std::transform(sums[range].begin(), sums[range].end(), total.begin(), total.begin(), std::plus<>());
    for (const auto & placed : runs[range])
    {
      if (placed.material < numberOfMaterials)
      {
        materials[placed.material].runs.push_back(placed.run);
        materials[placed.material].rows.push_back(placed.row);
      }
    }
  }
  return total;
}

/** Parts [begin, end) of the rows of a box. */
struct Intervals
{
  /** Both in numbers of rows. */
  int                      width;
  int                      height;
  std::vector<Run>         intervals;
  std::vector<std::size_t> start;
};

/** Samples are connected if the indices of one exceed those of the other by 0 or 1 each. */
std::ptrdiff_t
CountComponents(const Intervals & rows)
{
  constexpr int Earlier[3][2] = { { -1, 0 }, { 0, -1 }, { -1, -1 } };
  DisjointSets  sets(rows.intervals.size());
  for (int k = 0; k < rows.height; ++k)
  {
    for (int j = 0; j < rows.width; ++j)
    {
      for (const auto & step : Earlier)
      {
        const int otherJ = j + step[0];
        const int otherK = k + step[1];
        if (otherJ < 0 || otherK < 0)
        {
          continue;
        }
        const std::size_t row = std::size_t(k) * rows.width + j;
        const std::size_t other = std::size_t(otherK) * rows.width + otherJ;
        std::size_t       a = rows.start[row];
        std::size_t       b = rows.start[other];
        while (a != rows.start[row + 1] && b != rows.start[other + 1])
        {
          const auto & here = rows.intervals[a];
          const auto & earlier = rows.intervals[b];
          if (here.begin <= earlier.end && earlier.begin < here.end)
          {
            sets.Unite(std::uint32_t(a), std::uint32_t(b));
          }
          ++(here.end <= earlier.end ? a : b);
        }
      }
    }
  }
  std::ptrdiff_t components = 0;
  for (std::uint32_t i = 0; i < sets.size(); ++i)
  {
    components += sets.Find(i) == i;
  }
  return components;
}

/** What a material covers or, in a box that is larger by one on each side, what it leaves. */
Intervals
IntervalsOf(const MaterialRuns & material, int rowsOfLayer, bool complement)
{
  const int frame = complement ? 1 : 0;
  int       lower[3] = { material.runs[0].begin, rowsOfLayer, int(material.rows.front() / rowsOfLayer) };
  int       upper[3] = { 0, 0, int(material.rows.back() / rowsOfLayer) + 1 };
  for (std::size_t r = 0; r < material.runs.size(); ++r)
  {
    lower[0] = std::min(lower[0], material.runs[r].begin);
    upper[0] = std::max(upper[0], material.runs[r].end);
    lower[1] = std::min(lower[1], int(material.rows[r] % rowsOfLayer));
    upper[1] = std::max(upper[1], int(material.rows[r] % rowsOfLayer) + 1);
  }
  Intervals result;
  result.width = upper[1] - lower[1] + 2 * frame;
  result.height = upper[2] - lower[2] + 2 * frame;
  result.start.assign(1, 0);
  std::size_t r = 0;
  for (int k = lower[2] - frame; k < upper[2] + frame; ++k)
  {
    for (int j = lower[1] - frame; j < upper[1] + frame; ++j)
    {
      int        end = lower[0] - 1;
      const bool isInside = k >= lower[2] && k < upper[2] && j >= lower[1] && j < upper[1];
      for (; isInside && r < material.runs.size() && material.rows[r] == std::size_t(k) * rowsOfLayer + j; ++r)
      {
        const Run & run = material.runs[r];
        result.intervals.push_back(complement ? Run{ end, run.begin } : Run{ run.begin, run.end });
        end = run.end;
      }
      if (complement)
      {
        result.intervals.push_back({ end, upper[0] + 1 });
      }
      result.start.push_back(result.intervals.size());
    }
  }
  return result;
}

} // namespace

std::vector<BettiNumbers>
ComputeSampleTopology(const Index & size, std::size_t numberOfMaterials, const RowReader & row)
{
  std::vector<MaterialRuns> materials(numberOfMaterials);
  const Characteristics     characteristics = ReadSamples(size, row, materials);
  std::vector<BettiNumbers> result(numberOfMaterials);
  ParallelFor(numberOfMaterials, 1, [&](std::size_t m, std::size_t) {
    if (!materials[m].runs.empty())
    {
      const auto components = CountComponents(IntervalsOf(materials[m], size[1], false));
      const auto cavities = CountComponents(IntervalsOf(materials[m], size[1], true)) - 1;
      result[m] = { { components, components + cavities - characteristics[m], cavities } };
    }
  });
  return result;
}

std::vector<BettiNumbers>
ComputePartitionTopology(const SampleLattice & lattice, const SampledMaterials & partition)
{
  const Index & size = lattice.GetSize();
  return ComputeSampleTopology(
    size, lattice.GetIndicators().GetNumberOfMaterials(), [&](int j, int k, std::vector<Material> & labels) {
      labels.resize(size[0]);
      for (int i = 0; i < size[0]; ++i)
      {
        labels[i] = lattice.At(partition, { { i, j, k } });
      }
    });
}
} // namespace mmm
