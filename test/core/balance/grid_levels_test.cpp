// SPDX-License-Identifier: BSD-3-Clause
// Grids of a method, and the choice of a finer one by `method: auto`.
#include "core/balance/grid_levels.h"

#include <gtest/gtest.h>

#include <string>

using namespace wheel_rail_contact::core;

namespace
{
ContactModelConfig withTolerance(double tolerance)
{
  ContactModelConfig config;
  config.contact.tolerance = tolerance;
  return config;
}

int cells(const GridSize& size)
{
  return size.along * size.across;
}
}  // namespace

TEST(GridLevels, ASmallerToleranceHasNoCoarserFirstGrid)
{
  int before = 0;
  for (const double tolerance : {0.1, 0.03, 0.01, 0.003, 0.001})
  {
    const GridLevels levels(withTolerance(tolerance));
    EXPECT_GE(cells(levels.at(0)), before) << tolerance;
    before = cells(levels.at(0));
    for (std::size_t k = 1; k < levels.count(); ++k)
    {
      EXPECT_GT(cells(levels.at(k)), cells(levels.at(k - 1))) << tolerance;
    }
  }
  EXPECT_GT(before, cells(GridLevels(withTolerance(0.1)).at(0)));
}

// The error falls with the number of cells.
TEST(GridLevels, TheNextGridIsTheFirstOneExpectedToMeetTheTolerance)
{
  constexpr double tolerance = 0.01;
  const GridLevels levels(withTolerance(tolerance));
  ASSERT_GT(levels.count(), 2U);
  for (std::size_t level = 0; level + 1 < levels.count(); ++level)
  {
    EXPECT_EQ(levels.finer(level, 0), level);
    EXPECT_EQ(levels.finer(level, tolerance), level);
    EXPECT_EQ(levels.finer(level, 1.001 * tolerance), level + 1);
    const double twice = tolerance * cells(levels.at(level + 1)) / cells(levels.at(level));
    EXPECT_EQ(levels.finer(level, 0.999 * twice), level + 1);
    EXPECT_EQ(levels.finer(level, 1.001 * twice), std::min(level + 2, levels.count() - 1));
    EXPECT_EQ(levels.finer(level, 1e6), levels.count() - 1);
  }
}

TEST(GridLevels, TheFinestGridIsKeptWhateverItsError)
{
  const GridLevels levels(withTolerance(0.01));
  EXPECT_EQ(levels.finer(levels.count() - 1, 1), levels.count() - 1);
}

TEST(GridLevels, EveryOtherMethodHasOneGrid)
{
  for (const NormalMethod method : all_normal_methods)
  {
    ContactModelConfig config;
    config.contact.method = method;
    const GridLevels levels(config);
    EXPECT_EQ(levels.count() == 1, method != NormalMethod::automatic) << toString(method);
    EXPECT_EQ(levels.solver().name(),
              std::string(method == NormalMethod::automatic ? "conjugate_gradient" : toString(method)));
  }
}

TEST(GridLevels, AGivenGridIsTheOnlyOne)
{
  ContactModelConfig config;
  config.contact.cells_along = 10;
  config.contact.cells_across = 26;
  const GridLevels levels(config);
  ASSERT_EQ(levels.count(), 1U);
  EXPECT_EQ(levels.at(0), (GridSize{10, 26}));
  EXPECT_EQ(levels.finer(0, 1), 0U);
}
