// SPDX-License-Identifier: BSD-3-Clause
// Contact and rail deflection solved together, compared with rails held in the deflected position. Also shows where the
// simple iteration between contact and rail fails.
#include "core/balance/rail_support.h"
#include "core/balance/wheelset_balance.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
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
    deflection = toDeflection(compliance * wheel.solved().forces().tail<3>());
    lateral.push_back(deflection.lateral);
  }
  return lateral;
}

// By symmetry both rails have the same deflection, and both can be held in it. The two solutions differ by their
// residual, 2e-5, and by the positions of their grids.
TEST(Coupling, RailsHeldInTheDeflectedPositionCarryTheSameForces)
{
  ContactModelConfig config = onPads(softPads());
  config.contact.cells_along = 32;
  config.contact.cells_across = 128;
  config.contact.tolerance = 0.001;  // tolerance of the balance; the grid is fixed
  WheelsetContact bending(config);
  const WheelsetResult a = okResult(bending, stateAt(0, wheel_load));
  config.rail_bending.model = RailBendingConfig::Model::prescribed;
  config.rail_bending.prescribed = a.rail.left.deflection;
  WheelsetContact held(config);
  const WheelsetResult& b = okResult(held, stateAt(0, wheel_load));
  EXPECT_NEAR(a.rail.left.lateral_force / b.rail.left.lateral_force, 1, 1e-3);
  EXPECT_NEAR(wheelTotal(a, Side::left).max_pressure / wheelTotal(b, Side::left).max_pressure, 1, 5e-4);
  EXPECT_NEAR(wheelTotal(a, Side::left).area / wheelTotal(b, Side::left).area, 1, 1e-3);
  EXPECT_NEAR(a.z, b.z, 1e-3 * 1e-4);  // relative to an approach of 0.1 mm
}

TEST(Coupling, SimpleIterationConvergesOnTheTreadAndOscillatesAtTheFlange)
{
  std::vector<double> lateral = simpleIteration(0, 12);
  ASSERT_FALSE(lateral.empty());
  EXPECT_NEAR(lateral.back(), lateral[lateral.size() - 2], 1e-6);
  // On the flange, the deflection of the rail relieves the force that causes it.
  lateral = simpleIteration(6.5e-3, 16);
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

// Sweep from the track centre to the flange in steps of 25 um on rigid rails, each state from the last result and from
// a cold start. The roll is bracketed, and the height of a wheel is unique at each roll: every state has a result, as
// doc/theory.md states.

constexpr double step = 25e-6;  ///< [m]
constexpr int steps = 400;

/// Expects a result in every state, and wheels that carry their loads.
void sweep(const ContactModelConfig& config, double load, double yaw, bool cold)
{
  WheelsetContact contact(config);
  for (int k = 0; k < steps; ++k)
  {
    if (cold)
    {
      contact.reset();
    }
    const double y = -k * step;
    const WheelsetResult& result = contact.evaluate(stateAt(y, load, yaw));
    EXPECT_EQ(result.status, ContactStatus::ok) << "y " << y << (cold ? ", cold: " : ", warm: ") << result.reason;
    EXPECT_NEAR(result.wheel.left.vertical / load, 1, 1e-6) << "y " << y;  // the accuracy of the balance
    EXPECT_NEAR(result.wheel.right.vertical / load, 1, 1e-6) << "y " << y;
  }
}

TEST(FineSweep, FindsTheBalanceFromTheTrackCentreToTheFlange)
{
  for (const bool standard : {false, true})
  {
    ContactModelConfig config = manchesterScene();
    if (standard)
    {
      config.rail_profile = std::make_shared<Profile>(rail60E1());
    }
    for (const double load : {2e4, 1e5})
    {
      sweep(config, load, 0, false);
      sweep(config, load, 0, true);
    }
    sweep(config, 1e5, 0.01, false);
    sweep(config, 1e5, 0.01, true);
  }
}

// The overlap of the right wheel has one minimum, and a shoulder 8 mm beside it that touches as well: 71.63 mm² on 64 ×
// 192 cells over the whole overlap, 57.7 mm² without the second contact. From both directions and cold.
TEST(FineSweep, AContactOnAShoulderOfTheOverlapIsFound)
{
  constexpr double begin = -5.3e-3, end = -5.55e-3, shoulder = -5.415e-3, fine = 5e-6, expected = 71.63e-6;
  const ContactModelConfig config = manchesterScene();
  for (const double from : {begin, end, shoulder})
  {
    WheelsetContact contact(config);
    const double direction = from > shoulder ? -1 : 1;
    for (double y = from; direction * (shoulder - y) > 0.5 * fine; y += direction * fine)
    {
      contact.evaluate(stateAt(y, 1e5));
    }
    const WheelTotal total = wheelTotal(contact.evaluate(stateAt(shoulder, 1e5)), Side::right);
    EXPECT_EQ(total.patches, 2) << "from " << from;
    EXPECT_NEAR(total.area, expected, config.contact.tolerance * expected) << "from " << from;
  }
}

constexpr double running_slope = 0.05;  ///< slope of the tread [-]
constexpr double fillet = 0.014;        ///< radius between tread and flank [m]
constexpr double tread_begins = -0.03;  ///< [m]

/// Conical tread, fillet and flange face of 70 degrees. Tread and flange touch a rail at distant positions.
Profile straightFlanked()
{
  constexpr double flank_length = 0.014, tread_length = 0.09;
  const double tread = std::atan(running_slope), flank = 70 * M_PI / 180;
  const double centre_y = tread_begins + fillet * std::sin(tread);
  const double centre_z = tread_begins * running_slope - fillet * std::cos(tread);
  const double begin = 0.5 * M_PI + flank;  // start angle of the arc, from its centre
  const double y = centre_y + fillet * std::cos(begin), z = centre_z + fillet * std::sin(begin);
  const double c = std::cos(flank), s = std::sin(flank);
  return {"straight flank",
          {{LineSection{y - flank_length * c, z - flank_length * s, c, s}, flank_length},
           {ArcSection{centre_y, centre_z, fillet, begin, -1}, fillet * (flank - tread)},
           {LineSection{tread_begins, tread_begins * running_slope, std::cos(tread), std::sin(tread)}, tread_length}}};
}

ContactModelConfig scene(double tolerance, int along, int across)
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<Profile>(straightFlanked());
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  config.track.rail_inclination = running_slope;
  config.contact = {NormalMethod::conjugate_gradient, tolerance, along, across};
  return config;
}

TEST(OpenRoll, DoesNotSeparateTreadAndFlange)
{
  // With a tolerance of 0.1, a roll error of up to 3e-5 rad would be allowed for a single contact. This is 14 um of
  // lateral displacement at the rail, as much as the approach of the flange face when it begins to carry load.
  WheelsetContact loose(scene(0.1, 8, 24)), strict(scene(0.003, 24, 56));
  double worst = 0;
  int two = 0;
  for (int step = 0; step < 20; ++step)
  {
    const WheelsetState state = stateAt(10.595e-3 + 3e-6 * step, 25e3, 0.01);
    const auto patches = patchesOf(okResult(loose, state), Side::left);
    const auto exact = patchesOf(okResult(strict, state), Side::left);
    ASSERT_EQ(patches.size(), exact.size()) << state.y;
    two += patches.size() == 2 ? 1 : 0;
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      const double off = difference(*patches[k], *exact[k]);
      worst = std::max(worst, off);
      EXPECT_LT(off, patches[k]->error_estimate + exact[k]->error_estimate) << state.y << ", patch " << k;
    }
  }
  EXPECT_GT(two, 10);
  EXPECT_LT(worst, 0.1);  // the tolerance
}
}  // namespace
