// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
void expectRefused(const ContactModelConfig& config, const std::string& option)
{
  try
  {
    const WheelsetContact contact(config);
    ADD_FAILURE() << "an invalid " << option << " was accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(option), std::string::npos) << error.what();
  }
}

void expectUnusable(const WheelsetResult& result, ContactStatus status)
{
  EXPECT_EQ(result.status, status) << result.reason;
  EXPECT_FALSE(result.reason.empty());
  EXPECT_TRUE(result.patches.empty());
}

class WheelsetInputTest : public testing::Test
{
 protected:
  ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

TEST_F(WheelsetInputTest, NonFiniteOrHugeValuesAreRejectedWithAReason)
{
  WheelsetContact contact(scene_);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity, 1e300, -1e300})
  {
    WheelsetState state = stateAt(0, 1e5);
    state.y = bad;
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    state = stateAt(0, 1e5, bad);
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    state = stateAt(0, 1e5);
    state.force_z = bad;
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    state = stateAt(0, 1e5);
    state.torque_x = bad;
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    state = stateAt(0, 1e5);
    state.rail_lateral_force.right = bad;
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    for (const auto coordinate : {&RailDeflection::lateral, &RailDeflection::vertical, &RailDeflection::roll})
    {
      state = stateAt(0, 1e5);
      state.rail_displacement.right.*coordinate = bad;
      expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    }
  }
  EXPECT_EQ(contact.evaluate(stateAt(0, 1e5)).status, ContactStatus::ok);
}

TEST_F(WheelsetInputTest, GivenHeightAndRollAreChecked)
{
  scene_.wheelset.solve_height_and_roll = false;
  WheelsetContact contact(scene_);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e3})
  {
    WheelsetState state;
    state.z = bad;
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    state.z = 0.46;
    state.roll = bad;
    expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
  }
}

TEST_F(WheelsetInputTest, WheelBesideItsRailIsOffTheProfile)
{
  WheelsetContact contact(scene_);
  for (const double y : {-0.095, 0.095})
  {
    expectUnusable(contact.evaluate(stateAt(y, 1e5)), ContactStatus::off_profile);
  }
  EXPECT_EQ(contact.evaluate(stateAt(0, 1e5)).status, ContactStatus::ok);
}

TEST_F(WheelsetInputTest, RaisedWheelsetHasNoContact)
{
  scene_.wheelset.solve_height_and_roll = false;
  WheelsetContact contact(scene_);
  WheelsetState state;
  state.z = 0.47;
  const WheelsetResult& result = contact.evaluate(state);
  EXPECT_EQ(result.status, ContactStatus::lift_off);
  EXPECT_TRUE(result.patches.empty());
  EXPECT_EQ(result.z, 0.47);
}

TEST_F(WheelsetInputTest, FailureOfTheNormalMethodIsReported)
{
  // Just before flange contact the patch is long and narrow. On such cells the influence matrix of the point forces of
  // the paper is not positive definite.
  scene_.contact.method = NormalMethod::seidel_printed;
  scene_.contact.cells_along = 8;
  scene_.contact.cells_across = 16;
  WheelsetContact contact(scene_);
  const WheelsetResult& result = contact.evaluate(stateAt(6.5e-3, 1e5));
  expectUnusable(result, ContactStatus::not_converged);
  EXPECT_EQ(result.reason, toString(SolveStatus::indefinite));
}

TEST_F(WheelsetInputTest, InvalidOptionsAreRejectedByName)
{
  const double nan = std::nan("");
  ContactModelConfig config = scene_;
  config.wheel_profile = nullptr;
  expectRefused(config, "wheel/profile");
  config = scene_;
  config.rail_profile = nullptr;
  expectRefused(config, "rail/profile");
  for (const double bad : {nan, 0.0, -1.0, 1e3})  // the last one is in millimetres
  {
    config = scene_;
    config.track.gauge = bad;
    expectRefused(config, "track/gauge");
    config = scene_;
    config.track.gauge_depth = bad;
    expectRefused(config, "track/gauge_depth");
    config = scene_;
    config.wheelset.rolling_radius = bad;
    expectRefused(config, "wheelset/rolling_radius");
    config = scene_;
    config.wheelset.flange_back_distance = bad;
    expectRefused(config, "wheelset/flange_back_distance");
    config = scene_;
    config.wheelset.tape_circle = bad;
    expectRefused(config, "wheelset/tape_circle");
    config = scene_;
    config.wheel_material = Material{bad < 1 ? bad : nan, 0.28};
    expectRefused(config, "material/wheel/young");
    config = scene_;
    config.contact.tolerance = bad;
    expectRefused(config, "contact/tolerance");
  }
  config = scene_;
  config.track.rail_inclination = 0.3;
  expectRefused(config, "track/rail_inclination");
  config = scene_;
  config.rail_material = Material{2.1e11, 0.6};
  expectRefused(config, "material/rail/poisson");
}

TEST_F(WheelsetInputTest, InvalidGridsAndRailsAreRejectedByName)
{
  ContactModelConfig config = scene_;
  config.contact.cells_along = 16;
  expectRefused(config, "contact/grid/across");
  config.contact.cells_across = 63;
  expectRefused(config, "contact/grid/across");
  config = scene_;
  config.contact.cells_along = 2;
  config.contact.cells_across = 16;
  expectRefused(config, "contact/grid/along");
  config = scene_;
  config.rail_bending.prescribed.lateral = std::nan("");
  expectRefused(config, "rail_bending/prescribed/lateral");
  config = scene_;
  config.rail_bending.prescribed.roll = 0.5;
  expectRefused(config, "rail_bending/prescribed/roll");
  config = scene_;
  config.rail_bending.lateral_force_value = std::numeric_limits<double>::infinity();
  expectRefused(config, "rail_bending/lateral_force");
  config = scene_;
  config.rail_bending.table = ComplianceTable{1e-9, 1e-6, 1e-9, 1e-9};
  expectRefused(config, "lateral_roll");
}

// A height of 0 was never set. One that is more than 10 mm too low is that of another point. Above it the forces are
// computed, and flagged above 1 MN.
TEST_F(WheelsetInputTest, AHeightFarBelowTheRailsHasItsOwnStatus)
{
  scene_.wheelset.solve_height_and_roll = false;
  WheelsetContact contact(scene_);
  for (const double y : {0.0, 3e-3, 6.5e-3})
  {
    WheelsetState state;
    state.y = y;
    for (const double z : {0.0, 0.2, 0.4, 0.445})
    {
      state.z = z;
      expectUnusable(contact.evaluate(state), ContactStatus::too_deep);
    }
    state.z = 0.455;
    const WheelsetResult& deep = contact.evaluate(state);
    EXPECT_TRUE(isUsable(deep.status)) << deep.reason;
    EXPECT_TRUE(deep.implausible_force);
    EXPECT_NE(deep.reason.find("1 MN"), std::string::npos) << deep.reason;
    state.z = 0.4598;
    const WheelsetResult& shallow = contact.evaluate(state);
    EXPECT_TRUE(isUsable(shallow.status)) << shallow.reason;
    EXPECT_EQ(shallow.implausible_force, y > 6e-3);
  }
}

// At the right height, a wrong lateral position presses only the flange into its rail. Its own reason must not be
// hidden.
TEST_F(WheelsetInputTest, AWrongLateralPositionIsNotAWrongHeight)
{
  WheelsetContact loaded(scene_);
  const double height = loaded.evaluate(stateAt(0, 5e4)).z;
  scene_.wheelset.solve_height_and_roll = false;
  WheelsetContact contact(scene_);
  for (const double y : {12e-3, 20e-3, 30e-3, 50e-3, 90e-3})
  {
    WheelsetState state;
    state.y = y;
    state.z = height;
    const WheelsetResult& result = contact.evaluate(state);
    EXPECT_NE(result.status, ContactStatus::too_deep) << "y = " << y << " m: " << result.reason;
    EXPECT_TRUE(!isUsable(result.status) || result.implausible_force) << "y = " << y << " m";
  }
}
