// SPDX-License-Identifier: BSD-3-Clause
#include "config/node_config.h"

#include <set>

#include "parameter_helpers.h"

using namespace wheel_rail_contact;

namespace
{
std::string lastOf(const std::string& name)
{
  return name.substr(name.rfind('/') + 1);
}

/// True for parameters of one side, and for members of a group in place of the name of a profile or a line.
bool isOnlyExplained(const std::string& name)
{
  return contains(name, "/left/") || contains(name, "/right/") || contains(name, "/profile/") ||
         contains(name, "/line/");
}

/// A valid value of every parameter except the members of a group in place of the name of a file.
ParameterTree complete()
{
  const std::string wheel =
      "{profile: S1002, rolling_radius: 0.46, material: {young: 2.1e+11, poisson: 0.28, yield: 5e+8}}";
  const std::string rail =
      "{profile: 60E1, inclination: 0.025, table: '', material: {young: 2.1e+11, poisson: 0.28, yield: 5e+8}}";
  const std::string creep = "{friction: 0.3, slip_share: 1, slip_decay: 0}";
  const auto both = [](const std::string& side) { return "{left: " + side + ", right: " + side + "}"; };
  return with("{wheel: " + both(wheel) + ", rail: " + both(rail) + ", creep: " + both(creep) + "}");
}

/// Valid parameters with another value of one of them. Values for both sides are not overridden by values of the sides.
ParameterTree validExcept(const std::string& name, const YAML::Node& value)
{
  ParameterTree upper{{name, value}};
  if (const std::string group = name.substr(0, name.rfind('/')); name == group + "/mirror" || name == group + "/axes")
  {
    upper.emplace(group + "/file", YAML::Node("file.csv"));
  }
  return overlay(isOnlyExplained(name) ? complete() : defaults(), upper);
}

/// Known names in the message for an unknown one.
std::vector<std::string> knownNames(const std::string& parameters)
{
  const std::string message = refusal(with(parameters));
  std::istringstream list(message.substr(message.find(": ", message.find("; known names")) + 1));
  std::vector<std::string> names;
  for (std::string name; std::getline(list >> std::ws, name, ',');)
  {
    names.push_back(name);
  }
  return names;
}

/// Names of all parameters, given or not: the messages for an unknown one in each group list them.
std::vector<std::string> parameterNames()
{
  std::vector<std::string> names;
  for (const std::string& group : knownNames("{unknown: 1}"))
  {
    const bool is_value = defaults().count(group) > 0;  // outside of groups
    const std::vector<std::string> members =
        is_value ? std::vector<std::string>{group} : knownNames("{" + group + ": {unknown: 1}}");
    names.insert(names.end(), members.begin(), members.end());
  }
  return names;
}

/// True if a parameter is a number in the complete parameters.
bool isNumber(const std::string& name)
{
  static const ParameterTree good = complete();
  const auto entry = good.find(name);
  double number = 0;
  return entry != good.end() && YAML::convert<double>::decode(entry->second, number);
}
}  // namespace

// Parameters of one side, and the groups with a file, are not set: a value would override the plain name.
TEST(Parameters, DefaultFileSetsOrExplainsExactlyTheKnownParameters)
{
  std::ifstream file(packageFile("config/default.yaml"));
  std::string comments;
  for (std::string line; std::getline(file, line);)
  {
    comments += line.substr(std::min(line.find('#'), line.size()));
  }
  std::set<std::string> set, known;
  for (const auto& entry : defaults())
  {
    set.insert(entry.first);
  }
  for (const std::string& name : parameterNames())
  {
    if (isOnlyExplained(name))
    {
      EXPECT_TRUE(contains(comments, lastOf(name) + ":")) << name;
    }
    else
    {
      known.insert(name);
    }
  }
  EXPECT_EQ(set, known);
}

TEST(Parameters, DefaultFileHasTheDefaultsOfTheCode)
{
  const NodeConfig file = read(defaults());
  const auto values = [](const NodeConfig& config)
  {
    const core::ContactModelConfig& model = config.model;
    const core::RailBendingConfig& bending = model.rail_bending;
    return std::make_tuple(
        model.track.gauge, model.track.gauge_depth, config.track_frame, config.displacement_topic,
        config.distance_topic, model.wheelset.flange_back_distance, model.wheelset.tape_circle,
        model.wheelset.solve_height_and_roll, bending.model, bending.lateral_force, bending.prescribed.lateral,
        bending.prescribed.vertical, bending.prescribed.roll, model.contact.method, model.contact.tolerance,
        model.contact.cells_along, model.contact.cells_across, model.contact.check_branches, model.contact.derivatives,
        model.creep.method, model.creep.rotation, model.creep.field, config.slop, config.interpolate_load,
        config.longest_gap, config.markers.rate, config.markers.rail_length, config.markers.force_scale,
        config.markers.max_pressure, config.markers.zoom, config.markers.zoom_height, config.markers.pressure_height,
        config.min_rate, config.max_delay);
  };
  EXPECT_EQ(values(file), values(NodeConfig()));
  const std::string required = "{wheel: {profile: S1002}, rail: {profile: 60E1}}";  // nothing else
  EXPECT_EQ(values(read(parameterTree(YAML::Load(required)))), values(NodeConfig()));
  for (const core::Side side : core::sides)
  {
    const auto values_of_side = [side](const core::ContactModelConfig& model)
    {
      const core::FrictionLaw& friction = model.creep.friction[side];
      return std::make_tuple(model.track.rail_inclination[side], model.wheelset.rolling_radius[side],
                             model.wheel_material[side], model.rail_material[side], friction.coefficient,
                             friction.slip_share, friction.slip_decay);
    };
    EXPECT_EQ(values_of_side(file.model), values_of_side(NodeConfig().model));
  }
  EXPECT_EQ(file.model.wheel_profile.left->name(), "S1002");
  EXPECT_EQ(file.model.rail_profile.left->name(), "60E1");
}

TEST(Parameters, NumbersMayBeWrittenAsStrings)
{
  for (const char* text : {"210e9", "2.1e11", "'210e9'", "210000000000", "+2.1E+11", "210000000000.0"})
  {
    const NodeConfig config = read(with(std::string("material: {wheel: {young: ") + text + "}}"));
    EXPECT_EQ(config.model.wheel_material.left.young, 2.1e11) << text;
  }
}

// On a command line ROS reads 60E1 as the number 60e1. No two names may be the same number.
TEST(Parameters, RailNamesAreFoundWhenRosReadsThemAsNumbers)
{
  const std::pair<const char*, const char*> rails[] = {
      {"54E1", "540"}, {"54E3", "54000"}, {"56E1", "560"}, {"60E1", "600"}, {"60E2", "6000"}};
  for (const auto& [name, number] : rails)
  {
    for (const std::string value : {number, name})
    {
      EXPECT_EQ(read(with("rail: {profile: " + value + "}")).model.rail_profile.left->name(), name);
    }
  }
  EXPECT_TRUE(contains(refusal(with("rail: {profile: 610}")), "rail/profile = 610: neither the name of a standard"));
}

// Wrong types, numbers that are not finite, and -1 follow below, for every parameter.
TEST(Parameters, EachInvalidValueIsRefusedWithItsName)
{
  expectValuesRefused(R"(
      track/gauge: 0 | 1.435m | '1.435 ' | 0x10 | 1e400 | [1.435]
      track/frame: /track
      track/displacement: true
      track/distance: 12.5
      wheelset/rolling_radius: 0
      wheelset/free: [z] | z | [z, roll, y] | [[z], roll]
      wheel/profile: S1001 | 60E1 | missing.prw
      rail/profile: package://no_such_package/a.prr | package://wheel_rail_contact/no.prr | /nowhere/a.prr
      material/wheel/young: -2
      material/rail/young: 0
      material/rail/poisson: 0.6
      material/wheel/poisson: -1
      stress/depths: 3 | 4.5
      rail_bending/model: beam | 1
      rail_bending/lateral_force: sometimes
      rail_bending/prescribed/roll: 1
      rail_bending/neighbours: 3
      contact/tolerance: 0 | 2
      markers/rate: 0
      markers/rail_length: 0
      sync/slop: -0.001 | 1e9
      sync/longest_gap: 61
      wheel/left/profile: S1001
      wheel/right/profile: 60E1 | missing.prw
      wheel/left/rolling_radius: -0.46
      wheel/left/material/young: 0
      rail/right/material/poisson: 0.6
      rail/right/inclination: 0.3 | '1:0'
      rail/left/inclination: flat
  )");
  expectRefused(
      {{"track: {gauge: ''}", "track/gauge", "\"\""},
       {"track: {gauge: }", "track/gauge", "no value"},
       {"track: {frame: ''}", "track/frame", "\"\""},
       {"track: {displacement: pose}", "track/displacement", "none, topic"},
       {"track: {displacement: {lateral: 0.001}}", "track/displacement/lateral", "unknown"},
       {"track: {distance: none}", "track/distance", "pose, topic"},
       {"track: {gage: 1.435}", "track/gage", "track/gauge"},
       {"track: 1.435", "track", "unknown"},
       {"wheel: {profile: ''}", "wheel/profile", ""},
       {"wheel: {profile: /nowhere/wheel.csv}", "wheel/profile = /nowhere/wheel.csv: no such file", "wheel.csv"},
       {"material: {rail: {young: 210000}}", "material/rail/young = 210000", "from 1e9 to 1e13, in Pa"},
       {"material: {wheel: {yield: 500}}", "material/wheel/yield = 500", "0, or from 1e6 to 1e13, in Pa"},
       {"stress: {field: true}", "stress/depths", "0"},
       {"material: {axle: {young: 1}}", "material/axle/young", "material/wheel/young"},
       {"rail_bending: {model: compliance}", "rail_bending/table", "file"},
       {"rail_bending: {model: compliance, table: missing.yaml}", "rail_bending/table", "missing.yaml"},
       {"rail_bending: {model: prescribed, prescribed: {lateral: 2}}", "rail_bending/prescribed/lateral", "2"},
       {"rail_bending: {neighbours: [{topic: /front, distance: 2.5}]}", "rail_bending/neighbours", "/front"},
       {"rail_bending: {neighbours: [{topic: /front}]}", "rail_bending/neighbours/distance", "missing"},
       {"rail_bending: {neighbours: [{distance: 2.5}]}", "rail_bending/neighbours/topic", "missing"},
       {"rail_bending: {neighbours: [{topic: a b, distance: 2.5}]}", "rail_bending/neighbours/topic", "a b"},
       {"rail_bending: {neighbours: [{topic: ~contact, distance: 2.5}]}", "rail_bending/neighbours/topic", "~contact"},
       {"rail_bending: {neighbours: [{topic: front, distance: -2.5}]}", "rail_bending/neighbours/distance", "-2.5"},
       {"rail_bending: {neighbours: [{topic: front, distance: 2.5, gap: 1}]}", "rail_bending/neighbours/gap", "topic"},
       {"rail_bending: {neighbours: [{topic: f, distance: 2.5}, {topic: f, distance: 1.8}]}",
        "rail_bending/neighbours/topic", "once"},
       {"rail_bending: {model: compliance, table: config/rails/pads_40_100.yaml, "
        "neighbours: [{topic: front, distance: 3}]}",
        "rail_bending/neighbours/distance", "1.8 m to 2.5 m"},
       {"rail_bending: {model: compliance, table: config/rails/paper.yaml, neighbours: [{topic: front, distance: "
        "2.5}]}",
        "rail_bending/neighbours/distance", "the table has none"},
       {"contact: {method: magic}", "contact/method",
        "auto, hertz, kik_piotrowski, seidel, seidel_printed, conjugate_gradient"},
       {"contact: {grid: {along: 16}}", "contact/grid", "0"},
       {"contact: {grid: {along: 16.5, across: 16}}", "contact/grid/along", "16.5"},
       {"contact: {grid: {along: 16, across: -16}}", "contact/grid/across", "-16"},
       {"contact: {grid: {along: 1e9, across: 16}}", "contact/grid/along", "1e9"},
       {"gauge: 1.435", "gauge", "unknown"},
       {"track: {cant: 0.025}", "track/cant = 0.025", "track/rail_inclination"},
       {"track: {cant: 0.025, rail_inclination: 0.025}", "track/cant = 0.025", "track/rail_inclination"},
       {"sync: {load: nearest}", "sync/load = nearest", "match, interpolate"},
       {"sync: {longest_gap: 0}", "sync/longest_gap", "above 0"},
       {"{sync: {load: interpolate}, wheelset: {free: []}}", "sync/load = interpolate",
        "must be match if wheelset/free is [], because no load is read then"}});
}

TEST(Parameters, EveryParameterRefusesAWrongTypeAndEveryNumberANonFiniteValue)
{
  const auto expect_refused = [](const std::string& name, const YAML::Node& value)
  {
    const std::string message = refusal(validExcept(name, value));
    EXPECT_TRUE(contains(message, "/contact_node/" + name)) << name << " = " << value << ": " << message;
    EXPECT_TRUE(!value.IsScalar() || value.Scalar() == "1" || contains(message, value.Scalar())) << message;
  };
  for (const std::string& name : parameterNames())
  {
    expect_refused(name, YAML::Load("[[1, 2]]"));
    expect_refused(name + "s", YAML::Load("1"));
    for (const char* invalid : {".nan", "nan", ".inf", "-.inf", "1e999", "one", "true"})
    {
      if (isNumber(name))
      {
        expect_refused(name, YAML::Node(invalid));
      }
    }
  }
}

TEST(Parameters, EveryNumberExceptForcesRefusesMinusOne)
{
  // An error in one of the two numbers of the grid is reported with the name of the first one.
  const std::set<std::string> exceptions{"rail_bending/lateral_force", "contact/grid/across"};
  for (const std::string& name : parameterNames())
  {
    if (isNumber(name) && exceptions.count(name) == 0)
    {
      const std::string message = refusal(validExcept(name, YAML::Node("-1")));
      EXPECT_TRUE(contains(message, "/contact_node/" + name)) << name << ": " << message;
    }
  }
}

TEST(Parameters, MissingRequiredValueIsRefused)
{
  const std::string prescribed =
      "{rail_bending: {model: prescribed, prescribed: {lateral: 0.001, roll: 0}}, "
      "wheel: {profile: S1002}, rail: {profile: 60E1}}";
  EXPECT_TRUE(contains(refusal(parameterTree(YAML::Load(prescribed))), "rail_bending/prescribed/vertical is missing"));
  EXPECT_TRUE(contains(refusal(parameterTree(YAML::Load("rail: {profile: 60E1}"))), "wheel/profile is missing"));
  EXPECT_TRUE(contains(refusal({}), "wheel/profile is missing"));
}

TEST(Parameters, OverlayReplacesOnlyTheGivenValues)
{
  const NodeConfig config = read(with("{track: {rail_inclination: 0.05}, wheelset: {free: []}, sync: {slop: 0.004}}"));
  EXPECT_EQ(config.model.track.rail_inclination.left, 0.05);
  EXPECT_EQ(config.model.track.gauge, core::TrackConfig().gauge);
  EXPECT_FALSE(config.model.wheelset.solve_height_and_roll);
  EXPECT_EQ(config.slop, 0.004);
}

TEST(Parameters, LateralForceIsAWordOrANumber)
{
  using LateralForce = core::RailBendingConfig::LateralForce;
  EXPECT_EQ(read(with("rail_bending: {lateral_force: topic}")).model.rail_bending.lateral_force, LateralForce::topic);
  const core::RailBendingConfig bending = read(with("rail_bending: {lateral_force: 30e3}")).model.rail_bending;
  EXPECT_EQ(bending.lateral_force, LateralForce::constant);
  EXPECT_EQ(bending.lateral_force_value, 30000);
}

TEST(Parameters, DisplacementAndDistanceMayBeTopics)
{
  const NodeConfig neither = read(with("track: {displacement: none, distance: pose}"));
  EXPECT_FALSE(neither.displacement_topic || neither.distance_topic);
  EXPECT_TRUE(read(with("track: {displacement: topic}")).displacement_topic);
  EXPECT_FALSE(read(with("track: {displacement: topic}")).distance_topic);
  EXPECT_TRUE(read(with("track: {distance: topic}")).distance_topic);
}

TEST(Parameters, NeighboursHaveTheCompliancesOfTheTableAtTheirDistance)
{
  EXPECT_TRUE(read(defaults()).neighbours.empty());
  const NodeConfig config = read(
      with("rail_bending: {model: compliance, table: config/rails/pads_10_25.yaml, "
           "neighbours: [{topic: /front/contact_node/contact, distance: 2.5}, {topic: rear/contact, distance: 1.8}]}"));
  ASSERT_EQ(config.neighbours.size(), 2U);
  EXPECT_EQ(config.neighbours[0].topic, "/front/contact_node/contact");
  EXPECT_EQ(config.neighbours[0].distance, 2.5);
  EXPECT_EQ(config.neighbours[0].influence.left.lateral_lateral, 2.1963e-8);  // value in the table
  EXPECT_EQ(config.neighbours[1].influence.left.roll_roll, 1.5081e-6);
}

TEST(Parameters, TableIsFoundByPackageByDirectoryAndInThisPackage)
{
  std::ifstream source(packageFile("config/rails/pads_40_100.yaml"));
  std::ofstream(testing::TempDir() + "own_table.yaml") << source.rdbuf();
  for (const char* name : {"package://wheel_rail_contact/config/rails/pads_40_100.yaml", "own_table.yaml",
                           "config/rails/pads_40_100.yaml"})
  {
    const NodeConfig config = read(with(std::string("rail_bending: {model: compliance, table: '") + name + "'}"));
    EXPECT_GT(config.model.rail_bending.table.left.lateral_lateral, 0) << name;
    EXPECT_EQ(config.linear_range.left, 0.6) << name;
  }
}

TEST(Parameters, InterpolationRequiresALoad)
{
  EXPECT_FALSE(read(with("{sync: {load: match}, wheelset: {free: []}}")).interpolate_load);
  EXPECT_TRUE(read(with("{sync: {load: interpolate}, wheelset: {free: [z, roll]}}")).interpolate_load);
}
