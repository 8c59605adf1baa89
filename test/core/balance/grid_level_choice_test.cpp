// SPDX-License-Identifier: BSD-3-Clause
// Which grid `method: auto` takes, and what it remembers of places where one was too coarse.
#include <gtest/gtest.h>

#include <cmath>

#include "core/balance/grid_levels.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double tolerance = 0.01;

const GridLevels& levels()
{
  static const GridLevels all{ContactModelConfig()};
  return all;
}

/// What a contact shows on a grid whose errors are those typical of one kind of contact; `size` [-] is its error on
/// 24 × 56 cells.
ErrorEstimate ofJump(const GridLevel& level, double size)
{
  return {size * level.typical.max_pressure, 0, 0, 0};
}

ErrorEstimate ofTail(const GridLevel& level, double size)
{
  return {0, size * level.typical.narrow_ends, 0, size * level.typical.narrow_ends};
}

ErrorEstimate ofApproach(const GridLevel& level, double size)
{
  return {0, 0, size * level.typical.approach, 0};
}

int cells(const GridLevel& level)
{
  return level.size.along * level.size.across;
}

constexpr ErrorEstimate hopeless{1, 1, 1, 1};  ///< no grid promises to bring that below the tolerance

/// Sets out from cold on the coarsest grid and climbs until an answer would do, in at most four steps.
template <typename Errors>
GridLevelChoice settled(Errors errors)
{
  GridLevelChoice choice(levels(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  EXPECT_EQ(cells(choice.level()), cells(levels().at(0)));
  int climbs = 0;
  while (choice.refine(errors(choice.level())))
  {
    ++climbs;
  }
  EXPECT_LE(climbs, 4);
  return choice;
}

constexpr double just_within = 0.95 * tolerance;

/// On 24 × 56 cells, which the approach there just needs.
GridLevelChoice onUnitGrid()
{
  GridLevelChoice choice = settled([](const GridLevel& level) { return ofApproach(level, just_within); });
  EXPECT_EQ(cells(choice.level()), 24 * 56);
  return choice;
}

constexpr double elsewhere = 1e-3;  ///< [m]

/// A step down from there at another place, with a jump of the curvature, which needs less.
GridLevelChoice aStepBelowUnitGrid()
{
  GridLevelChoice choice = onUnitGrid();
  choice.arrive(elsewhere);
  choice.coarsen(ofJump(choice.level(), 0.85 * tolerance));
  EXPECT_EQ(cells(choice.level()), 16 * 64);
  return choice;
}

TEST(GridLevelChoice, JumpsOfTheCurvatureTakeCellsAcrossAndTailsCellsAlong)
{
  const GridLevel& jump = settled([](const GridLevel& level) { return ofJump(level, 0.95 * tolerance); }).level();
  EXPECT_EQ(jump.size.along, 16);
  EXPECT_EQ(jump.size.across, 64);
  const GridLevel& narrow_end = settled([](const GridLevel& level) { return ofTail(level, 0.8 * tolerance); }).level();
  EXPECT_EQ(narrow_end.size.along, 24);
  EXPECT_EQ(narrow_end.size.across, 56);
}

// A tail of 1.1 times the tolerance finds 32 × 96 cells: the grids before that have no more cells along than the 24 ×
// 56 that failed, promise worse, and are passed over.
TEST(GridLevelChoice, EachStepIsBetterThanWhatFailed)
{
  const auto narrow_end = [](const GridLevel& level) { return ofTail(level, 1.1 * tolerance).largest(); };
  double before = INFINITY;
  GridLevelChoice choice(levels(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  do
  {
    EXPECT_LT(narrow_end(choice.level()), before);
    before = narrow_end(choice.level());
  } while (choice.refine(ofTail(choice.level(), 1.1 * tolerance)));
  EXPECT_EQ(cells(choice.level()), 32 * 96);
}

// What the algebra leaves is the same on all grids.
TEST(GridLevelChoice, AnErrorThatNoGridPredictsToLowerTakesTheNextOne)
{
  GridLevelChoice choice(levels(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  const ErrorEstimate algebra = ofResidual(tolerance);
  ASSERT_GT(algebra.largest(), tolerance);
  ASSERT_TRUE(choice.refine(algebra));
  EXPECT_EQ(cells(choice.level()), cells(levels().at(1)));
}

// Far too coarse, as its promise tells, or by a tenth, as it itself has shown.
TEST(GridLevelChoice, AGridThatWasTooCoarseAtAPlaceIsNotTakenThereFor64Results)
{
  constexpr double here = 0;  // [m]
  for (const double size : {0.5 * tolerance, 1.1 * tolerance / levels().at(0).typical.max_pressure})
  {
    const auto hard = [size](const GridLevel& level) { return ofJump(level, size); };
    for (const int away : {20, 62, 63})
    {
      GridLevelChoice choice = settled(hard);
      const GridLevel& needed = choice.level();
      for (int result = 0; result < away; ++result)
      {
        choice.arrive(elsewhere);
        choice.coarsen(ofJump(choice.level(), 1e-4 * tolerance));
      }
      ASSERT_LT(cells(choice.level()), cells(needed)) << "easy places let it come down";
      choice.arrive(here);
      EXPECT_EQ(hard(choice.level()).largest() <= tolerance, away < 63) << away << " answers later";
    }
  }
}

TEST(GridLevelChoice, APenetrationThatFailsGoesNoFartherThanBackToWhereItCameFrom)
{
  GridLevelChoice choice = aStepBelowUnitGrid();
  ASSERT_TRUE(choice.refine(hopeless));
  EXPECT_EQ(cells(choice.level()), 24 * 56);
  ASSERT_TRUE(choice.refine(hopeless));
  EXPECT_GT(cells(choice.level()), 24 * 56) << "the next climb is free";
}

TEST(GridLevelChoice, AGridThatDoesIsKeptWhateverAFailureHasPredicted)
{
  GridLevelChoice choice = aStepBelowUnitGrid();
  ASSERT_TRUE(choice.refine(hopeless));
  choice.coarsen(ofApproach(choice.level(), just_within));
  choice.arrive(elsewhere);
  EXPECT_EQ(cells(choice.level()), 24 * 56);
}

// Having come down matters to the next answer alone, not to one from a new start.
TEST(GridLevelChoice, ANewStartForgetsAPenetration)
{
  GridLevelChoice choice = aStepBelowUnitGrid(), fresh(levels(), tolerance);
  for (GridLevelChoice* one : {&choice, &fresh})
  {
    one->arrive(elsewhere);
    one->start(ErrorEstimate());
    ASSERT_TRUE(one->refine(hopeless));
  }
  EXPECT_EQ(cells(choice.level()), cells(fresh.level()));
}

// One answer without a tail does not yet lead to a grid on which tails would be several times worse.
TEST(GridLevelChoice, ATailOfTheLastResultsCounts)
{
  GridLevelChoice choice = onUnitGrid();
  choice.arrive(elsewhere);
  choice.coarsen(ofTail(choice.level(), 0.5 * tolerance));
  choice.coarsen(ErrorEstimate());
  EXPECT_LE(ofTail(choice.level(), 0.45 * tolerance).largest(), 0.8 * tolerance);
}
}  // namespace
