// SPDX-License-Identifier: BSD-3-Clause
#include "scene_file.h"

#include "config/node_config.h"
#include "config/parameter_reader.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
/// Moves the parameters whose name begins with `prefix` from one tree to another.
void move(const std::string& prefix, ParameterTree& from, ParameterTree& to)
{
  auto entry = from.lower_bound(prefix);
  while (entry != from.end() && entry->first.rfind(prefix, 0) == 0)
  {
    to.insert(*entry);
    entry = from.erase(entry);
  }
}

SceneProfile readProfileOf(const std::string& body, ProfileKind kind, ParameterReader& reader,
                           const std::string& folder)
{
  reader.require(body + "/profile", "standard profile or file");
  std::string name;
  std::optional<double> noise;
  reader.read(body + "/profile", name);
  if (reader.has(body + "/noise"))
  {
    noise = 0;
    reader.read(body + "/noise", rules::not_negative, *noise);
  }
  return loadSceneProfile(name, kind, noise, folder);
}

void readTable(ParameterReader& reader, Scene& scene)
{
  const std::string group = "rail_bending/table/";
  ComplianceTable table;
  const auto read = [&](const std::string& name, const NumberRule& rule, double& value)
  {
    reader.require(group + name, "model compliance requires all numbers of the table");
    reader.read(group + name, rule, value);
  };
  reader.read(group + "name", scene.table_name);
  read("lateral_lateral", rules::positive, table.lateral_lateral);
  read("lateral_roll", rules::finite, table.lateral_roll);
  read("roll_roll", rules::positive, table.roll_roll);
  read("vertical_vertical", rules::positive, table.vertical_vertical);
  scene.config.rail_bending.table = table;
}

WheelsetState readState(ParameterReader& reader)
{
  WheelsetState state;
  reader.read("y", rules::finite, state.y);
  reader.read("z", rules::finite, state.z);
  reader.read("yaw", rules::finite, state.yaw);
  reader.read("roll", rules::finite, state.roll);
  reader.read("force_z", rules::finite, state.force_z);
  reader.read("torque_x", rules::finite, state.torque_x);
  for (const Side side : sides)
  {
    const std::string name = nameOf(side);
    reader.read("rail_lateral_force/" + name, rules::finite, state.rail_lateral_force[side]);
    reader.read("rail_displacement/" + name + "/lateral", rules::finite, state.rail_displacement[side].lateral);
    reader.read("rail_displacement/" + name + "/vertical", rules::finite, state.rail_displacement[side].vertical);
    reader.read("rail_displacement/" + name + "/roll", rules::finite, state.rail_displacement[side].roll);
  }
  reader.refuseUnknown();
  return state;
}

/// The shortest text from which the same number is read.
std::string shortest(double value)
{
  char text[40];
  for (int digits = 1; digits <= 17; ++digits)
  {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value)
    {
      break;
    }
  }
  return text;
}

std::string quoted(const std::string& text)
{
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

std::string inFlow(const RailDeflection& d)
{
  return "{lateral: " + shortest(d.lateral) + ", vertical: " + shortest(d.vertical) + ", roll: " + shortest(d.roll) +
         "}";
}

void write(std::ostream& out, const char* body, const SceneProfile& profile)
{
  out << body << ":\n  profile: " << profile.name << '\n';
  if (profile.noise)
  {
    out << "  noise: " << shortest(*profile.noise) << '\n';
  }
}

std::string inFlow(const Material& material)
{
  return "{young: " + shortest(material.young) + ", poisson: " + shortest(material.poisson) + "}\n";
}

void write(std::ostream& out, const RailBendingConfig& bending, const std::string& table_name)
{
  using Model = RailBendingConfig::Model;
  using LateralForce = RailBendingConfig::LateralForce;
  out << "rail_bending:\n  model: "
      << (bending.model == Model::none         ? "none"
          : bending.model == Model::prescribed ? "prescribed"
                                               : "compliance")
      << '\n';
  if (bending.model == Model::prescribed)
  {
    out << "  prescribed: " << inFlow(bending.prescribed) << '\n';
  }
  if (bending.model == Model::compliance)
  {
    const ComplianceTable& table = bending.table.left;
    out << "  table:\n    name: " << table_name << "\n    lateral_lateral: " << shortest(table.lateral_lateral)
        << "\n    lateral_roll: " << shortest(table.lateral_roll) << "\n    roll_roll: " << shortest(table.roll_roll)
        << "\n    vertical_vertical: " << shortest(table.vertical_vertical) << "\n  lateral_force: "
        << (bending.lateral_force == LateralForce::contact ? "contact"
            : bending.lateral_force == LateralForce::topic ? "topic"
                                                           : shortest(bending.lateral_force_value))
        << '\n';
  }
}

void write(std::ostream& out, const WheelsetState& state)
{
  out << "  - {y: " << shortest(state.y) << ", z: " << shortest(state.z) << ", yaw: " << shortest(state.yaw)
      << ", roll: " << shortest(state.roll) << ",\n     force_z: " << shortest(state.force_z)
      << ", torque_x: " << shortest(state.torque_x)
      << ",\n     rail_lateral_force: {left: " << shortest(state.rail_lateral_force.left)
      << ", right: " << shortest(state.rail_lateral_force.right) << '}';
  const auto is_zero = [](const RailDeflection& d) { return d.lateral == 0 && d.vertical == 0 && d.roll == 0; };
  if (!is_zero(state.rail_displacement.left) || !is_zero(state.rail_displacement.right))
  {
    out << ",\n     rail_displacement: {left: " << inFlow(state.rail_displacement.left)
        << ", right: " << inFlow(state.rail_displacement.right) << '}';
  }
  out << "}\n";
}
}  // namespace

Scene readScene(const std::string& file)
{
  const std::string prefix = file + ": ", folder = std::filesystem::path(file).parent_path();
  ParameterTree parameters = readParameterFile(file), own;
  for (const char* name : {"description", "states", "wheel/", "rail/", "rail_bending/model", "rail_bending/table/"})
  {
    move(name, parameters, own);
  }
  // readNodeConfig() requires profiles; these are replaced below.
  parameters["wheel/profile"] = YAML::Node("S1002");
  parameters["rail/profile"] = YAML::Node("60E1");
  Scene scene;
  scene.config = readNodeConfig(parameters, prefix, {folder, nullptr}).model;

  using Model = RailBendingConfig::Model;
  ParameterReader reader(own, prefix);
  reader.read("description", scene.description);
  scene.wheel = readProfileOf("wheel", ProfileKind::wheel, reader, folder);
  scene.rail = readProfileOf("rail", ProfileKind::rail, reader, folder);
  scene.config.wheel_profile = scene.wheel.profile;
  scene.config.rail_profile = scene.rail.profile;
  reader.read("rail_bending/model",
              {{"none", Model::none}, {"prescribed", Model::prescribed}, {"compliance", Model::compliance}},
              scene.config.rail_bending.model);
  if (scene.config.rail_bending.model == Model::compliance)
  {
    readTable(reader, scene);
  }
  reader.require("states", "a list of at least one state");
  for (ParameterReader& state : reader.readGroups("states"))
  {
    scene.states.push_back(readState(state));
  }
  if (scene.states.empty())
  {
    reader.refuse("states", "a list of at least one state");
  }
  reader.refuseUnknown();
  return scene;
}

void writeScene(std::ostream& out, const Scene& scene)
{
  const ContactModelConfig& config = scene.config;
  out << "# Regression scene: parameters as in config/default.yaml, and a sequence of states. SI units and radians.\n"
         "# test/stability/scene_file.h describes the format.\n"
         "description: "
      << quoted(scene.description) << "\ntrack:\n  gauge: " << shortest(config.track.gauge)
      << "\n  gauge_depth: " << shortest(config.track.gauge_depth)
      << "\n  rail_inclination: " << shortest(config.track.rail_inclination.left)
      << "\nwheelset:\n  rolling_radius: " << shortest(config.wheelset.rolling_radius.left)
      << "\n  flange_back_distance: " << shortest(config.wheelset.flange_back_distance)
      << "\n  tape_circle: " << shortest(config.wheelset.tape_circle)
      << "\n  free: " << (config.wheelset.solve_height_and_roll ? "[z, roll]" : "[]") << '\n';
  write(out, "wheel", scene.wheel);
  write(out, "rail", scene.rail);
  out << "material:\n  wheel: " << inFlow(config.wheel_material.left)
      << "  rail: " << inFlow(config.rail_material.left);
  write(out, config.rail_bending, scene.table_name);
  out << "contact:\n  method: " << toString(config.contact.method)
      << "\n  tolerance: " << shortest(config.contact.tolerance) << "\n  grid: {along: " << config.contact.cells_along
      << ", across: " << config.contact.cells_across << "}\nstates:\n";
  for (const WheelsetState& state : scene.states)
  {
    write(out, state);
  }
}
}  // namespace wheel_rail_contact::core::stability
