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
#include "indicators/CriticalPoint.h"
#include "base/Hash.h"
#include "indicators/IndicatorSmoothing.h"
#include "indicators/PassageWidening.h"
#include "indicators/SampleLattice.h"

#include "support/TestScenes.h"

#include "gtest/gtest.h"

using mmm::Index;
using mmm::Vector;

namespace
{
/** The indicators of some materials, before and after widening. */
class Widened
{
public:
  Widened(const mmm::MaterialImage & image, bool keepContacts)
    : m_Image(image)
    , m_Boxes(mmm::ComputeMaterialBoxes(image))
  {
    for (std::size_t m = 0; m < m_Boxes.size(); ++m)
    {
      m_Blocks.push_back(mmm::ComputeSmoothIndicator(image, mmm::Material(m), m_Boxes[m], 0.5));
    }
    before = std::make_unique<mmm::IndicatorSet>(mmm::MakeIndicatorSet(image.grid, m_Blocks));
    mmm::WidenPassages(image.grid, keepContacts, m_Blocks);
    after = std::make_unique<mmm::IndicatorSet>(mmm::MakeIndicatorSet(image.grid, m_Blocks));
  }

  std::unique_ptr<mmm::IndicatorSet> before;
  std::unique_ptr<mmm::IndicatorSet> after;

private:
  const mmm::MaterialImage            m_Image;
  const std::vector<mmm::MaterialBox> m_Boxes;
  std::vector<mmm::Block<float>>      m_Blocks;
};

/** A sheet of material 1, one voxel thick, between 0 and 2, that is as a function of x and y says there. */
template <typename TFunction>
mmm::MaterialImage
MakeSheet(const TFunction & heightAt)
{
  return mmmtest::MakeMaterials({ { 12, 12, 12 } }, Vector::Ones(), 3, [&](const Vector & x) {
    const int height = heightAt(int(x[0]), int(x[1]));
    return int(x[2]) < height ? 0 : int(x[2]) == height ? 1 : 2;
  });
}
/** From how many of a lattice's samples one finds a critical point at which neither material leads by a fifth of a
 * voxel.
 */
std::size_t
CountNarrow(const mmm::IndicatorSet & indicators)
{
  const mmm::SampleLattice lattice(indicators, 4);
  std::size_t              count = 0;
  for (std::size_t place = 0; place < lattice.NumberOfKept(); ++place)
  {
    Vector x = lattice.Position(lattice.SampleAt(place));
    count += mmm::FindCriticalPoint(indicators, 0, 1, 0.2, x) && std::abs(indicators.InsideOutside(1, x)) < 0.2;
  }
  return count;
}
} // namespace

TEST(PassageWidening, KeepsTheMaterialsOfNodes)
{
  // noise, which has all kinds of contacts
  const auto image = mmmtest::MakeMaterials({ { 9, 9, 9 } }, Vector::Ones(), 3, [](const Vector & x) {
    return mmm::Hash(std::uint64_t(x[0] + 9 * (x[1] + 9 * x[2]))) % 3;
  });
  for (const bool keepContacts : { false, true })
  {
    const Widened widened(image, keepContacts);
    for (std::size_t n = 0; n < image.grid.NumberOfNodes(); ++n)
    {
      EXPECT_EQ(widened.after->MaterialAt(image.grid.Position(image.grid.IndexAt(n))), image.materials[n]);
    }
  }
}

TEST(PassageWidening, MakesTheContactOfTwoVoxelsWider)
{
  // two columns that touch in an edge
  const Widened widened(
    mmmtest::MakeMaterials({ { 12, 12, 12 } },
                           Vector::Ones(),
                           2,
                           [](const Vector & x) { return (x[0] < 5.5) == (x[1] < 5.5) && x[2] > 3.5 && x[2] < 8.5; }),
    false);
  const Vector contact(5.5, 5.5, 6.0);
  EXPECT_LT(std::abs(widened.before->InsideOutside(1, contact)), 0.2);
  EXPECT_GT(std::abs(widened.after->InsideOutside(1, contact)), 0.35);
}

TEST(PassageWidening, LeavesFewNarrowPassagesBetweenSamples)
{
  const auto    image = mmmtest::MakeMaterials({ { 16, 16, 16 } }, Vector::Ones(), 2, [](const Vector & x) {
    const Vector wave = (0.9 * x + Vector(0.3, 0.7, 0.1)).array().sin();
    return wave[0] * wave[1] + wave[1] * wave[2] + wave[2] * wave[0] > 0.0;
  });
  const Widened widened(image, true);
  const auto    before = CountNarrow(*widened.before);
  const auto    after = CountNarrow(*widened.after);
  EXPECT_GT(before, 100u);
  EXPECT_LT(after, before / 50);
}

TEST(PassageWidening, ClosesSheetsThatStepOverEdges)
{
  const Widened widened(MakeSheet([](int i, int) { return i < 6 ? 5 : 6; }), true);
  EXPECT_GT(widened.after->InsideOutside(1, Vector(5.5, 5.5, 5.5)), 0.2);
}

TEST(PassageWidening, LeavesABallAlone)
{
  const auto    image = mmmtest::MakeBallMaterials(20, Vector::Constant(9.5), 5.3);
  const Widened widened(image, true);
  for (std::size_t n = 0; n < image.grid.NumberOfNodes(); ++n)
  {
    const Index at = image.grid.IndexAt(n);
    EXPECT_EQ(widened.after->ValueAtNode(1, at), widened.before->ValueAtNode(1, at));
  }
}

TEST(PassageWidening, RaisesMaterialsOnlyWhereTheirVoxelsTouch)
{
  const auto image = mmmtest::MakeMaterials({ { 12, 12, 12 } }, Vector::Ones(), 6, [](const Vector & x) {
    return mmm::Hash(std::uint64_t(x[0] + 12 * (x[1] + 12 * x[2]))) % 6;
  });
  const auto touches = [&](mmm::Material m, const Index & at) {
    for (int n = 0; n < 27; ++n)
    {
      const Index other{ { at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1 } };
      if (image.grid.Contains(other) && image.materials[image.grid.Offset(other)] == m)
      {
        return true;
      }
    }
    return false;
  };
  std::size_t apart = 0;
  std::size_t raised = 0;
  for (const bool keepContacts : { false, true })
  {
    const Widened widened(image, keepContacts);
    for (std::size_t n = 0; n < image.grid.NumberOfNodes(); ++n)
    {
      const Index  at = image.grid.IndexAt(n);
      const Vector x = image.grid.Position(at);
      for (mmm::Material m = 0; m < 6; ++m)
      {
        const double gain = widened.after->Value(m, x) - widened.before->Value(m, x);
        if (touches(m, at))
        {
          raised += gain > 0.01;
        }
        else
        {
          ++apart;
          EXPECT_LE(gain, 1e-6);
        }
      }
    }
  }
  EXPECT_GT(apart, 50u);
  EXPECT_GT(raised, 50u);
}
