// SPDX-License-Identifier: BSD-3-Clause
#include "../../refusal.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
void expectRefused(const ContactModelConfig& config, const std::string& option)
{
  EXPECT_TRUE(contains(refusalOf([&] { WheelsetContact contact(config); }), option));
}

void expectUnusable(const WheelsetResult& result, ContactStatus status)
{
  EXPECT_EQ(result.status, status) << result.reason;
  EXPECT_FALSE(result.reason.empty());
  EXPECT_TRUE(result.patches.empty());
}

void setGrid(ContactModelConfig& config, int along, int across)
{
  config.contact.cells_along = along;
  config.contact.cells_across = across;
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
    const std::function<void(WheelsetState&)> mistakes[] = {
        [bad](auto& state) { state.y = bad; },
        [bad](auto& state) { state.yaw = bad; },
        [bad](auto& state) { state.force_z = bad; },
        [bad](auto& state) { state.torque_x = bad; },
        [bad](auto& state) { state.rail_lateral_force.right = bad; },
        [bad](auto& state) { state.rail_displacement.right.lateral = bad; },
        [bad](auto& state) { state.rail_displacement.right.vertical = bad; },
        [bad](auto& state) { state.rail_displacement.right.roll = bad; }};
    for (const auto& make : mistakes)
    {
      WheelsetState state = stateAt(0, 1e5);
      make(state);
      expectUnusable(contact.evaluate(state), ContactStatus::invalid_input);
    }
  }
  WheelsetState beyond = stateAt(0, 1e5);
  beyond.rail_displacement.right.lateral = 0.11;
  const WheelsetResult& result = contact.evaluate(beyond);
  expectUnusable(result, ContactStatus::invalid_input);
  EXPECT_TRUE(contains(result.reason, "displacement of a rail"));
  EXPECT_EQ(contact.evaluate(stateAt(0, 1e5)).status, ContactStatus::ok);
}

TEST_F(WheelsetInputTest, GivenHeightAndRollAreCheckedAndMayHaveNoContact)
{
  scene_.wheelset.solve_height_and_roll = false;
  WheelsetContact contact(scene_);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e3})
  {
    expectUnusable(contact.evaluate(heldAt(0, bad)), ContactStatus::invalid_input);
    expectUnusable(contact.evaluate(heldAt(0, 0.46, bad)), ContactStatus::invalid_input);
  }
  const WheelsetResult& raised = contact.evaluate(heldAt(0, 0.47));
  EXPECT_EQ(raised.status, ContactStatus::lift_off);
  EXPECT_TRUE(raised.patches.empty());
  EXPECT_EQ(raised.z, 0.47);
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

TEST_F(WheelsetInputTest, FailureOfTheNormalMethodIsReported)
{
  // Just before flange contact the patch is long and narrow. On such cells the influence matrix of the point forces of
  // the paper is not positive definite.
  scene_.contact.method = NormalMethod::seidel_printed;
  setGrid(scene_, 8, 16);
  WheelsetContact contact(scene_);
  const WheelsetResult& result = contact.evaluate(stateAt(6.5e-3, 1e5));
  expectUnusable(result, ContactStatus::not_converged);
  EXPECT_EQ(result.reason, toString(SolveStatus::indefinite));
}

TEST_F(WheelsetInputTest, InvalidOptionsAreRejectedByName)
{
  const std::pair<const char*, std::function<void(ContactModelConfig&)>> mistakes[] = {
      {"wheel/profile", [](auto& c) { c.wheel_profile = nullptr; }},
      {"rail/profile", [](auto& c) { c.rail_profile = nullptr; }},
      {"track/rail_inclination", [](auto& c) { c.track.rail_inclination = 0.3; }},
      {"material/rail/poisson",
       [](auto& c) {
         c.rail_material = Material{2.1e11, 0.6};
       }},
      {"contact/grid/across", [](auto& c) { c.contact.cells_along = 16; }},
      {"contact/grid/across", [](auto& c) { setGrid(c, 16, 63); }},
      {"contact/grid/along", [](auto& c) { setGrid(c, 2, 16); }},
      {"rail_bending/prescribed/lateral", [](auto& c) { c.rail_bending.prescribed.lateral = std::nan(""); }},
      {"rail_bending/prescribed/roll", [](auto& c) { c.rail_bending.prescribed.roll = 0.5; }},
      {"rail_bending/lateral_force", [](auto& c) { c.rail_bending.lateral_force_value = HUGE_VAL; }},
      {"lateral_roll",
       [](auto& c) {
         c.rail_bending.table = ComplianceTable{1e-9, 1e-6, 1e-9, 1e-9};
       }},
      // Of one side.
      {"wheel/left/profile", [](auto& c) { c.wheel_profile.left = nullptr; }},
      {"rail/right/profile", [](auto& c) { c.rail_profile.right = nullptr; }},
      {"wheel/right/rolling_radius", [](auto& c) { c.wheelset.rolling_radius.right = -0.46; }},
      {"wheel/left/rolling_radius", [](auto& c) { c.wheelset.rolling_radius.left = std::nan(""); }},
      {"rail/left/inclination", [](auto& c) { c.track.rail_inclination.left = 0.3; }},
      {"wheel/right/material/young", [](auto& c) { c.wheel_material.right.young = 0; }},
      {"rail/left/material/poisson", [](auto& c) { c.rail_material.left.poisson = 0.6; }},
      {"lateral_roll", [](auto& c) { c.rail_bending.table.right.lateral_roll = 1; }},
  };
  for (const auto& [option, make] : mistakes)
  {
    ContactModelConfig config = scene_;
    make(config);
    expectRefused(config, option);
  }
}

TEST_F(WheelsetInputTest, UnusableLengthsAndToleranceAreRejectedByName)
{
  const std::pair<const char*, std::function<void(ContactModelConfig&, double)>> options[] = {
      {"track/gauge", [](auto& c, double value) { c.track.gauge = value; }},
      {"track/gauge_depth", [](auto& c, double value) { c.track.gauge_depth = value; }},
      {"wheelset/rolling_radius", [](auto& c, double value) { c.wheelset.rolling_radius = value; }},
      {"wheelset/flange_back_distance", [](auto& c, double value) { c.wheelset.flange_back_distance = value; }},
      {"wheelset/tape_circle", [](auto& c, double value) { c.wheelset.tape_circle = value; }},
      {"material/wheel/young",
       [](auto& c, double value) {
         c.wheel_material = Material{value, 0.28};
       }},
      {"contact/tolerance", [](auto& c, double value) { c.contact.tolerance = value; }},
  };
  for (const auto& [option, set] : options)
  {
    for (const double bad : {std::nan(""), 0.0, -1.0, 1e3})  // the last one is in millimetres
    {
      const bool modulus = option == std::string("material/wheel/young");
      ContactModelConfig config = scene_;
      set(config, modulus && bad > 0 ? -bad : bad);
      expectRefused(config, option);
    }
  }
}

// A height of 0 was never set. One that is more than 10 mm too low is that of another point. Above it the forces are
// computed, and flagged above 1 MN.
TEST_F(WheelsetInputTest, AHeightFarBelowTheRailsHasItsOwnStatus)
{
  scene_.wheelset.solve_height_and_roll = false;
  WheelsetContact contact(scene_);
  for (const double y : {0.0, 3e-3, 6.5e-3})
  {
    for (const double z : {0.0, 0.2, 0.4, 0.445})
    {
      expectUnusable(contact.evaluate(heldAt(y, z)), ContactStatus::too_deep);
    }
    const WheelsetResult& deep = contact.evaluate(heldAt(y, 0.455));
    EXPECT_TRUE(isUsable(deep.status)) << deep.reason;
    EXPECT_TRUE(deep.implausible_force);
    EXPECT_NE(deep.reason.find("1 MN"), std::string::npos) << deep.reason;
    const WheelsetResult& shallow = contact.evaluate(heldAt(y, 0.4598));
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
    const WheelsetResult& result = contact.evaluate(heldAt(y, height));
    EXPECT_NE(result.status, ContactStatus::too_deep) << "y = " << y << " m: " << result.reason;
    EXPECT_TRUE(!isUsable(result.status) || result.implausible_force) << "y = " << y << " m";
  }
}
