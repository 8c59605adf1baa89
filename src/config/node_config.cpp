// SPDX-License-Identifier: BSD-3-Clause
#include "config/node_config.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "config/body_parameters.h"
#include "config/model_files.h"
#include "config/parameter_reader.h"
#include "config/wheelset_list.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double longest_time = 60;  ///< of sync/slop and sync/longest_gap [s]
constexpr std::size_t longest_frame = 1000;
const NumberRule slop_rule{"a number of seconds from 0 to 60", [](double v) { return v >= 0 && v <= longest_time; }};
const NumberRule gap_rule{"a number of seconds above 0, at most 60",
                          [](double v) { return v > 0 && v <= longest_time; }};
const NumberRule hold_rule{"a whole number from 0 to 200",
                           [](double v) { return v >= 0 && v <= longest_hold && v == std::floor(v); }};

void readLine(ParameterReader& reader, ModelFiles& files)
{
  using core::LineAxes;
  const std::string name = "track/line", file = name + "/file", axes = name + "/axes", gap = name + "/longest_gap",
                    repeat = name + "/repeat";
  reader.read(gap, rules::positive, files.line_reading.longest_gap);
  reader.read(repeat, {{"false", false}, {"true", true}}, files.line_reading.repeat);
  const bool has_options = reader.has(axes) || reader.has(gap) || reader.has(repeat);
  reader.refuseIf(reader.has(name) && (reader.has(file) || has_options), name,
                  "either a file or a group with file, axes, longest_gap and repeat");
  if (has_options)
  {
    reader.require(file, "the file with these options");
  }
  files.line.parameter = reader.has(file) ? file : name;
  reader.read(name, files.line.value);
  reader.read(file, files.line.value);
  reader.read(axes, {{"rep103", LineAxes::rep103}, {"railway", LineAxes::railway}}, files.line_reading.axes);
}

bool isFrame(const std::string& name)
{
  return !name.empty() && name[0] != '/' && name.size() <= longest_frame;
}

void readTrack(ParameterReader& reader, NodeConfig& config, ModelFiles& files)
{
  core::TrackConfig& track = config.model.track;
  reader.read("track/gauge", rules::finite, track.gauge);
  reader.read("track/gauge_depth", rules::finite, track.gauge_depth);
  reader.read("track/frame", config.track_frame);
  reader.refuseIf(!isFrame(config.track_frame), "track/frame",
                  "the name of a tf frame, without a leading slash, of at most 1000 bytes");
  readLine(reader, files);
  const std::string publish = "track/publish_track_frame";
  reader.read(publish, config.fixed_frame);
  reader.refuseIf(
      !config.fixed_frame.empty() && (!isFrame(config.fixed_frame) || files.line.value.empty() ||
                                      files.line_reading.repeat || config.fixed_frame == config.track_frame),
      publish, "the name of a fixed tf frame other than track/frame, and only with a track/line that does not repeat");
  reader.read("track/displacement", {{"none", false}, {"topic", true}}, config.displacement_topic);
  reader.read("track/distance", {{"pose", false}, {"topic", true}}, config.distance_topic);
}

void readPublished(ParameterReader& reader, NodeConfig& config)
{
  const std::string frame = "wheelset/frame";
  reader.read(frame, config.wheelset_frame);
  reader.refuseIf(!config.wheelset_frame.empty() &&
                      (!isFrame(config.wheelset_frame) || config.wheelset_frame == config.track_frame ||
                       config.wheelset_frame == config.fixed_frame),
                  frame, "the name of a tf frame of its own, without a leading slash, of at most 1000 bytes");
  reader.read("wheelset/publish_tf", {{"false", false}, {"true", true}}, config.publish_tf);
  reader.read("wheelset/publish_wrenches", {{"false", false}, {"true", true}}, config.publish_wrenches);
}

void readWheelset(ParameterReader& reader, core::WheelsetConfig& wheelset)
{
  reader.read("wheelset/flange_back_distance", rules::finite, wheelset.flange_back_distance);
  reader.read("wheelset/tape_circle", rules::finite, wheelset.tape_circle);
  std::vector<std::string> free =
      wheelset.solve_height_and_roll ? std::vector<std::string>{"z", "roll"} : std::vector<std::string>{};
  reader.read("wheelset/free", free);
  std::sort(free.begin(), free.end());
  wheelset.solve_height_and_roll = !free.empty();
  reader.refuseIf(!free.empty() && free != std::vector<std::string>{"roll", "z"}, "wheelset/free", "[z, roll] or []");
  using Balance = core::WheelsetConfig::Balance;
  reader.read("wheelset/balance", {{"wheel_loads", Balance::wheel_loads}, {"moments", Balance::moments}},
              wheelset.balance);
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
  reader.refuseIf(word != "contact" && word != "topic", name, "contact, topic or a finite number [N]");
  bending.lateral_force = word == "contact" ? LateralForce::contact : LateralForce::topic;
}

NeighbourConfig readNeighbour(ParameterReader& reader)
{
  NeighbourConfig neighbour;
  reader.read("topic", neighbour.topic);
  reader.read("distance", rules::positive, neighbour.distance);
  reader.refuseUnknown();
  reader.require("topic", "the contact topic of the other wheelset");
  reader.require("distance", "the distance to the other wheelset along the track [m]");
  reader.refuseIf(!isTopic(neighbour.topic), "topic", "the name of a topic that is not private");
  return neighbour;
}

void readNeighbours(ParameterReader& reader, NodeConfig& config)
{
  const std::string name = "rail_bending/neighbours";
  std::set<std::string> topics;
  for (ParameterReader& group : reader.readGroups(name))
  {
    config.neighbours.push_back(readNeighbour(group));
    group.refuseIf(!topics.insert(config.neighbours.back().topic).second, "topic", "given only once");
  }
  reader.refuseIf(
      !config.neighbours.empty() && config.model.rail_bending.model != core::RailBendingConfig::Model::compliance, name,
      "[] unless rail_bending/model is compliance");
}

void readRailBending(ParameterReader& reader, core::RailBendingConfig& bending, ModelFiles& files)
{
  using Model = core::RailBendingConfig::Model;
  reader.read("rail_bending/model",
              {{"none", Model::none}, {"prescribed", Model::prescribed}, {"compliance", Model::compliance}},
              bending.model);
  reader.refuseIf(
      bending.model == Model::compliance && (files.table.left.value.empty() || files.table.right.value.empty()),
      "rail_bending/table", "a file with a compliance table when rail_bending/model is compliance");
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

/// Methods by their names.
template <typename Methods>
auto choices(const Methods& methods)
{
  std::vector<std::pair<std::string, typename Methods::value_type>> named;
  named.reserve(methods.size());
  for (const auto method : methods)
  {
    named.emplace_back(toString(method), method);
  }
  return named;
}

void readFriction(ParameterReader& reader, const std::string& group, core::FrictionLaw& law)
{
  reader.read(group + "friction", rules::finite, law.coefficient);
  reader.read(group + "slip_share", rules::finite, law.slip_share);
  reader.read(group + "slip_decay", rules::finite, law.slip_decay);
}

void readCreep(ParameterReader& reader, core::CreepConfig& creep)
{
  using core::CreepMethod;
  using Rotation = core::CreepConfig::Rotation;
  reader.read("creep/method", choices(core::all_creep_methods), creep.method);
  readFriction(reader, "creep/", creep.friction.left);
  creep.friction.right = creep.friction.left;
  for (const core::Side side : core::sides)
  {
    readFriction(reader, std::string("creep/") + nameOf(side) + "/", creep.friction[side]);
  }
  reader.read("creep/rotation", {{"free", Rotation::free}, {"topic", Rotation::given}}, creep.rotation);
  reader.read("creep/field", {{"false", false}, {"true", true}}, creep.field);
  reader.refuseIf(creep.field && creep.method != CreepMethod::exact, "creep/field",
                  "false unless creep/method is exact");
}

void readContact(ParameterReader& reader, core::ContactConfig& contact)
{
  reader.read("contact/method", choices(core::all_normal_methods), contact.method);
  reader.read("contact/tolerance", rules::finite, contact.tolerance);
  reader.read("contact/grid/along", rules::whole, contact.cells_along);
  reader.read("contact/grid/across", rules::whole, contact.cells_across);
  reader.read("contact/check_branches", {{"false", false}, {"true", true}}, contact.check_branches);
  reader.read("contact/derivatives", {{"false", false}, {"true", true}}, contact.derivatives);
}

void readStress(ParameterReader& reader, core::StressConfig& stress)
{
  reader.read("stress/depths", rules::whole, stress.depths);
  reader.read("stress/field", {{"false", false}, {"true", true}}, stress.field);
}

void readSync(ParameterReader& reader, NodeConfig& config)
{
  reader.read("sync/slop", slop_rule, config.slop);
  reader.read("sync/load", {{"match", false}, {"interpolate", true}}, config.interpolate_load);
  reader.refuseIf(config.interpolate_load && !config.model.wheelset.solve_height_and_roll, "sync/load",
                  "match if wheelset/free is [], because no load is read then");
  reader.read("sync/longest_gap", gap_rule, config.longest_gap);
}

void readMarkers(ParameterReader& reader, MarkerConfig& markers)
{
  reader.read("markers/rate", rules::positive, markers.rate);
  reader.read("markers/rail_length", rules::positive, markers.rail_length);
  reader.read("markers/force_scale", rules::not_negative, markers.force_scale);
  reader.read("markers/max_pressure", rules::not_negative, markers.max_pressure);
  reader.read("markers/zoom", rules::not_negative, markers.zoom);
  reader.read("markers/zoom_height", rules::not_negative, markers.zoom_height);
  reader.read("markers/pressure_height", rules::not_negative, markers.pressure_height);
}

/// Reads all parameters; the names that are not read here are unknown.
void readAll(ParameterReader& reader, NodeConfig& config, ModelFiles& files)
{
  reader.refuseIf(!readWheelsetList(reader).names.empty(), wheelset_list::names,
                  "[] for a single wheelset: a node with several splits the parameters before");
  readTrack(reader, config, files);
  readWheelset(reader, config.model.wheelset);
  readPublished(reader, config);
  readWheels(reader, config.model, files);
  readRails(reader, config.model, files);
  readRailBending(reader, config.model.rail_bending, files);
  readNeighbours(reader, config);
  readContact(reader, config.model.contact);
  readStress(reader, config.model.stress);
  readCreep(reader, config.model.creep);
  reader.read("contact/hold_last", hold_rule, config.hold_last);
  readSync(reader, config);
  readMarkers(reader, config.markers);
  reader.read("diagnostics/min_rate", rules::not_negative, config.min_rate);
  reader.read("diagnostics/max_delay", rules::not_negative, config.max_delay);
}
}  // namespace

NodeConfig readNodeConfig(const ParameterTree& tree, const std::string& prefix, const FileSearch& search)
{
  ParameterReader reader(tree, prefix);
  NodeConfig config;
  ModelFiles files;
  readAll(reader, config, files);
  reader.refuseUnknown();
  requireProfiles(reader, files);
  try
  {
    openFiles(files, search, config);
    validate(config.model);
    const std::vector<std::string> remarks = checkFit(config.model);
    config.warnings.insert(config.warnings.end(), remarks.begin(), remarks.end());
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument("parameter " + prefix + error.what());
  }
  return config;
}
}  // namespace wheel_rail_contact
