// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/parameters.h"

#include <ros/names.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ros/parameters/model_files.h"
#include "ros/parameters/parameter_reader.h"

namespace wheel_rail_contact
{
namespace
{
const NumberRule seconds{"a number of seconds from 0 to 60", [](double v) { return v >= 0 && v <= 60; }};

/// Prefix of the parameters of one side: "rail/left/".
std::string sideGroup(const std::string& body, core::Side side)
{
  return body + (side == core::Side::left ? "/left/" : "/right/");
}

/// Reads the rail inclination [rad], given as an angle in radians or as a ratio such as 1:40, which is atan(1/40).
///
/// YAML 1.1 parsers (rosparam, roslaunch) read an unquoted 1:N, with N below 60, as the sexagesimal number 60 + N. No
/// valid angle is in this range. A number between 60 and 120 is therefore read as the ratio 1:N.
void readInclination(ParameterReader& reader, const std::string& name, double& inclination)
{
  constexpr double sexagesimal = 60;
  constexpr const char* rule = "a finite number [rad] or a ratio 1:N with a finite N > 0";
  double denominator = 0;
  if (reader.readRatio(name, {rule, rules::positive.holds}, denominator))
  {
    inclination = std::atan(1 / denominator);
    return;
  }
  reader.read(name, {rule, rules::finite.holds}, inclination);
  if (inclination > sexagesimal && inclination < 2 * sexagesimal)
  {
    inclination = std::atan(1 / (inclination - sexagesimal));
  }
}

void readTrack(ParameterReader& reader, NodeConfig& config)
{
  core::TrackConfig& track = config.model.track;
  reader.read("track/gauge", rules::finite, track.gauge);
  reader.read("track/gauge_depth", rules::finite, track.gauge_depth);
  if (reader.has("track/cant"))
  {
    reader.refuse("track/cant", "renamed to track/rail_inclination (cant is the superelevation of the track)");
  }
  readInclination(reader, "track/rail_inclination", track.rail_inclination.left);
  track.rail_inclination.right = track.rail_inclination.left;
  for (const core::Side side : core::sides)
  {
    readInclination(reader, sideGroup("rail", side) + "inclination", track.rail_inclination[side]);
  }
  reader.read("track/frame", config.track_frame);
  if (config.track_frame.empty() || config.track_frame[0] == '/')
  {
    reader.refuse("track/frame", "the name of a tf frame, without a leading slash");
  }
}

void readWheelset(ParameterReader& reader, core::WheelsetConfig& wheelset)
{
  reader.read("wheelset/rolling_radius", rules::finite, wheelset.rolling_radius.left);
  wheelset.rolling_radius.right = wheelset.rolling_radius.left;
  for (const core::Side side : core::sides)
  {
    reader.read(sideGroup("wheel", side) + "rolling_radius", rules::finite, wheelset.rolling_radius[side]);
  }
  reader.read("wheelset/flange_back_distance", rules::finite, wheelset.flange_back_distance);
  reader.read("wheelset/tape_circle", rules::finite, wheelset.tape_circle);
  std::vector<std::string> free =
      wheelset.solve_height_and_roll ? std::vector<std::string>{"z", "roll"} : std::vector<std::string>{};
  reader.read("wheelset/free", free);
  std::sort(free.begin(), free.end());
  wheelset.solve_height_and_roll = !free.empty();
  if (!free.empty() && free != std::vector<std::string>{"roll", "z"})
  {
    reader.refuse("wheelset/free", "[z, roll] or []");
  }
}

void readMaterial(ParameterReader& reader, const std::string& group, core::Material& material)
{
  reader.read(group + "/young", rules::finite, material.young);
  reader.read(group + "/poisson", rules::finite, material.poisson);
}

/// Materials of a body ("wheel" or "rail") on both sides.
void readMaterials(ParameterReader& reader, const std::string& body, core::Sides<core::Material>& materials)
{
  readMaterial(reader, "material/" + body, materials.left);
  materials.right = materials.left;
  for (const core::Side side : core::sides)
  {
    readMaterial(reader, sideGroup(body, side) + "material", materials[side]);
  }
}

/// Reads a profile: its name or file, or a group with `file` and `mirror`. Unchanged if it is not given.
void readProfile(ParameterReader& reader, const std::string& name, NamedFile& profile)
{
  const std::string file = name + "/file", mirror = name + "/mirror";
  if (reader.has(name) && (reader.has(file) || reader.has(mirror)))
  {
    reader.refuse(name, "either a name or a group with file and mirror");
  }
  if (reader.has(mirror))
  {
    reader.require(file, "the file to be mirrored");
  }
  if (reader.has(name) || reader.has(file))
  {
    profile = NamedFile{reader.has(file) ? file : name, "", false};
  }
  reader.read(name, profile.value);
  reader.read(file, profile.value);
  reader.read(mirror, {{"false", false}, {"true", true}}, profile.mirror);
}

/// Profiles of a body ("wheel" or "rail") on both sides.
void readProfiles(ParameterReader& reader, const std::string& body, core::Sides<NamedFile>& profiles)
{
  readProfile(reader, body + "/profile", profiles.left);
  profiles.right = profiles.left;
  for (const core::Side side : core::sides)
  {
    readProfile(reader, sideGroup(body, side) + "profile", profiles[side]);
  }
}

void readTables(ParameterReader& reader, bool required, core::Sides<NamedFile>& tables)
{
  tables = NamedFile{"rail_bending/table", "", false};
  reader.read("rail_bending/table", tables.left.value);
  tables.right = tables.left;
  for (const core::Side side : core::sides)
  {
    const std::string name = sideGroup("rail", side) + "table";
    if (reader.has(name))
    {
      tables[side].parameter = name;
    }
    reader.read(name, tables[side].value);
  }
  if (required && (tables.left.value.empty() || tables.right.value.empty()))
  {
    reader.refuse("rail_bending/table", "a file with a compliance table when rail_bending/model is compliance");
  }
}

void readLateralForce(ParameterReader& reader, core::RailBendingConfig& bending)
{
  using LateralForce = core::RailBendingConfig::LateralForce;
  const std::string name = "rail_bending/lateral_force";
  if (reader.isNumber(name))
  {
    reader.read(name, rules::finite, bending.lateral_force_value);
    bending.lateral_force = LateralForce::constant;
    return;
  }
  std::string word = bending.lateral_force == LateralForce::contact ? "contact" : "topic";
  reader.read(name, word);
  if (word != "contact" && word != "topic")
  {
    reader.refuse(name, "contact, topic or a finite number [N]");
  }
  bending.lateral_force = word == "contact" ? LateralForce::contact : LateralForce::topic;
}

NeighbourConfig readNeighbour(ParameterReader& reader)
{
  NeighbourConfig neighbour;
  reader.require("topic", "the contact topic of the other wheelset");
  reader.read("topic", neighbour.topic);
  std::string reason;
  if (neighbour.topic.empty() || neighbour.topic[0] == '~' || !ros::names::validate(neighbour.topic, reason))
  {
    reader.refuse("topic", "the name of a topic that is not private");
  }
  reader.require("distance", "the distance to the other wheelset along the track [m]");
  reader.read("distance", rules::positive, neighbour.distance);
  reader.refuseUnknown();
  return neighbour;
}

void readNeighbours(ParameterReader& reader, NodeConfig& config)
{
  const std::string name = "rail_bending/neighbours";
  std::set<std::string> topics;
  for (ParameterReader& group : reader.readGroups(name))
  {
    config.neighbours.push_back(readNeighbour(group));
    if (!topics.insert(config.neighbours.back().topic).second)
    {
      group.refuse("topic", "given only once");
    }
  }
  if (!config.neighbours.empty() && config.model.rail_bending.model != core::RailBendingConfig::Model::compliance)
  {
    reader.refuse(name, "[] unless rail_bending/model is compliance");
  }
}

void readRailBending(ParameterReader& reader, core::RailBendingConfig& bending, ModelFiles& files)
{
  using Model = core::RailBendingConfig::Model;
  reader.read("rail_bending/model",
              {{"none", Model::none}, {"prescribed", Model::prescribed}, {"compliance", Model::compliance}},
              bending.model);
  readTables(reader, bending.model == Model::compliance, files.table);
  readLateralForce(reader, bending);
  reader.read("rail_bending/prescribed/lateral", rules::finite, bending.prescribed.lateral);
  reader.read("rail_bending/prescribed/vertical", rules::finite, bending.prescribed.vertical);
  reader.read("rail_bending/prescribed/roll", rules::finite, bending.prescribed.roll);
  if (bending.model == Model::prescribed)
  {
    for (const char* name : {"lateral", "vertical", "roll"})
    {
      reader.require(std::string("rail_bending/prescribed/") + name, "required if rail_bending/model is prescribed");
    }
  }
}

void readContact(ParameterReader& reader, core::ContactConfig& contact)
{
  std::vector<std::pair<std::string, core::NormalMethod>> methods;
  methods.reserve(core::all_normal_methods.size());
  for (const core::NormalMethod method : core::all_normal_methods)
  {
    methods.emplace_back(toString(method), method);
  }
  reader.read("contact/method", methods, contact.method);
  reader.read("contact/tolerance", rules::finite, contact.tolerance);
  reader.read("contact/grid/along", rules::whole, contact.cells_along);
  reader.read("contact/grid/across", rules::whole, contact.cells_across);
  reader.read("contact/check_branches", std::vector<std::pair<std::string, bool>>{{"false", false}, {"true", true}},
              contact.check_branches);
}

void readMarkers(ParameterReader& reader, MarkerConfig& markers)
{
  reader.read("markers/rate", rules::positive, markers.rate);
  reader.read("markers/rail_length", rules::positive, markers.rail_length);
  reader.read("markers/force_scale", rules::not_negative, markers.force_scale);
  reader.read("markers/max_pressure", rules::positive, markers.max_pressure);
  reader.read("markers/zoom", rules::not_negative, markers.zoom);
  reader.read("markers/zoom_height", rules::not_negative, markers.zoom_height);
  reader.read("markers/pressure_height", rules::not_negative, markers.pressure_height);
}

/// Reads all parameters; the names that are not read here are unknown.
void readAll(ParameterReader& reader, NodeConfig& config, ModelFiles& files)
{
  readTrack(reader, config);
  readWheelset(reader, config.model.wheelset);
  readProfiles(reader, "wheel", files.wheel_profile);
  readProfiles(reader, "rail", files.rail_profile);
  readMaterials(reader, "wheel", config.model.wheel_material);
  readMaterials(reader, "rail", config.model.rail_material);
  readRailBending(reader, config.model.rail_bending, files);
  readNeighbours(reader, config);
  readContact(reader, config.model.contact);
  reader.read("sync/slop", seconds, config.slop);
  readMarkers(reader, config.markers);
}

/// Requires a value for both sides.
void requireBoth(const ParameterReader& reader, const core::Sides<NamedFile>& files, const std::string& both,
                 const std::string& why)
{
  if (files.left.value.empty() || files.right.value.empty())
  {
    reader.require(both, why);
  }
}
}  // namespace

NodeConfig readNodeConfig(const ParameterTree& tree, const std::string& prefix, const std::string& directory)
{
  ParameterReader reader(tree, prefix);
  NodeConfig config;
  ModelFiles files;
  readAll(reader, config, files);
  reader.refuseUnknown();
  requireBoth(reader, files.wheel_profile, "wheel/profile", "give the name of a profile or a file");
  requireBoth(reader, files.rail_profile, "rail/profile", "give the name of a profile or a file");
  try
  {
    openFiles(files, directory, config);
    validate(config.model);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument("parameter " + prefix + error.what());
  }
  return config;
}

std::set<std::string> parameterNames()
{
  ParameterReader reader({}, "");
  NodeConfig config;
  ModelFiles files;
  readAll(reader, config, files);
  return reader.knownNames();
}
}  // namespace wheel_rail_contact
