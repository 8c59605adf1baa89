// SPDX-License-Identifier: BSD-3-Clause
// Which grid `method: auto` takes, and what it remembers of places where one was too coarse.
#include <gtest/gtest.h>

#include <cmath>

#include "core/balance/grid_levels.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double tolerance = 0.01;

const MethodLadder& ladder()
{
  static const MethodLadder all{ContactModelConfig()};
  return all;
}

/// What a contact shows on a grid whose errors are those typical of one kind of contact; `size` [-] is its error on
/// 24 × 56 cells.
ErrorEstimate ofJump(const Rung& rung, double size)
{
  return {size * rung.typical.max_pressure, 0, 0, 0};
}

ErrorEstimate ofTail(const Rung& rung, double size)
{
  return {0, size * rung.typical.tails, 0, size * rung.typical.tails};
}

ErrorEstimate ofApproach(const Rung& rung, double size)
{
  return {0, 0, size * rung.typical.approach, 0};
}

int cells(const Rung& rung)
{
  return rung.size.along * rung.size.across;
}

constexpr ErrorEstimate hopeless{1, 1, 1, 1};  ///< no grid promises to bring that below the tolerance

/// Sets out from cold on the coarsest grid and climbs until an answer would do, in at most four steps.
template <typename Errors>
RungChoice settled(Errors errors)
{
  RungChoice choice(ladder(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  EXPECT_EQ(cells(choice.rung()), cells(ladder().at(0)));
  int climbs = 0;
  while (choice.climb(errors(choice.rung())))
  {
    ++climbs;
  }
  EXPECT_LE(climbs, 4);
  return choice;
}

constexpr double just_within = 0.95 * tolerance;

/// On 24 × 56 cells, which the approach there just needs.
RungChoice onUnitGrid()
{
  RungChoice choice = settled([](const Rung& rung) { return ofApproach(rung, just_within); });
  EXPECT_EQ(cells(choice.rung()), 24 * 56);
  return choice;
}

constexpr double elsewhere = 1e-3;  ///< [m]

/// A step down from there at another place, with a jump of the curvature, which needs less.
RungChoice aStepBelowUnitGrid()
{
  RungChoice choice = onUnitGrid();
  choice.arrive(elsewhere);
  choice.descend(ofJump(choice.rung(), 0.85 * tolerance));
  EXPECT_EQ(cells(choice.rung()), 16 * 64);
  return choice;
}

TEST(RungChoice, JumpsOfTheCurvatureTakeCellsAcrossAndTailsCellsAlong)
{
  const Rung& jump = settled([](const Rung& rung) { return ofJump(rung, 0.95 * tolerance); }).rung();
  EXPECT_EQ(jump.size.along, 16);
  EXPECT_EQ(jump.size.across, 64);
  const Rung& tail = settled([](const Rung& rung) { return ofTail(rung, 0.8 * tolerance); }).rung();
  EXPECT_EQ(tail.size.along, 24);
  EXPECT_EQ(tail.size.across, 56);
}

// A tail of 1.1 times the tolerance finds 32 × 96 cells: the grids before that have no more cells along than the 24 ×
// 56 that failed, promise worse, and are passed over.
TEST(RungChoice, EachStepIsBetterThanWhatFailed)
{
  const auto tail = [](const Rung& rung) { return ofTail(rung, 1.1 * tolerance).largest(); };
  double before = INFINITY;
  RungChoice choice(ladder(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  do
  {
    EXPECT_LT(tail(choice.rung()), before);
    before = tail(choice.rung());
  } while (choice.climb(ofTail(choice.rung(), 1.1 * tolerance)));
  EXPECT_EQ(cells(choice.rung()), 32 * 96);
}

// What the algebra leaves is the same on all grids.
TEST(RungChoice, AnErrorThatNoGridPromisesToLowerTakesTheNextOne)
{
  RungChoice choice(ladder(), tolerance);
  choice.arrive(0);
  choice.start(ErrorEstimate());
  const ErrorEstimate algebra = ofResidual(tolerance);
  ASSERT_GT(algebra.largest(), tolerance);
  ASSERT_TRUE(choice.climb(algebra));
  EXPECT_EQ(cells(choice.rung()), cells(ladder().at(1)));
}

// Far too coarse, as its promise tells, or by a tenth, as it itself has shown.
TEST(RungChoice, AGridThatWasTooCoarseAtAPlaceIsNotTakenThereFor64Answers)
{
  constexpr double here = 0;  // [m]
  for (const double size : {0.5 * tolerance, 1.1 * tolerance / ladder().at(0).typical.max_pressure})
  {
    const auto hard = [size](const Rung& rung) { return ofJump(rung, size); };
    for (const int away : {20, 62, 63})
    {
      RungChoice choice = settled(hard);
      const Rung& needed = choice.rung();
      for (int answer = 0; answer < away; ++answer)
      {
        choice.arrive(elsewhere);
        choice.descend(ofJump(choice.rung(), 1e-4 * tolerance));
      }
      ASSERT_LT(cells(choice.rung()), cells(needed)) << "easy places let it come down";
      choice.arrive(here);
      EXPECT_EQ(hard(choice.rung()).largest() <= tolerance, away < 63) << away << " answers later";
    }
  }
}

TEST(RungChoice, ADescentThatFailsGoesNoFartherThanBackToWhereItCameFrom)
{
  RungChoice choice = aStepBelowUnitGrid();
  ASSERT_TRUE(choice.climb(hopeless));
  EXPECT_EQ(cells(choice.rung()), 24 * 56);
  ASSERT_TRUE(choice.climb(hopeless));
  EXPECT_GT(cells(choice.rung()), 24 * 56) << "the next climb is free";
}

TEST(RungChoice, AGridThatDoesIsKeptWhateverAFailureHasPromised)
{
  RungChoice choice = aStepBelowUnitGrid();
  ASSERT_TRUE(choice.climb(hopeless));
  choice.descend(ofApproach(choice.rung(), just_within));
  choice.arrive(elsewhere);
  EXPECT_EQ(cells(choice.rung()), 24 * 56);
}

// Having come down matters to the next answer alone, not to one from a new start.
TEST(RungChoice, ANewStartForgetsADescent)
{
  RungChoice choice = aStepBelowUnitGrid(), fresh(ladder(), tolerance);
  for (RungChoice* one : {&choice, &fresh})
  {
    one->arrive(elsewhere);
    one->start(ErrorEstimate());
    ASSERT_TRUE(one->climb(hopeless));
  }
  EXPECT_EQ(cells(choice.rung()), cells(fresh.rung()));
}

// One answer without a tail does not yet lead to a grid on which tails would be several times worse.
TEST(RungChoice, ATailOfTheLastAnswersCounts)
{
  RungChoice choice = onUnitGrid();
  choice.arrive(elsewhere);
  choice.descend(ofTail(choice.rung(), 0.5 * tolerance));
  choice.descend(ErrorEstimate());
  EXPECT_LE(ofTail(choice.rung(), 0.45 * tolerance).largest(), 0.8 * tolerance);
}
}  // namespace
