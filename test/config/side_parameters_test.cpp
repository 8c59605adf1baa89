// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

using namespace wheel_rail_contact;

namespace
{
const char* const stiff = "config/rails/pads_40_100.yaml";
const char* const soft = "config/rails/pads_10_25.yaml";

NodeConfig readText(const std::string& yaml)
{
  return read(parameterTree(YAML::Load(yaml)));
}

/// Files wheel.csv and, with the sign of y changed, mirrored.csv, in the folder that read() takes for relative names.
class ProfileGroup : public testing::Test
{
 protected:
  ProfileGroup()
  {
    writePoints("wheel.csv", core::s1002Wheel(), "y_m,z_m\n");
    writePoints("mirrored.csv", core::s1002Wheel(), "y_m,z_m\n", [](double& y, double&) { y = -y; });
  }

  static void expectWheel(const core::Profile& profile, const char* name)
  {
    EXPECT_EQ(profile.name(), name);
    EXPECT_NEAR(profile.at(0).y, -0.070, 1e-9) << "the flange back comes first";
  }
};
}  // namespace

TEST(SideParameters, ValueForBothSidesSetsBoth)
{
  const core::ContactModelConfig model =
      read(
          with("{wheelset: {rolling_radius: 0.45}, track: {rail_inclination: 1:20}, rail: {profile: UIC60_manchester}, "
               "material: {wheel: {young: 2e11}, rail: {poisson: 0.3}}, rail_bending: {model: compliance, table: " +
               std::string(stiff) + "}}"))
          .model;
  for (const core::Side side : core::sides)
  {
    EXPECT_EQ(model.wheelset.rolling_radius[side], 0.45);
    EXPECT_EQ(model.track.rail_inclination[side], std::atan(1.0 / 20));
    EXPECT_EQ(model.rail_profile[side]->name(), "UIC60_manchester");
    EXPECT_EQ(model.wheel_profile[side]->name(), "S1002");
    EXPECT_EQ(model.wheel_material[side].young, 2e11);
    EXPECT_EQ(model.rail_material[side].poisson, 0.3);
    EXPECT_EQ(model.rail_bending.table[side].vertical_vertical, model.rail_bending.table.left.vertical_vertical);
  }
  EXPECT_EQ(model.rail_profile.left, model.rail_profile.right) << "opened once";
  EXPECT_EQ(model.wheel_profile.left, model.wheel_profile.right) << "opened once";
}

TEST(SideParameters, ValueOfASideOverridesThatForBoth)
{
  for (const core::Side side : core::sides)
  {
    const std::string name = side == core::Side::left ? "left" : "right";
    const core::Side other = side == core::Side::left ? core::Side::right : core::Side::left;
    SCOPED_TRACE(name);
    const NodeConfig config =
        read(with("{wheel: {" + name + ": {rolling_radius: 0.459, material: {young: 2e11}}}, rail: {" + name +
                  ": {profile: UIC60_manchester, inclination: 1:20, table: " + soft +
                  ", material: {poisson: 0.3}}}, rail_bending: {model: compliance, table: " + stiff +
                  ", neighbours: [{topic: front, distance: 2.5}]}}"));
    const core::ContactModelConfig &model = config.model, standard = core::ContactModelConfig();
    EXPECT_EQ(model.wheelset.rolling_radius[side], 0.459);
    EXPECT_EQ(model.wheelset.rolling_radius[other], standard.wheelset.rolling_radius.left);
    EXPECT_EQ(model.track.rail_inclination[side], std::atan(1.0 / 20));
    EXPECT_EQ(model.track.rail_inclination[other], standard.track.rail_inclination.left);
    EXPECT_EQ(model.wheel_material[side].young, 2e11);
    EXPECT_EQ(model.wheel_material[side].poisson, standard.wheel_material.left.poisson) << "that for both sides";
    EXPECT_EQ(model.wheel_material[other], standard.wheel_material.left);
    EXPECT_EQ(model.rail_material[side].poisson, 0.3);
    EXPECT_EQ(model.rail_material[other], standard.rail_material.left);
    EXPECT_EQ(model.rail_profile[side]->name(), "UIC60_manchester");
    EXPECT_EQ(model.rail_profile[other]->name(), "60E1");
    const auto& tables = model.rail_bending.table;
    EXPECT_GT(tables[side].vertical_vertical, 2 * tables[other].vertical_vertical);
    EXPECT_EQ(config.neighbours[0].influence[side].lateral_lateral, 2.1963e-8);  // value in the table
    EXPECT_NE(config.neighbours[0].influence[other].lateral_lateral, 2.1963e-8);
  }
}

TEST(SideParameters, ValuesOfBothSidesNeedNoValueForBoth)
{
  const NodeConfig config = readText(
      "{wheel: {left: {profile: S1002}, right: {profile: S1002}}, "
      "rail: {left: {profile: 60E1, table: " +
      std::string(stiff) + "}, right: {profile: UIC60_manchester, table: " + soft +
      "}}, rail_bending: {model: compliance}}");
  EXPECT_EQ(config.model.rail_profile.left->name(), "60E1");
  EXPECT_EQ(config.model.rail_profile.right->name(), "UIC60_manchester");
  EXPECT_EQ(config.linear_range.left, 0.6);
  EXPECT_EQ(config.linear_range.right, 0.6);
  const char* without_right[] = {
      "{wheel: {left: {profile: S1002}}, rail: {profile: 60E1}}",
      "{wheel: {profile: S1002}, rail: {left: {profile: 60E1}}}",
      "{wheel: {profile: S1002}, rail: {profile: 60E1, left: {table: config/rails/pads_40_100.yaml}}, "
      "rail_bending: {model: compliance}}"};
  const char* names[] = {"wheel/profile is missing", "rail/profile is missing", "rail_bending/table"};
  for (int i = 0; i < 3; ++i)
  {
    const std::string message = refusal(parameterTree(YAML::Load(without_right[i])));
    EXPECT_TRUE(contains(message, std::string("/contact_node/") + names[i])) << message;
  }
}

// roslaunch and rosparam read 1:20 as 80, and a name 60E1 on a command line as 600.
TEST(SideParameters, NumbersThatRosMakesOfTextsAreRead)
{
  const char* yaml = "rail: {left: {profile: 600, inclination: 80}, right: {profile: 60E1}}";
  const core::ContactModelConfig model = read(with(yaml)).model;
  EXPECT_EQ(model.rail_profile.left->name(), "60E1");
  EXPECT_EQ(model.track.rail_inclination.left, std::atan(1.0 / 20));
  EXPECT_EQ(model.track.rail_inclination.right, core::TrackConfig().rail_inclination.right);
}

TEST_F(ProfileGroup, ReplacesTheNameInTheDefaultFile)
{
  const auto wheels = [](const std::string& yaml) { return read(with(yaml)).model.wheel_profile; };
  for (const char* yaml : {"wheel: {profile: {file: mirrored.csv, mirror: true}}",
                           "wheel: {profile: {file: mirrored.csv, mirror: 'true'}}",
                           "wheel: {profile: S1002, left: {profile: {file: mirrored.csv, mirror: true}}, right: "
                           "{profile: {file: mirrored.csv, mirror: true}}}"})
  {
    SCOPED_TRACE(yaml);
    const auto both = wheels(yaml);
    expectWheel(*both.left, "mirrored.csv");
    EXPECT_EQ(both.left, both.right) << "opened once";
  }
  for (const char* yaml : {"wheel: {profile: {file: wheel.csv}}", "wheel: {profile: {file: wheel.csv, mirror: false}}",
                           "wheel: {profile: wheel.csv}"})
  {
    SCOPED_TRACE(yaml);
    expectWheel(*wheels(yaml).right, "wheel.csv");
  }
  EXPECT_EQ(wheels("wheel: {profile: {file: S1002}}").left->name(), "S1002");
}

TEST_F(ProfileGroup, OfOneSideReplacesTheProfileForBoth)
{
  const auto wheels =
      read(with("wheel: {profile: {file: wheel.csv}, right: {profile: {file: mirrored.csv, mirror: true}}}"))
          .model.wheel_profile;
  expectWheel(*wheels.left, "wheel.csv");
  expectWheel(*wheels.right, "mirrored.csv");
  const auto named = read(with("wheel: {profile: {file: mirrored.csv, mirror: true}, left: {profile: S1002}}"));
  EXPECT_EQ(named.model.wheel_profile.left->name(), "S1002") << "not mirrored";
  expectWheel(*named.model.wheel_profile.right, "mirrored.csv");
}

TEST_F(ProfileGroup, IsReplacedByAName)
{
  const ParameterTree group = with("wheel: {profile: {file: mirrored.csv, mirror: true}}");
  const ParameterTree name = overlay(group, parameterTree(YAML::Load("wheel: {profile: S1002}")));
  EXPECT_EQ(read(name).model.wheel_profile.left->name(), "S1002");
  const ParameterTree file = overlay(group, parameterTree(YAML::Load("wheel: {profile: {file: wheel.csv}}")));
  EXPECT_TRUE(contains(refusal(file), "reversed")) << "mirror remains: " << refusal(file);
}

TEST_F(ProfileGroup, MistakesAreRefusedByTheirName)
{
  expectRefused({
      {"wheel: {profile: {mirror: true}}", "wheel/profile/file", "missing"},
      {"wheel: {left: {profile: {mirror: true}}}", "wheel/left/profile/file", "missing"},
      {"wheel: {profile: {file: mirrored.csv, mirror: yes}}", "wheel/profile/mirror", "yes"},
      {"wheel: {profile: {file: mirrored.csv, mirror: 1}}", "wheel/profile/mirror", "1"},
      {"wheel: {profile: {file: mirrored.csv, mirror: }}", "wheel/profile/mirror", "no value"},
      {"wheel: {profile: {file: [wheel.csv]}}", "wheel/profile/file", "[wheel.csv]"},
      {"wheel: {profile: {file: none.csv, mirror: true}}", "wheel/profile/file", "none.csv"},
      {"wheel: {profile: {file: mirrored.csv}}", "wheel/profile/file", "reversed"},
      {"wheel: {profile: {file: wheel.csv, mirror: true}}", "wheel/profile/file", "reversed"},
      {"wheel: {profile: {file: S1002, mirror: true}}", "wheel/profile/file", "standard profile"},
      {"wheel: {profile: {name: S1002}}", "wheel/profile/name", "wheel/profile/file"},
  });
  ParameterTree both = defaults();
  both.emplace("wheel/profile/file", YAML::Node("wheel.csv"));
  EXPECT_TRUE(contains(refusal(both), "/contact_node/wheel/profile = S1002")) << refusal(both);
}

TEST(SideParameters, MistakesAreRefusedByTheirName)
{
  expectRefused({
      {"wheel: {right: {profile: ''}}", "wheel/right/profile", ""},
      {"wheel: {right: S1002}", "wheel/right", "unknown"},
      {"wheel: {middle: {profile: S1002}}", "wheel/middle/profile", "unknown"},
      {"wheel: {left: {radius: 0.46}}", "wheel/left/radius", "wheel/left/rolling_radius"},
      {"wheel: {left: {inclination: 1:40}}", "wheel/left/inclination", "unknown"},
      {"wheel: {left: {material: steel}}", "wheel/left/material", "unknown"},
      {"rail: {left: {rolling_radius: 0.46}}", "rail/left/rolling_radius", "unknown"},
      {"{rail: {left: {table: none.yaml}}, rail_bending: {model: compliance, table: config/rails/pads_40_100.yaml}}",
       "rail/left/table", "none.yaml"},
      {"{rail: {left: {table: ''}}, rail_bending: {model: compliance, table: config/rails/pads_40_100.yaml}}",
       "rail_bending/table", "compliance"},
      {"{rail: {left: {table: config/rails/paper.yaml}}, rail_bending: {model: compliance, "
       "table: config/rails/pads_40_100.yaml, neighbours: [{topic: front, distance: 2.5}]}}",
       "rail_bending/neighbours/distance", "none"},
  });
}

TEST(Parameters, FrictionOfASideOverridesThatForBoth)
{
  const core::CreepConfig creep =
      read(with("creep: {method: exact, friction: 0.4, slip_share: 0.5, left: {friction: 0.1}, "
                "right: {slip_decay: 0.6}, rotation: topic, field: true}"))
          .model.creep;
  EXPECT_EQ(creep.method, core::CreepMethod::exact);
  EXPECT_EQ(creep.friction.left.coefficient, 0.1);
  EXPECT_EQ(creep.friction.right.coefficient, 0.4);
  EXPECT_EQ(creep.friction.left.slip_share, 0.5);
  EXPECT_EQ(creep.friction.left.slip_decay, 0);
  EXPECT_EQ(creep.friction.right.slip_decay, 0.6);
  EXPECT_EQ(creep.rotation, core::CreepConfig::Rotation::given);
  EXPECT_TRUE(creep.field);
}

TEST(Parameters, MistakesInCreepAreRefusedByTheirName)
{
  expectRefused({
      {"creep: {method: kalker}", "creep/method = kalker", "none, linear, fastsim, exact"},
      {"creep: {friction: 2.1}", "creep/friction = 2.1", "from 0 to 2"},
      {"creep: {right: {friction: 2.1}}", "creep/right/friction = 2.1", "from 0 to 2"},
      {"creep: {slip_share: 1.1}", "creep/slip_share = 1.1", "from 0 to 1"},
      {"creep: {left: {slip_decay: -0.1}}", "creep/left/slip_decay = -0.1", "at least 0"},
      {"creep: {rotation: pose}", "creep/rotation = pose", "free, topic"},
      {"creep: {method: fastsim, field: true}", "creep/field = true", "false unless creep/method is exact"},
      {"{creep: {method: linear}, rail: {profile: {file: 60E1, parts: [{file: 60E1}]}}}", "creep/method = linear",
       "sections"},
  });
}
