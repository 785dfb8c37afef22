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
#include "sizing/MedialAxis.h"

#include "base/MakeUnique.h"
#include "base/Parallel.h"
#include "sizing/SourcePropagation.h"

#include <algorithm>
#include <cmath>

namespace mmm
{
namespace
{
constexpr double JunctionReach = 2.5;
constexpr double JunctionTolerance = 0.01;
constexpr double ThinLayer = 3.0;
constexpr double ProbeStep = 0.3;
constexpr double LeastDepth = 1.0;
constexpr double LeastSeparation = 1.5;
/** The nearest sample is at most this far from the foot. */
constexpr double LongestRefinement = 1.0;
constexpr double LongestCorrection = 0.75;

/** The nodes that a node's feet are compared with. Around an isolated axis point, such as a ball's centre, only
 * neighbours across a diagonal see their feet on opposite sides; they lie further apart and have to differ by more. */
struct NeighbourStep
{
  int    offset[3];
  double largestCosine;
};
constexpr NeighbourStep NeighbourSteps[] = { { { 1, 0, 0 }, 0.0 },   { { 0, 1, 0 }, 0.0 },   { { 0, 0, 1 }, 0.0 },
                                             { { 1, 1, 1 }, -0.5 },  { { 1, 1, -1 }, -0.5 }, { { 1, -1, 1 }, -0.5 },
                                             { { 1, -1, -1 }, -0.5 } };

/** Where three materials meet: per brick of the grid the triples of a junction within JunctionReach of it. */
class JunctionTable
{
public:
  explicit JunctionTable(const IndicatorSet & indicators)
    : m_Indicators(indicators)
  {
    const Grid & grid = indicators.GetGrid();
    for (int a = 0; a < 3; ++a)
    {
      m_Edge[a] = std::max(2, int(std::ceil(4.0 / grid.spacing[a])));
      m_Bricks[a] = (grid.size[a] + m_Edge[a] - 1) / m_Edge[a];
    }
    std::vector<std::vector<std::pair<std::size_t, Cell>>> found(grid.size[2] + 1);
    // dual cubes reach beyond the border, where a plane takes the place of the nodes that are not there
    ParallelFor(grid.size[2] + 1, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
      {
        this->CollectCubes(int(k) - 1, found[k]);
      }
    });
    m_Triples.resize(std::size_t(m_Bricks[0]) * m_Bricks[1] * m_Bricks[2]);
    for (const auto & list : found)
    {
      for (const auto & entry : list)
      {
        m_Triples[entry.first].push_back(entry.second);
      }
    }
    for (auto & triples : m_Triples)
    {
      MakeUnique(triples);
    }
  }

  bool
  HasNear(const Cell & triple, const Vector & x) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    std::size_t  brick[3];
    for (int a = 0; a < 3; ++a)
    {
      const int node = int(std::floor(x[a] / grid.spacing[a] + 0.5));
      brick[a] = std::min(std::max(node, 0), grid.size[a] - 1) / m_Edge[a];
    }
    const auto & triples = m_Triples[(brick[2] * m_Bricks[1] + brick[1]) * m_Bricks[0] + brick[0]];
    if (!std::binary_search(triples.begin(), triples.end(), triple))
    {
      return false;
    }
    // the sides of a layer that is thinner than a dual cube do not meet
    Vector junction = x;
    return m_Indicators.Project(triple, junction, JunctionReach) &&
           m_Indicators.CellIndicator(triple, junction) < JunctionTolerance;
  }

private:
  void
  CollectCubes(int k, std::vector<std::pair<std::size_t, Cell>> & found) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    for (int j = -1; j < grid.size[1]; ++j)
    {
      for (int i = -1; i < grid.size[0]; ++i)
      {
        Material present[14];
        int      count = 0;
        for (int corner = 0; corner < 8; ++corner)
        {
          const Index    node{ { i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2) } };
          const Material m = this->MaterialAt(node);
          if (std::find(present, present + count, m) == present + count)
          {
            present[count++] = m;
          }
        }
        if (count >= 3)
        {
          this->AddTriples(Index{ { i, j, k } }, present, count, found);
        }
      }
    }
  }

  Material
  MaterialAt(const Index & node) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    for (int a = 0; a < 3; ++a)
    {
      if (node[a] < 0 || node[a] >= grid.size[a])
      {
        return Material(m_Indicators.GetNumberOfMaterials() + 2 * a + (node[a] < 0 ? 0 : 1));
      }
    }
    return m_Indicators.MaterialAtNode(grid.Offset(node));
  }

  void
  AddTriples(const Index & cube, Material * present, int count, std::vector<std::pair<std::size_t, Cell>> & found) const
  {
    const Grid & grid = m_Indicators.GetGrid();
    int          low[3];
    int          high[3];
    for (int a = 0; a < 3; ++a)
    {
      const double reach = JunctionReach / grid.spacing[a];
      low[a] = std::max(0, int(std::floor(cube[a] - reach + 0.5))) / m_Edge[a];
      high[a] = std::min(grid.size[a] - 1, int(std::ceil(cube[a] + reach + 0.5))) / m_Edge[a];
    }
    for (int a = 0; a < count; ++a)
    {
      for (int b = a + 1; b < count; ++b)
      {
        for (int c = b + 1; c < count; ++c)
        {
          const Cell triple{ present[a], present[b], present[c] };
          for (int z = low[2]; z <= high[2]; ++z)
          {
            for (int y = low[1]; y <= high[1]; ++y)
            {
              for (int x = low[0]; x <= high[0]; ++x)
              {
                found.push_back({ (std::size_t(z) * m_Bricks[1] + y) * m_Bricks[0] + x, triple });
              }
            }
          }
        }
      }
    }
  }

  const IndicatorSet &           m_Indicators;
  Index                          m_Edge;
  Index                          m_Bricks;
  std::vector<std::vector<Cell>> m_Triples;
};

/** Whether the feet p and q, on the interfaces of `own` with `atP` and `atQ`, belong to one junction's wedge. */
bool
MeetInJunction(const JunctionTable & junctions,
               Material              own,
               Material              atP,
               Material              atQ,
               const Vector &        p,
               const Vector &        q)
{
  if (atP == atQ || atP == own || atQ == own)
  {
    return false;
  }
  const Cell triple{ own, atP, atQ };
  return junctions.HasNear(triple, p) || junctions.HasNear(triple, q);
}

/** The foot of x on the plane that touches the interface at a sample, which is known to be near. */
Vector
RefineFoot(const InterfaceSample & sample, const Vector & x)
{
  const Vector away = x - sample.position;
  const Vector along = away - away.dot(sample.normal) * sample.normal;
  const double length = along.norm();
  return sample.position + (length > LongestRefinement ? Vector(along * (LongestRefinement / length)) : along);
}

/** The point between x and y that is as far from p as from q. */
Vector
EquidistantPoint(const Vector & x, const Vector & y, const Vector & p, const Vector & q)
{
  const Vector apart = q - p;
  const double slope = (y - x).dot(apart);
  const double fraction = slope > 0.0 ? (0.5 * (p + q) - x).dot(apart) / slope : 0.5;
  return x + std::min(std::max(fraction, 0.0), 1.0) * (y - x);
}

/** The centre of the ball that touches the interfaces at p and q, by the normals there, near a guess. Normals are known
 * less well than feet: they do not move the guess by more than LongestCorrection. */
Vector
BallCentre(const Vector & guess, const Vector & p, const Vector & normalAtP, const Vector & q, const Vector & normalAtQ)
{
  // a ball through both that touches the plane of normal n at one of them has the radius |q - p|^2 / 2 n (q - p)
  const Vector apart = q - p;
  const double slopeP = normalAtP.dot(apart);
  const double slopeQ = normalAtQ.dot(apart);
  const double square = apart.squaredNorm();
  if (std::min(slopeP * slopeP, slopeQ * slopeQ) < 0.25 * square)
  {
    return guess;
  }
  const Vector centre = 0.5 * (p + q) + 0.25 * square * (normalAtP / slopeP - normalAtQ / slopeQ);
  const Vector correction = centre - guess;
  const double length = correction.norm();
  return guess + (length > LongestCorrection ? Vector(correction * (LongestCorrection / length)) : correction);
}

Material
Opposite(const InterfaceSample & sample, Material own)
{
  return sample.first == own ? sample.second : sample.first;
}

/** Whether the nodes along a line into a material are all its own, as far as a thin layer may reach. */
bool
IsThick(const IndicatorSet & indicators, const Vector & from, const Vector & inwards, Material own)
{
  const Grid & grid = indicators.GetGrid();
  for (double t = 3.0 * ProbeStep; t <= ThinLayer + 3.0 * ProbeStep; t += 3.0 * ProbeStep)
  {
    Index node;
    for (int a = 0; a < 3; ++a)
    {
      node[a] = int(std::floor((from[a] + t * inwards[a]) / grid.spacing[a] + 0.5));
    }
    if (!grid.Contains(node) || indicators.MaterialAtNode(grid.Offset(node)) != own)
    {
      return false;
    }
  }
  return true;
}

/** The axis point across a thin layer, from `sample` into the material `own`. Returns false where there is none. */
bool
ProbeThinLayer(const IndicatorSet &    indicators,
               const JunctionTable &   junctions,
               const InterfaceSample & sample,
               Material                own,
               Vector &                axisPoint)
{
  const Vector inwards = sample.first == own ? Vector(-sample.normal) : sample.normal;
  if (IsThick(indicators, sample.position, inwards, own))
  {
    return false;
  }
  double inside = 0.0;
  double outside = 0.0;
  for (double t = ProbeStep; t <= ThinLayer + ProbeStep; t += ProbeStep)
  {
    if (indicators.MaterialAt(sample.position + t * inwards) != own)
    {
      outside = t;
      break;
    }
    inside = t;
  }
  if (outside == 0.0 || inside == 0.0)
  {
    return false;
  }
  const Material other = indicators.MaterialAt(sample.position + outside * inwards);
  for (int halving = 0; halving < 4; ++halving)
  {
    const double t = 0.5 * (inside + outside);
    (indicators.MaterialAt(sample.position + t * inwards) == own ? inside : outside) = t;
  }
  const double thickness = 0.5 * (inside + outside);
  const Vector end = sample.position + thickness * inwards;
  const Vector across = indicators.Normal(Cell{ own, other }, end) * (own < other ? 1.0 : -1.0);
  if (across.dot(inwards) < 0.0 || MeetInJunction(junctions, own, Opposite(sample, own), other, sample.position, end))
  {
    return false;
  }
  axisPoint = sample.position + 0.5 * thickness * inwards;
  return true;
}

std::vector<Vector>
ProbeAll(const IndicatorSet & indicators, const JunctionTable & junctions, const std::vector<InterfaceSample> & samples)
{
  constexpr std::size_t            Grain = 4096;
  std::vector<std::vector<Vector>> parts((samples.size() + Grain - 1) / Grain);
  ParallelFor(samples.size(), Grain, [&](std::size_t begin, std::size_t end) {
    auto & part = parts[begin / Grain];
    for (std::size_t s = begin; s < end; ++s)
    {
      for (const Material own : { samples[s].first, samples[s].second })
      {
        Vector axisPoint;
        if (!indicators.IsPlane(own) && ProbeThinLayer(indicators, junctions, samples[s], own, axisPoint))
        {
          part.push_back(axisPoint);
        }
      }
    }
  });
  std::vector<Vector> axis;
  for (const auto & part : parts)
  {
    axis.insert(axis.end(), part.begin(), part.end());
  }
  return axis;
}

/** Grid neighbours whose feet lie apart and are seen under a wide angle. */
std::vector<Vector>
CompareFeet(const IndicatorSet &                 indicators,
            const JunctionTable &                junctions,
            const std::vector<InterfaceSample> & samples,
            const PropagatedField &              feet)
{
  const Grid &                     grid = indicators.GetGrid();
  std::vector<std::vector<Vector>> parts(grid.size[2]);
  ParallelFor(grid.size[2], 1, [&](std::size_t begin, std::size_t end) {
    for (int k = int(begin); k < int(end); ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          const Index       at{ { i, j, k } };
          const std::size_t n = grid.Offset(at);
          if (!(feet.values[n] >= LeastDepth) || feet.sources[n] == PropagatedField::NoSource)
          {
            continue;
          }
          const Vector            x = grid.Position(at);
          const InterfaceSample & p = samples[feet.sources[n]];
          for (const auto & step : NeighbourSteps)
          {
            const Index after{ { i + step.offset[0], j + step.offset[1], k + step.offset[2] } };
            if (!grid.Contains(after))
            {
              continue;
            }
            const std::size_t m = grid.Offset(after);
            if (feet.sources[m] == feet.sources[n] || !(feet.values[m] >= LeastDepth) ||
                indicators.MaterialAtNode(m) != indicators.MaterialAtNode(n))
            {
              continue;
            }
            const Vector            y = grid.Position(after);
            const InterfaceSample & q = samples[feet.sources[m]];
            const Vector            atP = RefineFoot(p, x);
            const Vector            atQ = RefineFoot(q, y);
            const Vector            toP = atP - x;
            const Vector            toQ = atQ - y;
            if ((atP - atQ).squaredNorm() < LeastSeparation * LeastSeparation ||
                toP.dot(toQ) > step.largestCosine * toP.norm() * toQ.norm())
            {
              continue;
            }
            const Material own = indicators.MaterialAtNode(n);
            if (!MeetInJunction(junctions, own, Opposite(p, own), Opposite(q, own), atP, atQ))
            {
              parts[k].push_back(BallCentre(EquidistantPoint(x, y, atP, atQ), atP, p.normal, atQ, q.normal));
            }
          }
        }
      }
    }
  });
  std::vector<Vector> axis;
  for (const auto & part : parts)
  {
    axis.insert(axis.end(), part.begin(), part.end());
  }
  return axis;
}
} // namespace

std::vector<Vector>
ComputeMedialAxis(const IndicatorSet & indicators, const std::vector<InterfaceSample> & samples)
{
  std::vector<Source> sources;
  sources.reserve(samples.size());
  for (const auto & sample : samples)
  {
    sources.push_back({ sample.position.cast<float>(), 0.0f });
  }
  const JunctionTable   junctions(indicators);
  const PropagatedField feet = PropagateSources(indicators.GetGrid(), sources, 1.0);
  std::vector<Vector>   axis = CompareFeet(indicators, junctions, samples, feet);
  const auto            thin = ProbeAll(indicators, junctions, samples);
  axis.insert(axis.end(), thin.begin(), thin.end());
  return axis;
}
} // namespace mmm
