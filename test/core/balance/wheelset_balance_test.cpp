// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheelset_balance.h"

#include "../../seeded.h"
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Load of a wheel [N]: force and moment about the axle centre, supported at the running circles.
double wheelLoad(const ContactModelConfig& config, const WheelsetState& state, Side side)
{
  const double transfer = state.torque_x / (2 * config.wheelset.halfBase());
  return -0.5 * state.force_z + (side == Side::left ? -transfer : transfer);
}

class WheelsetBalanceTest : public testing::Test
{
 protected:
  double within(double low, double high) { return random_.within(low, high); }
  WheelsetState randomState()
  {
    WheelsetState state = stateAt(within(-6e-3, 6e-3), std::exp(within(std::log(2e3), std::log(2e5))));
    state.yaw = within(-1, 1) > 0 ? 0 : within(-0.02, 0.02);
    state.torque_x = within(-0.5, 0.5) * state.force_z * scene_.wheelset.halfBase();
    return state;
  }
  void expectLoads(const WheelsetState& state, const WheelsetResult& result, double tolerance)
  {
    for (const Side side : {Side::left, Side::right})
    {
      const double load = wheelLoad(scene_, state, side);
      EXPECT_NEAR(wheelTotal(result, side).vertical, load, tolerance * load);
      EXPECT_NEAR(result.rail[side].vertical_force, load, tolerance * load);
    }
  }

  Seeded random_{20111U};
  ContactModelConfig scene_ = manchesterScene();
};

TEST_F(WheelsetBalanceTest, CentredWheelsetHasNoRollAndLoadsBothWheelsEqually)
{
  WheelsetContact contact(scene_);
  const WheelsetResult& result = okResult(contact, stateAt(0, 1e5));
  EXPECT_NEAR(result.roll, 0, 1e-15);  // rounding of the axle height over the axle length
  EXPECT_EQ(result.rail.left.lateral_force, result.rail.right.lateral_force);
}

// The normal solution holds the load by construction; 1e-6 covers the rounding of the sums over cells.
TEST_F(WheelsetBalanceTest, EachWheelCarriesItsShareOfForceAndMomentAlsoAfterManyWarmMessages)
{
  WheelsetContact contact(scene_);
  for (int i = 0; i < 100; ++i)
  {
    const WheelsetState state = randomState();
    expectLoads(state, okResult(contact, state), 1e-6);
  }
  for (int i = 0; i < 1000; ++i)
  {
    const WheelsetState state = stateAt(4e-3 * std::sin(0.0125 * i), 1e5 * (1 + 0.3 * std::sin(0.07 * i)));
    expectLoads(state, okResult(contact, state), 1e-6);
  }
}

// Within half the tolerance of 1 %: a roll that changes a height by 2 of 100 um of overlap, and the approach of up to a
// thirtieth of the overlap, are corrected to first order.
TEST_F(WheelsetBalanceTest, SolvedHeightAndRollAsInputGiveTheSameLoads)
{
  scene_.contact = {NormalMethod::conjugate_gradient, 0.01, 16, 64};
  for (const ComplianceTable& table : {ComplianceTable{}, softPads(), verySoftPads()})
  {
    bend(scene_, table);
    ContactModelConfig given_scene = scene_;
    given_scene.wheelset.solve_height_and_roll = false;
    WheelsetContact solved(scene_), given(given_scene);
    for (const double y : {0.0, 1e-3, -2.5e-3, 4e-3, -6e-3, 8e-3})
    {
      const WheelsetState state = stateAt(y, 8e4, 0, 2e4);
      const WheelsetResult& found = okResult(solved, state);
      const WheelsetResult& again = okResult(given, heldAt(y, found.z, found.roll));
      EXPECT_EQ(again.z, found.z);
      EXPECT_EQ(again.roll, found.roll);
      expectLoads(state, again, 0.005);
      const double bent = found.rail.left.deflection.lateral;
      EXPECT_NEAR(again.rail.left.deflection.lateral, bent, 5e-3 * std::abs(bent)) << "at y " << y;
    }
  }
}

TEST_F(WheelsetBalanceTest, UnloadedWheelLiftsOffAndTheOtherCarriesAll)
{
  WheelsetContact contact(scene_);
  for (const double sign : {1.0, -1.0})
  {
    for (const double bias : {1.0, 1.5})
    {
      const WheelsetState state = stateAt(1e-3, 5e4, 0, sign * bias * 1e5 * scene_.wheelset.halfBase());
      const Side carrying = sign > 0 ? Side::right : Side::left;
      const Side lifted = sign > 0 ? Side::left : Side::right;
      const WheelsetResult& result = contact.evaluate(state);
      ASSERT_EQ(result.status, ContactStatus::lift_off) << result.reason;
      EXPECT_FALSE(result.reason.empty());
      const double load = wheelLoad(scene_, state, carrying);
      EXPECT_NEAR(wheelTotal(result, carrying).vertical, load, 1e-6 * load);
      EXPECT_EQ(wheelTotal(result, lifted).patches, 0);
      EXPECT_EQ(result.rail[lifted].vertical_force, 0);
      EXPECT_EQ(result.rail[lifted].lateral_force, 0);
    }
  }
}

// The rounding error of two forces that should cancel does not count as a load.
TEST_F(WheelsetBalanceTest, RoundingErrorIsNotALoad)
{
  for (const double left : {1e-11, 1e-15, 1e-300})
  {
    WheelsetContact contact(scene_);
    EXPECT_EQ(contact.evaluate(stateAt(6e-3, left)).status, ContactStatus::lift_off) << left;
    const double torque = (1 - left / 5e4) * 1e5 * scene_.wheelset.halfBase();
    const WheelsetResult& result = contact.evaluate(stateAt(6e-3, 5e4, 0, torque));
    EXPECT_EQ(result.status, ContactStatus::lift_off) << left << " N of 5e4 N: " << result.reason;
    EXPECT_EQ(result.rail.left.vertical_force, 0);
  }
}

TEST_F(WheelsetBalanceTest, WheelsetWithoutLoadIsPlacedWithoutPatches)
{
  WheelsetContact contact(scene_);
  for (const double force : {0.0, 1e4})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(0, -0.5 * force));
    EXPECT_EQ(result.status, ContactStatus::lift_off) << result.reason;
    EXPECT_TRUE(result.patches.empty());
    EXPECT_TRUE(std::isfinite(result.z));
    EXPECT_TRUE(std::isfinite(result.roll));
  }
}

// Lift-off has no lasting effect: the next loaded state has the same result as before.
TEST_F(WheelsetBalanceTest, WheelsetComesDownAgainAfterLiftOff)
{
  WheelsetContact contact(scene_);
  const WheelsetResult before = contact.evaluate(stateAt(1e-3, 1e5));
  contact.evaluate(stateAt(1e-3, 0));
  const WheelsetResult after = okResult(contact, stateAt(1e-3, 1e5));
  EXPECT_NEAR(after.z, before.z, 1e-7);  // 0.1 % of a penetration of 80 um
  EXPECT_NEAR(wheelTotal(after, Side::left).max_pressure, wheelTotal(before, Side::left).max_pressure,
              0.02 * wheelTotal(before, Side::left).max_pressure);  // twice the tolerance
}

// With a linear material, the pressure increases steadily from 10 N to 1 MN.
TEST_F(WheelsetBalanceTest, PressureIncreasesFromLightToHeavyLoads)
{
  WheelsetContact contact(scene_);
  for (const double y : {0.0, 3e-3})
  {
    double pressure_before = 0;
    double height_before = 1;
    for (double load = 10; load < 1.1e6; load *= std::pow(10, 0.25))
    {
      contact.reset();
      const WheelsetState state = stateAt(y, load);
      const WheelsetResult& result = okResult(contact, state);
      expectLoads(state, result, 1e-6);
      const double pressure = wheelTotal(result, Side::right).max_pressure;
      EXPECT_GT(pressure, pressure_before);
      EXPECT_LT(result.z, height_before);
      pressure_before = pressure;
      height_before = result.z;
    }
  }
}

// Both sides use the same arithmetic. The results are bit-equal from a cold start and along a sweep, on rigid and on
// soft rails.
TEST_F(WheelsetBalanceTest, MirroredStateHasTheMirroredResult)
{
  for (const bool soft : {false, true})
  {
    scene_.rail_bending.model = soft ? RailBendingConfig::Model::compliance : RailBendingConfig::Model::none;
    scene_.rail_bending.table = softPads();
    expectMirroredResults(scene_, 40, [this] { return randomState(); });
  }
}

/// Height and roll of a wheelset on rigid rails, with a tolerance of 0.3 %.
class RigidRailsTest : public testing::Test
{
 protected:
  ContactModelConfig config_ = fineScene();
  GridLevels levels_{config_};
  WheelsetBalance wheelset_{config_, levels_};
};

// Both wheels stand on the rails at one height, at which each carries its load. On rigid rails with this rolling radius
// the balance is unique: the last result is only a start.
TEST_F(RigidRailsTest, BothWheelsAreInBalanceFromAnyStart)
{
  for (const double y : {0.0, -4.3e-3, -6.3e-3, -7e-3})
  {
    const WheelsetState state = stateAt(y, 1e5);
    wheelset_.reset();
    ASSERT_EQ(wheelset_.solve(state), ContactStatus::ok);
    EXPECT_NEAR(wheelset_.wheel(Side::left).height(), wheelset_.wheel(Side::right).height(), 1e-5) << "y " << y;
    for (const Side side : sides)
    {
      EXPECT_LE(wheelset_.balanceError(side), 0.1 * config_.contact.tolerance) << "y " << y;
    }
    const double z = wheelset_.height(), roll = wheelset_.roll();
    for (const double before : {-9e-3, -6e-3, 9e-3})
    {
      ASSERT_EQ(wheelset_.solve(stateAt(before, 2e4)), ContactStatus::ok) << "y " << before;
      ASSERT_EQ(wheelset_.solve(state), ContactStatus::ok) << "y " << y;
      EXPECT_NEAR(wheelset_.height(), z, 4e-7) << "y " << y;
      EXPECT_NEAR(wheelset_.roll(), roll, 1e-6) << "y " << y;
    }
  }
}

TEST_F(RigidRailsTest, AFailureHasNoLastingEffect)
{
  EXPECT_EQ(wheelset_.solve(stateAt(0.5, 1e5)), ContactStatus::off_profile);
  EXPECT_FALSE(wheelset_.reason().empty());
  EXPECT_EQ(wheelset_.solve(stateAt(0, 1e5)), ContactStatus::ok);
  EXPECT_TRUE(wheelset_.reason().empty());
}
}  // namespace
