// SPDX-License-Identifier: BSD-3-Clause
// Contact and rail deflection solved together, compared with rails held in the deflected position. Also shows where the
// simple iteration between contact and rail fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/balance/rail_support.h"
#include "core/balance/wheelset_balance.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double wheel_load = 1e5;  ///< [N]

ContactModelConfig onPads(const ComplianceTable& table)
{
  ContactModelConfig config = manchesterScene();
  config.rail_bending.model = RailBendingConfig::Model::compliance;
  config.rail_bending.table = table;
  return config;
}

/// Lateral deflections [m] of the simple iteration: the contact is solved on a fixed rail, the rail is moved to the
/// deflection that the forces cause, and again. One wheel, `y` outward, without roll.
std::vector<double> simpleIteration(double y, int steps)
{
  const ContactModelConfig config = onPads(verySoftPads());
  const PlacedRail straight = restingRail(config, Side::left);
  ConjugateGradients solver;
  WheelContact wheel(config, Side::left, restingRail(config, Side::left), solver);
  wheel.setGrid(0, {16, 64});
  const Eigen::Matrix3d compliance =
      supportCompliance(config.rail_bending.table.left, config.track.rail_inclination.left);
  RailDeflection deflection;
  std::vector<double> lateral;
  for (int step = 0; step < steps; ++step)
  {
    wheel.setRail(straight.deflected(deflection));
    WheelsetPose pose{y, config.wheelset.rolling_radius.left, 0, 0};
    for (int pass = 0; pass < 8; ++pass)  // until no approach remains
    {
      if (wheel.solveLoad(pose, wheel_load) != WheelStatus::solved)
      {
        return {};
      }
      pose.z = wheel.height();
    }
    deflection = toDeflection(compliance * wheel.forces().tail<3>());
    lateral.push_back(deflection.lateral);
  }
  return lateral;
}
}  // namespace

// By symmetry both rails have the same deflection, and both can be held in it. The two solutions differ by their
// residual, 2e-5, and by the positions of their grids.
TEST(Coupling, RailsHeldInTheDeflectedPositionCarryTheSameForces)
{
  ContactModelConfig config = onPads(softPads());
  config.contact.cells_along = 32;
  config.contact.cells_across = 128;
  config.contact.tolerance = 0.001;  // tolerance of the balance; the grid is fixed
  WheelsetContact bending(config);
  const WheelsetResult a = bending.evaluate(stateAt(0, wheel_load));
  ASSERT_EQ(a.status, ContactStatus::ok) << a.reason;
  config.rail_bending.model = RailBendingConfig::Model::prescribed;
  config.rail_bending.prescribed = a.rail.left.deflection;
  WheelsetContact held(config);
  const WheelsetResult& b = held.evaluate(stateAt(0, wheel_load));
  ASSERT_EQ(b.status, ContactStatus::ok) << b.reason;
  EXPECT_NEAR(a.rail.left.lateral_force / b.rail.left.lateral_force, 1, 1e-3);
  EXPECT_NEAR(wheelTotal(a, Side::left).max_pressure / wheelTotal(b, Side::left).max_pressure, 1, 5e-4);
  EXPECT_NEAR(wheelTotal(a, Side::left).area / wheelTotal(b, Side::left).area, 1, 1e-3);
  EXPECT_NEAR(a.z, b.z, 1e-3 * 1e-4);  // relative to an approach of 0.1 mm
}

TEST(Coupling, SimpleIterationConvergesOnTheTread)
{
  const std::vector<double> lateral = simpleIteration(0, 12);
  ASSERT_FALSE(lateral.empty());
  EXPECT_NEAR(lateral.back(), lateral[lateral.size() - 2], 1e-6);
}

// On the flange, the deflection of the rail relieves the force that causes it.
TEST(Coupling, SimpleIterationOscillatesAtTheFlange)
{
  const std::vector<double> lateral = simpleIteration(6.5e-3, 16);
  ASSERT_FALSE(lateral.empty());
  const auto [least, most] = std::minmax_element(lateral.end() - 6, lateral.end());
  EXPECT_GT(*most - *least, 0.5e-3);
}

TEST(Coupling, SoftRailAtTheFlangeIsSolved)
{
  const ContactModelConfig config = onPads(verySoftPads());
  for (const double y : {-6.0e-3, -6.5e-3, -7e-3})
  {
    WheelsetContact contact(config);
    const WheelsetResult& result = contact.evaluate(stateAt(y, wheel_load));
    EXPECT_EQ(result.status, ContactStatus::ok) << result.reason << " at y = " << y;
    EXPECT_GT(result.rail.right.deflection.lateral, 1e-3) << "y " << y;
  }
}

// The height determines the sum of the deflections of rail and contact. The rail deflects fifty times as far. The
// height is known within the tolerance times the approach; a tenth of this, over the compliance of the rail, is the
// accuracy of the load.
TEST(Coupling, SolvedHeightAndRollAsInputGiveTheSameLoads)
{
  for (const ComplianceTable& table : {softPads(), verySoftPads()})
  {
    ContactModelConfig config = onPads(table);
    WheelsetContact solved(config);
    config.wheelset.solve_height_and_roll = false;
    WheelsetContact given(config);
    for (const double y : {0.0, 1e-3, -2.5e-3, 4e-3, 6.5e-3, -8e-3})
    {
      const WheelsetResult& found = solved.evaluate(stateAt(y, wheel_load));
      ASSERT_EQ(found.status, ContactStatus::ok) << found.reason << " at y = " << y;
      WheelsetState back = stateAt(y, 0);
      back.z = found.z;
      back.roll = found.roll;
      const WheelsetResult& again = given.evaluate(back);
      ASSERT_EQ(again.status, ContactStatus::ok) << again.reason << " at y = " << y;
      for (const Side side : {Side::left, Side::right})
      {
        EXPECT_NEAR(wheelTotal(again, side).vertical / wheel_load, 1, config.contact.tolerance) << "y " << y;
      }
    }
  }
}

// 0.05 mm per message, from the track centre to the gauge corner.
TEST(Coupling, WarmSweepNeedsFewSolutions)
{
  const ContactModelConfig config = onPads(softPads());
  const GridLevels levels(config);
  WheelsetBalance balance(config, levels);
  std::vector<int> solutions;
  for (int k = 0; k <= 120; ++k)
  {
    const int before = balance.wheel(Side::right).contact().solutions();
    ASSERT_EQ(balance.solve(stateAt(-k * 0.05e-3, wheel_load)), ContactStatus::ok) << "k " << k;
    solutions.push_back(balance.wheel(Side::right).contact().solutions() - before);
  }
  std::sort(solutions.begin(), solutions.end());
  EXPECT_LE(solutions[solutions.size() / 2], 3);
  EXPECT_LE(solutions[solutions.size() * 95 / 100], 6);
}
}  // namespace wheel_rail_contact::core
