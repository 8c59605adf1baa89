// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "round_bodies.h"
#include "same_bits.h"

using namespace wheel_rail_contact::core;

namespace
{
const Material soft_steel{1.9e11, 0.3};
const Material hard_steel{2.3e11, 0.25};

/// S1002 on 60E1 on the left, and a cone of 1:40 on UIC60 on the right. All other options differ as well.
ContactModelConfig unequalSides()
{
  ContactModelConfig config;
  config.wheel_profile = {std::make_shared<Profile>(s1002Wheel()),
                          std::make_shared<Profile>(round_bodies::coneWheel(1.0 / 40))};
  config.wheelset.rolling_radius = {0.460, 0.459};
  config.rail_profile = {std::make_shared<Profile>(rail60E1()), std::make_shared<Profile>(railUic60Manchester())};
  config.track.rail_inclination = {std::atan(1.0 / 40), std::atan(1.0 / 20)};
  config.wheel_material = {Material(), soft_steel};
  config.rail_material = {hard_steel, Material()};
  config.rail_bending.table = {softPads(), verySoftPads()};
  return config;
}

/// Sets one option of one side to a value of unequalSides().
struct OptionOfASide
{
  const char* name;
  std::function<void(ContactModelConfig&, Side)> set;
};

const std::vector<OptionOfASide>& optionsOfASide()
{
  static const std::vector<OptionOfASide> options{
      {"wheel profile",
       [](ContactModelConfig& c, Side side) { c.wheel_profile[side] = unequalSides().wheel_profile.right; }},
      {"rail profile",
       [](ContactModelConfig& c, Side side) { c.rail_profile[side] = unequalSides().rail_profile.left; }},
      {"rolling radius", [](ContactModelConfig& c, Side side) { c.wheelset.rolling_radius[side] += 2e-5; }},
      {"inclination", [](ContactModelConfig& c, Side side) { c.track.rail_inclination[side] = std::atan(1.0 / 20); }},
      {"wheel material", [](ContactModelConfig& c, Side side) { c.wheel_material[side] = soft_steel; }},
      {"rail material", [](ContactModelConfig& c, Side side) { c.rail_material[side] = hard_steel; }},
      {"table", [](ContactModelConfig& c, Side side) { c.rail_bending.table[side] = verySoftPads(); }},
  };
  return options;
}

class SidesTest : public testing::Test
{
 protected:
  double within(double low, double high) { return random_.within(low, high); }
  RailDeflection randomDisplacement() { return {within(-1e-3, 1e-3), within(-1e-3, 1e-3), within(-5e-3, 5e-3)}; }
  /// A state with all its values different from zero, but every second one without a yaw.
  WheelsetState randomState()
  {
    WheelsetState state = stateAt(within(-5e-3, 5e-3), std::exp(within(std::log(2e3), std::log(2e5))));
    state.yaw = within(-1, 1) > 0 ? 0 : within(-0.01, 0.01);
    state.torque_x = within(-0.5, 0.5) * state.force_z * 0.75;
    state.rail_lateral_force = {within(-1e4, 3e4), within(-1e4, 3e4)};
    state.rail_displacement = {randomDisplacement(), randomDisplacement()};
    return state;
  }

  Seeded random_{41U};
};
}  // namespace

// Exchanging the sides mirrors the scene. Both sides use the same arithmetic, so every bit is the same, from a cold
// start and with the state before as a start, on rigid rails and on rails that bend under either lateral force.
TEST_F(SidesTest, ExchangedSidesHaveTheMirroredResult)
{
  ContactModelConfig rigid = unequalSides(), bending = rigid, with_forces;
  bending.rail_bending.model = RailBendingConfig::Model::compliance;
  with_forces = bending;
  with_forces.rail_bending.lateral_force = RailBendingConfig::LateralForce::topic;
  int usable = 0;
  for (const ContactModelConfig& config : {rigid, bending, with_forces})
  {
    usable += expectMirroredResults(config, 30, [this] { return randomState(); });
  }
  EXPECT_GE(usable, 85) << "of 90 states";
}

TEST_F(SidesTest, OneValueForBothSidesIsTheValueOfEachSide)
{
  const ContactModelConfig unequal = unequalSides();
  ContactModelConfig both, each;
  both.wheel_profile = unequal.wheel_profile.left;
  both.rail_profile = unequal.rail_profile.right;
  both.wheelset.rolling_radius = 0.459;
  both.track.rail_inclination = std::atan(1.0 / 20);
  both.wheel_material = soft_steel;
  both.rail_material = hard_steel;
  both.rail_bending.table = softPads();
  for (const Side side : sides)
  {
    each.wheel_profile[side] = unequal.wheel_profile.left;
    each.rail_profile[side] = unequal.rail_profile.right;
    each.wheelset.rolling_radius[side] = 0.459;
    each.track.rail_inclination[side] = std::atan(1.0 / 20);
    each.wheel_material[side] = soft_steel;
    each.rail_material[side] = hard_steel;
    each.rail_bending.table[side] = softPads();
  }
  both.rail_bending.model = each.rail_bending.model = RailBendingConfig::Model::compliance;
  WheelsetContact of_both(both), of_each(each);
  for (int i = 0; i < 5; ++i)
  {
    const WheelsetState state = randomState();
    expectSameBits(of_both.evaluate(state), of_each.evaluate(state));
  }
}

// With the given height and roll of the axle, the wheels do not affect one another: the other wheel keeps every bit.
TEST_F(SidesTest, AnOptionOfOneSideChangesTheContactOfThatSideOnly)
{
  ContactModelConfig equal = onPads(softPads());
  equal.wheelset.solve_height_and_roll = false;
  WheelsetContact before(equal);
  const WheelsetState state = heldAt(1e-3, 0.4592);  // 0.8 mm below the height of first touch, on soft rails
  const WheelsetResult& result = okResult(before, state);
  for (const OptionOfASide& option : optionsOfASide())
  {
    for (const Side side : sides)
    {
      SCOPED_TRACE(std::string(option.name) + (side == Side::left ? ", left" : ", right"));
      ContactModelConfig changed = equal;
      option.set(changed, side);
      WheelsetContact contact(changed);
      const WheelsetResult& other = okResult(contact, state);
      const auto kept = patchesOf(other, otherSide(side)), same = patchesOf(result, otherSide(side));
      ASSERT_EQ(kept.size(), same.size());
      for (std::size_t k = 0; k < kept.size(); ++k)
      {
        expectSameBits(*kept[k], *same[k]);
      }
      EXPECT_NE(wheelTotal(other, side).max_pressure, wheelTotal(result, side).max_pressure);
    }
  }
}
