// SPDX-License-Identifier: BSD-3-Clause
// Friction in the balance of a wheelset.
#include "wheel_rail_contact/core/sides.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double load = 1e5, speed = 20, friction = 0.3;

WheelsetState rollingAt(double y, double yaw)
{
  WheelsetState state = stateAt(y, load, yaw);
  state.motion.speed = speed;
  return state;
}

ContactModelConfig withFriction(ContactModelConfig config, CreepMethod method = CreepMethod::fastsim)
{
  config.creep.method = method;
  config.creep.friction = FrictionLaw{friction, 1, 0};
  return config;
}

double verticalForce(const WheelsetResult& result)
{
  return result.wheel.left.vertical + result.wheel.right.vertical;
}

// Spin takes back 2.9 of the 3.5 kN by the conicity (own calculation outside of the balance, with Kalker's tables).
TEST(Friction, SpinTakesBackMostOfTheLateralForceOnTheTread)
{
  for (const CreepMethod method : {CreepMethod::fastsim, CreepMethod::exact})
  {
    WheelsetContact contact(withFriction(manchesterScene(), method));
    const WheelsetResult& result = okResult(contact, rollingAt(0, 0));
    EXPECT_NEAR(result.wheel.left.lateral - result.wheel.left.friction_lateral, 3.5e3, 0.2e3);
    EXPECT_NEAR(result.wheel.left.friction_lateral, -2.9e3, 0.3e3) << toString(method);
    EXPECT_GT(result.patches.front().creep.power, 0);
  }
}

TEST(Friction, AWheelsetThatSlidesAcrossHasTheFrictionLimit)
{
  WheelsetContact contact(withFriction(manchesterScene()));
  const WheelsetResult& result = okResult(contact, rollingAt(0, 0.01));
  for (const PatchResult& patch : result.patches)
  {
    EXPECT_NEAR(patch.creep.adhesion_share, 1, 0.02);
    EXPECT_NEAR(std::hypot(patch.creep.force.x, patch.creep.force.y), friction * patch.normal_force,
                0.02 * friction * patch.normal_force);
    EXPECT_GT(patch.creep.force.y, 0);  // a yaw to the left moves the wheels to the right
  }
}

TEST(Friction, NormalForcesAndFrictionTogetherBalanceTheLoad)
{
  using Balance = WheelsetConfig::Balance;
  for (const Balance balance : {Balance::wheel_loads, Balance::moments})
  {
    for (const double y : {0.0, 0.004, 0.0066, 0.0072})
    {
      ContactModelConfig config = withFriction(onPads(softPads()));
      config.wheelset.balance = balance;
      WheelsetContact contact(config);
      WheelsetState state = rollingAt(y, 0.001);
      state.torque_x = 5e3;
      const WheelsetResult& result = contact.evaluate(state);
      ASSERT_EQ(result.status, ContactStatus::ok) << "y = " << y << ": " << result.reason;
      EXPECT_NEAR(verticalForce(result), 2 * load, 2e-3 * load) << "y = " << y;
      EXPECT_NEAR(result.rail_wrench.force.z(), 2 * load, 2e-3 * load) << "y = " << y;
      const double difference = result.wheel.left.vertical - result.wheel.right.vertical;
      const double moment =
          balance == Balance::moments ? result.rail_wrench.moment.x() : config.wheelset.halfBase() * difference;
      EXPECT_NEAR(moment, -state.torque_x, 3e-3 * load) << "y = " << y;
    }
  }
}

TEST(Friction, AFreeWheelsetHasNoMomentAboutItsAxle)
{
  WheelsetContact contact(withFriction(manchesterScene()));
  const WheelsetResult& result = okResult(contact, rollingAt(0.003, 0));
  EXPECT_LT(std::abs(result.rail_wrench.moment.y()), 1e-3 * friction * load * 0.46);
  EXPECT_NEAR(result.rotation, speed / 0.46, 0.01 * speed / 0.46);
  // The wheels have different rolling radii: their longitudinal forces are opposite and steer the wheelset back.
  EXPECT_LT(result.patches.front().creep.force.x * result.patches.back().creep.force.x, 0);
  EXPECT_LT(result.rail_wrench.moment.z(), 0);
}

/// Largest change of the lateral force of a wheel from one state of a sweep to the next [N].
double largestStep(const ContactModelConfig& config, int states, const std::function<WheelsetState(int)>& at)
{
  WheelsetContact contact(config);
  Sides<double> before;
  double largest = 0;
  for (int k = 0; k < states; ++k)
  {
    const WheelsetResult& result = contact.evaluate(at(k));
    EXPECT_EQ(result.status, ContactStatus::ok) << "state " << k << ": " << result.reason;
    for (const Side side : sides)
    {
      const double change = result.wheel[side].lateral - std::exchange(before[side], result.wheel[side].lateral);
      largest = std::max(largest, k > 0 ? std::abs(change) : 0);
    }
  }
  return largest;
}

/// Of the lateral force in sweeps: far below the error of FASTSIM (10 % of the friction limit) [N].
constexpr double greatest_step = 2e-3 * load;

TEST(Friction, MakesNoStepWherePatchesJoin)
{
  // Two patches become three and two again on rigid rails (y = -5.45 and -5.24 mm), and join on pads (-5.04 mm).
  const auto from = [](double y) { return [y](int k) { return rollingAt(y + 1e-6 * k, 0.002); }; };
  for (const CreepMethod method : {CreepMethod::fastsim, CreepMethod::linear})
  {
    EXPECT_LT(largestStep(withFriction(manchesterScene(), method), 280, from(-5.48e-3)), greatest_step);
    EXPECT_LT(largestStep(withFriction(onPads(softPads()), method), 100, from(-5.09e-3)), greatest_step);
  }
}

TEST(Friction, MakesNoStepInYawThroughSaturation)
{
  const auto turned = [](int k) { return rollingAt(0, 8e-4 + 5e-6 * k); };
  EXPECT_LT(largestStep(withFriction(manchesterScene()), 500, turned), greatest_step);
}

TEST(Friction, FreeRollingTurnsTheWorkOfTheDragIntoHeat)
{
  WheelsetContact contact(withFriction(manchesterScene()));
  for (const double y : {0.001, 0.003, 0.005})
  {
    const WheelsetResult& result = okResult(contact, rollingAt(y, 0.001));
    double power = 0;
    for (const PatchResult& patch : result.patches)
    {
      power += patch.creep.power;
    }
    EXPECT_NEAR(-result.rail_wrench.force.x() * speed / power, 1, 0.01) << "y = " << y;
  }
}

TEST(Friction, ARailBendsByTheWholeForceAndItsMoment)
{
  const ComplianceTable table = softPads();
  WheelsetContact contact(withFriction(onPads(table)));
  const WheelsetResult& result = okResult(contact, rollingAt(0.002, 0.005));
  for (const Side side : sides)
  {
    const WheelForces& wheel = result.wheel[side];
    const RailResult& rail = result.rail[side];
    EXPECT_NEAR(rail.lateral_force, wheel.lateral, 2e-3 * load);
    EXPECT_GT(std::abs(wheel.friction_lateral), 2 * std::abs(wheel.lateral - wheel.friction_lateral));
    const RailDeflection expected =
        deflectionInTrack(table, {rail.lateral_force, rail.vertical_force, rail.moment}, 1.0 / 40);
    EXPECT_NEAR(rail.deflection.lateral, expected.lateral, 1e-7);
    EXPECT_NEAR(rail.deflection.roll, expected.roll, 1e-6);
  }
}

TEST(Friction, AWheelsetAtAGivenHeightBendsItsRailsByFriction)
{
  ContactModelConfig config = withFriction(onPads(softPads()));
  WheelsetContact solved(config);
  WheelsetState state = rollingAt(0.002, 0.004);
  const WheelsetResult under_load = solved.evaluate(state);
  config.wheelset.solve_height_and_roll = false;
  WheelsetContact given(config);
  state.z = under_load.z;
  state.roll = under_load.roll;
  const WheelsetResult there = given.evaluate(state);
  ASSERT_EQ(there.status, ContactStatus::ok) << there.reason;
  EXPECT_NEAR(there.rail.left.deflection.lateral, under_load.rail.left.deflection.lateral, 2e-5);
  EXPECT_NEAR(verticalForce(there), 2 * load, 0.03 * 2 * load);
  // A wheelset above its rails leaves them as they are, whatever was before.
  state.z += 1e-3;
  const WheelsetResult& above = given.evaluate(state);
  EXPECT_EQ(above.status, ContactStatus::lift_off);
  EXPECT_EQ(above.rail.left.lateral_force, 0);
  EXPECT_EQ(above.rail.left.deflection.lateral, 0);
}

TEST(Friction, OppositeYawMirrorsTheForces)
{
  WheelsetContact contact(withFriction(onPads(softPads())));
  const WheelsetResult one = contact.evaluate(rollingAt(0.003, 0.003));
  contact.reset();
  const WheelsetResult& other = contact.evaluate(rollingAt(-0.003, -0.003));
  EXPECT_NEAR(one.wheel.left.friction_lateral, other.wheel.right.friction_lateral, 1e-3 * load);
  EXPECT_NEAR(one.rail.right.deflection.lateral, other.rail.left.deflection.lateral, 1e-6);
}

TEST(Friction, RollingBackwardMirrorsTheForcesAlongTheTrack)
{
  WheelsetContact contact(withFriction(manchesterScene()));
  const WheelsetResult forward = contact.evaluate(rollingAt(0.003, 0));
  WheelsetState state = rollingAt(0.003, 0);
  state.motion.speed = -speed;
  contact.reset();
  const WheelsetResult& backward = contact.evaluate(state);
  ASSERT_EQ(backward.status, ContactStatus::ok) << backward.reason;
  EXPECT_NEAR(backward.rotation, -forward.rotation, 1e-4 * forward.rotation);
  EXPECT_NEAR(backward.patches.front().creep.force.x, -forward.patches.front().creep.force.x, 1e-3 * friction * load);
  EXPECT_NEAR(backward.patches.front().creep.force.y, forward.patches.front().creep.force.y, 1e-3 * friction * load);
}

TEST(Friction, AWheelsetAlongTurnedRailsRollsAsOnStraightOnes)
{
  constexpr double slope = 2e-3, twist = 1e-3, length = 5;
  WheelsetContact straight(withFriction(manchesterScene()));
  const WheelsetResult expected = straight.evaluate(rollingAt(0.003, 0.001));
  ContactModelConfig config = withFriction(manchesterScene());
  const double end = slope * length;  // both rails to the left
  config.track.line = std::make_shared<const TrackLine>(
      "turned",
      std::vector<LineStation>{{-length, 0, {{-end, 0, 0}, {end, 0, 0}}}, {length, 0, {{end, 0, 0}, {-end, 0, 0}}}});
  WheelsetContact turned(config);
  WheelsetState state = rollingAt(0.003, 0.001 + slope);
  state.motion.lateral_velocity = slope * speed;
  const WheelsetResult& result = turned.evaluate(state);
  ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
  EXPECT_NEAR(result.rail.right.slope.lateral, -slope, 1e-9);
  for (std::size_t i = 0; i < expected.patches.size(); ++i)
  {
    // A yaw moves the contacts along the track by 0.02 mm per mrad on the tread, and the roll follows.
    EXPECT_NEAR(result.patches.at(i).creep.creepage.x, expected.patches[i].creep.creepage.x, 1e-5);
    EXPECT_NEAR(result.patches[i].creep.creepage.y, expected.patches[i].creep.creepage.y, 2e-5);
  }
  // A twisted track rolls the wheelset, whose contacts then move to the left below the axle.
  config.track.line = std::make_shared<const TrackLine>(
      "twisted", std::vector<LineStation>{{-length, -1.5 * twist * length, {}}, {length, 1.5 * twist * length, {}}});
  WheelsetContact twisted(config);
  const WheelsetResult& rolled = twisted.evaluate(rollingAt(0.003, 0.001));
  EXPECT_NEAR(rolled.patches.front().creep.creepage.y - expected.patches.front().creep.creepage.y, twist * 0.46, 2e-5);
}

TEST(Friction, SmoothRailsHaveNone)
{
  for (const CreepMethod method : {CreepMethod::linear, CreepMethod::fastsim, CreepMethod::exact})
  {
    ContactModelConfig config = withFriction(manchesterScene(), method);
    config.creep.friction = FrictionLaw{0, 1, 0};
    config.creep.field = method == CreepMethod::exact;
    WheelsetContact contact(config);
    const WheelsetResult& result = okResult(contact, rollingAt(0.003, 0.002));
    EXPECT_EQ(result.wheel.left.friction_lateral, 0);
    EXPECT_EQ(result.rotation, speed / config.wheelset.meanRadius());
  }
}

TEST(Friction, BelowTheLeastSpeedThereIsNone)
{
  WheelsetContact contact(withFriction(manchesterScene()));
  contact.evaluate(rollingAt(0.003, 0.005));
  WheelsetState state = rollingAt(0.003, 0.005);
  state.motion.speed = 0.005;
  const WheelsetResult& result = contact.evaluate(state);
  ASSERT_EQ(result.status, ContactStatus::ok);
  EXPECT_EQ(result.wheel.left.friction_lateral, 0);
  EXPECT_NEAR(result.rail.left.lateral_force, result.wheel.left.lateral, 1e-3);
  EXPECT_EQ(result.reason, "no creep forces: the speed is below 0.01 m/s");
  state.motion.speed = NAN;
  EXPECT_EQ(contact.evaluate(state).status, ContactStatus::invalid_input);
}
}  // namespace
}  // namespace wheel_rail_contact::core
