// SPDX-License-Identifier: BSD-3-Clause
// Choice of the grid by `method: auto`, and its memory of positions at which a grid was too coarse.
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

/// Error estimate on a grid level for a contact with errors of one typical kind; `size` [-] is its error on 24 × 56
/// cells.
ErrorEstimate ofJump(const GridLevel& level, double size)
{
  return {size * level.typical.max_pressure, 0, 0, 0};
}

ErrorEstimate ofNarrowEnd(const GridLevel& level, double size)
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

constexpr ErrorEstimate too_large{1, 1, 1, 1};  ///< on no grid is the predicted error below the tolerance

/// Starts cold on the coarsest grid and refines until the error meets the tolerance, in at most four steps.
template <typename Errors>
GridLevelChoice settled(Errors errors)
{
  GridLevelChoice choice(levels(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  EXPECT_EQ(cells(choice.level()), cells(levels().at(0)));
  int refinements = 0;
  while (choice.refine(errors(choice.level())))
  {
    ++refinements;
  }
  EXPECT_LE(refinements, 4);
  return choice;
}

constexpr double just_within = 0.95 * tolerance;

/// On 24 × 56 cells, the coarsest grid that is sufficient for the approach.
GridLevelChoice onUnitGrid()
{
  GridLevelChoice choice = settled([](const GridLevel& level) { return ofApproach(level, just_within); });
  EXPECT_EQ(cells(choice.level()), 24 * 56);
  return choice;
}

constexpr double elsewhere = 1e-3;  ///< another position [m]

/// One step coarser, at another position, with a curvature jump that needs fewer cells.
GridLevelChoice aStepBelowUnitGrid()
{
  GridLevelChoice choice = onUnitGrid();
  choice.arrive(elsewhere);
  choice.coarsen(ofJump(choice.level(), 0.85 * tolerance));
  EXPECT_EQ(cells(choice.level()), 16 * 64);
  return choice;
}

TEST(GridLevelChoice, CurvatureJumpsLeadToCellsAcrossAndNarrowEndsToCellsAlong)
{
  const GridLevel& jump = settled([](const GridLevel& level) { return ofJump(level, 0.95 * tolerance); }).level();
  EXPECT_EQ(jump.size.along, 16);
  EXPECT_EQ(jump.size.across, 64);
  const GridLevel& narrow_end =
      settled([](const GridLevel& level) { return ofNarrowEnd(level, 0.8 * tolerance); }).level();
  EXPECT_EQ(narrow_end.size.along, 24);
  EXPECT_EQ(narrow_end.size.across, 56);
}

// A narrow end with an error of 1.1 times the tolerance leads to 32 × 96 cells. The grids before it have no more cells
// along the track than the 24 × 56 that failed. Their predicted error is larger, and they are skipped.
TEST(GridLevelChoice, EachRefinementHasALowerError)
{
  const auto narrow_end = [](const GridLevel& level) { return ofNarrowEnd(level, 1.1 * tolerance).largest(); };
  double before = INFINITY;
  GridLevelChoice choice(levels(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  do
  {
    EXPECT_LT(narrow_end(choice.level()), before);
    before = narrow_end(choice.level());
  } while (choice.refine(ofNarrowEnd(choice.level(), 1.1 * tolerance)));
  EXPECT_EQ(cells(choice.level()), 32 * 96);
}

// The error from the residual is the same on all grids.
TEST(GridLevelChoice, AnErrorThatNoGridReducesLeadsToTheNextGrid)
{
  GridLevelChoice choice(levels(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  const ErrorEstimate algebra = ofResidual(tolerance);
  ASSERT_GT(algebra.largest(), tolerance);
  ASSERT_TRUE(choice.refine(algebra));
  EXPECT_EQ(cells(choice.level()), cells(levels().at(1)));
}

// The grid is far too coarse by its predicted error, or too coarse by a tenth by its own estimate.
TEST(GridLevelChoice, AGridThatWasTooCoarseAtAPositionIsNotUsedThereFor64Results)
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
      ASSERT_LT(cells(choice.level()), cells(needed)) << "no coarser grid at an easy position";
      choice.arrive(here);
      EXPECT_EQ(hard(choice.level()).largest() <= tolerance, away < 63) << away << " results later";
    }
  }
}

TEST(GridLevelChoice, AfterAFailedCoarseningTheFirstRefinementReturnsToThePreviousGrid)
{
  GridLevelChoice choice = aStepBelowUnitGrid();
  ASSERT_TRUE(choice.refine(too_large));
  EXPECT_EQ(cells(choice.level()), 24 * 56);
  ASSERT_TRUE(choice.refine(too_large));
  EXPECT_GT(cells(choice.level()), 24 * 56) << "the second refinement is not limited";
}

TEST(GridLevelChoice, AGridThatMeetsTheToleranceIsKeptDespiteAnEarlierPrediction)
{
  GridLevelChoice choice = aStepBelowUnitGrid();
  ASSERT_TRUE(choice.refine(too_large));
  choice.coarsen(ofApproach(choice.level(), just_within));
  choice.arrive(elsewhere);
  EXPECT_EQ(cells(choice.level()), 24 * 56);
}

// A coarsening affects the next result only, not one after a new start.
TEST(GridLevelChoice, ANewStartDiscardsACoarsening)
{
  GridLevelChoice choice = aStepBelowUnitGrid(), fresh(levels(), tolerance);
  for (GridLevelChoice* one : {&choice, &fresh})
  {
    one->arrive(elsewhere);
    one->start(ErrorEstimate());
    ASSERT_TRUE(one->refine(too_large));
  }
  EXPECT_EQ(cells(choice.level()), cells(fresh.level()));
}

// One result without a narrow end does not yet lead to a grid on which the error of narrow ends is several times
// larger.
TEST(GridLevelChoice, ANarrowEndInARecentResultCounts)
{
  GridLevelChoice choice = onUnitGrid();
  choice.arrive(elsewhere);
  choice.coarsen(ofNarrowEnd(choice.level(), 0.5 * tolerance));
  choice.coarsen(ErrorEstimate());
  EXPECT_LE(ofNarrowEnd(choice.level(), 0.45 * tolerance).largest(), 0.8 * tolerance);
}
}  // namespace
