// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/parameters.h"

#include <ros/names.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ros/parameters/compliance_table_file.h"
#include "ros/parameters/file_names.h"
#include "ros/parameters/parameter_reader.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact
{
namespace
{
const NumberRule seconds{"a number of seconds from 0 to 60", [](double v) { return v >= 0 && v <= 60; }};

/// Names of files and shipped profiles. They are opened after all other values have been checked.
struct FileNames
{
  std::string wheel_profile, rail_profile, table;
};

/// Reads the rail inclination [rad], given as an angle in radians or as a ratio such as 1:40, which is atan(1/40).
///
/// YAML 1.1 parsers (rosparam, roslaunch) read an unquoted 1:N, with N below 60, as the sexagesimal number 60 + N. No
/// valid angle is in this range. A number between 60 and 120 is therefore read as the ratio 1:N.
void readInclination(ParameterReader& reader, double& inclination)
{
  constexpr double sexagesimal = 60;
  constexpr const char* rule = "a finite number [rad] or a ratio 1:N with a finite N > 0";
  const std::string name = "track/rail_inclination";
  if (reader.has("track/cant"))
  {
    reader.refuse("track/cant", "renamed to track/rail_inclination (cant is the superelevation of the track)");
  }
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
  readInclination(reader, track.rail_inclination);
  reader.read("track/frame", config.track_frame);
  if (config.track_frame.empty() || config.track_frame[0] == '/')
  {
    reader.refuse("track/frame", "the name of a tf frame, without a leading slash");
  }
}

void readWheelset(ParameterReader& reader, core::WheelsetConfig& wheelset)
{
  reader.read("wheelset/rolling_radius", rules::finite, wheelset.rolling_radius);
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

void readRailBending(ParameterReader& reader, core::RailBendingConfig& bending, FileNames& files)
{
  using Model = core::RailBendingConfig::Model;
  reader.read("rail_bending/model",
              {{"none", Model::none}, {"prescribed", Model::prescribed}, {"compliance", Model::compliance}},
              bending.model);
  reader.read("rail_bending/table", files.table);
  if (bending.model == Model::compliance && files.table.empty())
  {
    reader.refuse("rail_bending/table", "a file with a compliance table when rail_bending/model is compliance");
  }
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
void readAll(ParameterReader& reader, NodeConfig& config, FileNames& files)
{
  readTrack(reader, config);
  readWheelset(reader, config.model.wheelset);
  reader.read("wheel/profile", files.wheel_profile);
  reader.read("rail/profile", files.rail_profile);
  readMaterial(reader, "material/wheel", config.model.wheel_material);
  readMaterial(reader, "material/rail", config.model.rail_material);
  readRailBending(reader, config.model.rail_bending, files);
  readNeighbours(reader, config);
  readContact(reader, config.model.contact);
  reader.read("sync/slop", seconds, config.slop);
  readMarkers(reader, config.markers);
}

/// Opens the file of the parameter `name`.
/// @param open function that opens the file `value`
/// @throw std::invalid_argument with the name of the parameter and the reason if `open` throws.
template <typename Open>
auto openFile(const std::string& name, const std::string& value, const Open& open)
{
  try
  {
    return open(value);
  }
  catch (const std::exception& error)
  {
    const std::string reason = error.what();
    const bool names_file = reason.compare(0, value.size() + 1, value + ":") == 0;
    throw std::invalid_argument(name + " = " + (names_file ? "" : value + ": ") + reason);
  }
}

/// ROS reads the name 60E1 as the number 60e1 in `_rail/profile:=60E1` on a command line, and in a <param> without a
/// type in a launch file.
const std::string rail_60e1_as_number = "600";

/// Opens a shipped profile, or a file if the value contains a dot or a slash.
std::shared_ptr<const core::Profile> openProfile(const std::string& value, core::ProfileKind kind,
                                                 const std::string& directory)
{
  if (value == rail_60e1_as_number)
  {
    return std::make_shared<core::Profile>(core::loadProfile("60E1", kind));
  }
  const bool is_file = value.find_first_of("./") != std::string::npos;
  return std::make_shared<core::Profile>(core::loadProfile(is_file ? resolveFile(value, directory) : value, kind));
}

/// Opens the files and checks the ranges of the core's options.
void complete(const FileNames& files, const std::string& directory, NodeConfig& config)
{
  core::ContactModelConfig& model = config.model;
  model.wheel_profile =
      openFile("wheel/profile", files.wheel_profile,
               [&](const std::string& value) { return openProfile(value, core::ProfileKind::wheel, directory); });
  model.rail_profile =
      openFile("rail/profile", files.rail_profile,
               [&](const std::string& value) { return openProfile(value, core::ProfileKind::rail, directory); });
  if (model.rail_bending.model == core::RailBendingConfig::Model::compliance)
  {
    const ComplianceTableFile file =
        openFile("rail_bending/table", files.table,
                 [&](const std::string& value) { return readComplianceTable(resolveFile(value, directory)); });
    model.rail_bending.table = file.table;
    config.linear_range = file.linear_range;
    for (NeighbourConfig& neighbour : config.neighbours)
    {
      neighbour.influence = influenceAt(file.neighbours, neighbour.distance);
    }
  }
  validate(model);
}
}  // namespace

NodeConfig readNodeConfig(const ParameterTree& tree, const std::string& prefix, const std::string& directory)
{
  ParameterReader reader(tree, prefix);
  NodeConfig config;
  FileNames files;
  readAll(reader, config, files);
  reader.refuseUnknown();
  reader.require("wheel/profile", "give the name of a profile or a file");
  reader.require("rail/profile", "give the name of a profile or a file");
  try
  {
    complete(files, directory, config);
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
  FileNames files;
  readAll(reader, config, files);
  return reader.knownNames();
}
}  // namespace wheel_rail_contact
