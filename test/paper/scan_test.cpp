// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "core/normal/solvers/conjugate_gradients.h"
#include "paper/forces.h"
#include "paper/scan.h"
#include "paper_scene.h"
#include "ros/parameters/compliance_table_file.h"

using namespace wheel_rail_contact;
using namespace wheel_rail_contact::core::paper;

namespace
{
/// Ranges of paper_study with fewer steps.
ScanRanges coarse()
{
  ScanRanges ranges;
  ranges.rails = {"UIC60_manchester"};
  ranges.position = {-6e-3, 6e-3, 30};
  ranges.position_around_start = {0, 0, 1};
  ranges.pure_shift = {-5e-3, 4e-3, 36};
  ranges.shift = {-printed_displacement, 0, printed_displacement};
  ranges.turn = {-16e-3, 16e-3, 32};
  ranges.roll = {-1e-3, 1e-3, 4};
  return ranges;
}

class ScanTest : public testing::Test
{
 protected:
  static ScanRow start(const Scan& scan)
  {
    const std::vector<ScanRow> nearest = scan.nearestStarts(scan.start(), 0.03);
    EXPECT_EQ(nearest.size(), 1U);
    return nearest.at(0);
  }
  static double least(const std::vector<ScanRow>& rows)
  {
    double deviation = 1e9;
    for (const ScanRow& row : rows)
    {
      deviation = std::min(deviation, row.pairDeviation());
    }
    return deviation;
  }

  core::ConjugateGradients solver_;
  Scan scan_{paperConfig().model, solver_, coarse()};
};
}  // namespace

TEST_F(ScanTest, FiguresWithoutBendingRequireAnInclinationOfOneInFortyAndTheWholeLoad)
{
  for (const ScanRow& row : scan_.start())
  {
    if (row.inclination != 1.0 / 40 || row.load != printed_wheel_load)
    {
      EXPECT_GT(deviation(row.figures, printed_without_bending), 0.1)
          << row.inclination << ' ' << row.load << ' ' << row.y;
    }
  }
  EXPECT_EQ(start(scan_).inclination, 1.0 / 40);
}

// Found from the best start: a deviation of 43 % within the printed displacement, and 5.5 % at best (4 mm inward, 16
// times the printed displacement).
TEST_F(ScanTest, NoPureShiftGivesTheFiguresWithBending)
{
  for (const ScanRow& row : scan_.shift(start(scan_)))
  {
    EXPECT_GT(row.pairDeviation(), std::abs(row.crown.lateral) < 0.3e-3 ? 0.4 : 0.04) << row.crown.lateral;
  }
}

TEST_F(ScanTest, NeitherWheelsetRollNorTheOtherRailGivesTheFiguresWithBending)
{
  EXPECT_GT(least(scan_.roll(start(scan_))), 0.25);
  EXPECT_GT(least(scan_.rails(start(scan_))), 0.3);
}

TEST_F(ScanTest, FiguresWithBendingRequireARailTurnedInward)
{
  const std::vector<ScanRow> rows = scan_.pair(start(scan_));
  const auto best =
      std::min_element(rows.begin(), rows.end(),
                       [](const ScanRow& a, const ScanRow& b) { return a.pairDeviation() < b.pairDeviation(); });
  EXPECT_LT(best->pairDeviation(), 0.025);
  EXPECT_NEAR(best->crown.roll, case_turn, 1.5e-3);
  for (const ScanRow& row : rows)
  {
    EXPECT_TRUE(row.crown.roll < 0 || row.pairDeviation() > 0.1) << row.crown.roll;
  }
}

// With an inclination of 1:21 near the flange, an outward turn leads close to both printed results (found: 2.7 % at 7
// mrad).
TEST_F(ScanTest, NearTheFlangeAtOneInTwentyOneAnOutwardTurnGivesSimilarFigures)
{
  ScanRanges ranges = coarse();
  ranges.free_inclination = {46e-3, 49e-3, 3};
  ranges.position = {4.8e-3, 5.8e-3, 10};
  ranges.turn = {2e-3, 10e-3, 8};
  const Scan near_flange(paperConfig().model, solver_, ranges);
  const std::vector<ScanRow> rows = near_flange.inclination("UIC60_manchester");
  ASSERT_FALSE(rows.empty());
  EXPECT_LT(least(rows), 0.035);
}

TEST(LateralForce, RaisesThePressureOnEveryShippedRail)
{
  for (const char* name : {"paper", "pads_100_500", "pads_40_100", "pads_20_60", "pads_10_25"})
  {
    const ComplianceTableFile file = readComplianceTable(shipped("rails/" + std::string(name) + ".yaml"));
    const std::vector<ForceRow> rows = underForces(paperConfig().model, {name, file.table, file.linear_range},
                                                   DeflectionShare::whole, {case_position}, {0, 20e3, 40e3, 60e3});
    ASSERT_EQ(rows.size(), 4U);
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
      EXPECT_GT(rows[i].figures.max_pressure, rows[i - 1].figures.max_pressure) << name;
      EXPECT_LT(rows[i].figures.area, rows[i - 1].figures.area) << name;
    }
  }
}

// The wheel load of 100 kN acts on the gauge side of the rail axis and turns the rail inward, against the lateral
// force. The whole deflection raises the pressure; a displacement without roll lowers it.
TEST(LateralForce, WheelLoadTurnsTheRailInwardAndRollDeterminesTheSignOfThePressureChange)
{
  const NodeConfig config = paperConfig();
  const ComplianceTableFile file = readComplianceTable(shipped("rails/pads_40_100.yaml"));
  const auto figures = [&](DeflectionShare share, double force)
  {
    return underForces(config.model, {file.name, file.table, file.linear_range}, share, {case_position}, {force})
        .front();
  };
  const ForceRow whole = figures(DeflectionShare::whole, 20e3);
  const ForceRow without_moment = figures(DeflectionShare::without_moment, 20e3);
  const ForceRow shift_only = figures(DeflectionShare::shift_only, 20e3);
  const ForceRow rigid = figures(DeflectionShare::shift_only, 0);
  EXPECT_LT(whole.deflection.roll, without_moment.deflection.roll - 1e-3);
  EXPECT_LT(whole.figures.max_pressure, without_moment.figures.max_pressure);
  EXPECT_GT(whole.figures.max_pressure, rigid.figures.max_pressure);
  EXPECT_LT(shift_only.figures.max_pressure, 0.9 * rigid.figures.max_pressure);
}

TEST(LateralForce, RangeOfTheTableIsReported)
{
  const ComplianceTableFile file = readComplianceTable(shipped("rails/pads_40_100.yaml"));
  const std::vector<ForceRow> rows = underForces(paperConfig().model, {file.name, file.table, file.linear_range},
                                                 DeflectionShare::whole, {case_position}, {59e3, 61e3});
  EXPECT_TRUE(rows.at(0).in_range);
  EXPECT_FALSE(rows.at(1).in_range);
}
