// SPDX-License-Identifier: BSD-3-Clause
#include "config/body_parameters.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact
{
namespace
{
/// Prefix of the parameters of one side: "rail/left/".
std::string sideGroup(const std::string& body, core::Side side)
{
  return body + "/" + nameOf(side) + "/";
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

void readMaterial(ParameterReader& reader, const std::string& group, core::Material& material)
{
  reader.read(group + "/young", rules::finite, material.young);
  reader.read(group + "/poisson", rules::finite, material.poisson);
  reader.read(group + "/yield", rules::finite, material.yield);
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

/// Reads a file: its name, or a group with `file` and its options. Unchanged if it is not given.
void readProfile(ParameterReader& reader, const std::string& name, NamedFile& profile)
{
  const std::string prefix = name + "/", file = prefix + "file";
  const bool has_options = hasProfileOptions(reader, prefix);
  if (reader.has(name) || reader.has(file))
  {
    profile = NamedFile{reader.has(file) ? file : name, "", {}};
  }
  reader.refuseIf(reader.has(name) && (reader.has(file) || has_options), name, "either a name or a group");
  reader.read(name, profile.value);
  reader.read(file, profile.value);
  readProfileOptions(reader, prefix, profile.reading);
  if (has_options)
  {
    reader.require(file, "give the file to which the options apply");
  }
}

/// Reads how a wheel is not round: a file, or a group. @param radius  of the wheel [m]
void readOutOfRound(ParameterReader& reader, const std::string& name, double radius, NamedFile& table,
                    core::OutOfRound& wheel)
{
  constexpr double longest = 0.29;  // flat over the radius
  const std::string file = name + "/file", harmonics = name + "/harmonics", flats = name + "/flats";
  reader.refuseIf(reader.has(name) && (reader.has(file) || reader.has(harmonics) || reader.has(flats)), name,
                  "either a file or a group with file, harmonics and flats");
  table.parameter = reader.has(file) ? file : name;
  reader.read(name, table.value);
  reader.read(file, table.value);
  for (ParameterReader& group : reader.readGroups(harmonics))
  {
    core::OutOfRound::Harmonic& wave = wheel.harmonics.emplace_back();
    group.read("order", rules::whole, wave.order);
    group.read("amplitude", rules::finite, wave.amplitude);
    group.read("phase", rules::finite, wave.phase);
    group.refuseUnknown();
    group.require("order", "waves in the circumference");
    group.require("amplitude", "of the radius [m]");
  }
  for (ParameterReader& group : reader.readGroups(flats))
  {
    core::OutOfRound::Flat& flat = wheel.flats.emplace_back();
    double length = 0;
    group.read("angle", rules::finite, flat.angle);
    group.read("depth", rules::positive, flat.depth);
    group.read("length", rules::positive, length);
    group.refuseUnknown();
    group.require(group.has("length") ? "length" : "depth", "give depth or length [m]");
    group.refuseIf(group.has("depth") && group.has("length"), "length", "omitted beside depth");
    group.refuseIf(length > longest * radius, "length", "at most 0.29 rolling radii [m]");
    flat.depth += radius - std::sqrt(radius * radius - 0.25 * length * length);
  }
}

/// Reads a list of sections, each with its place and its file.
/// @param group_of_part  its name in messages, with "/"; empty for the running rail
void readSections(ParameterReader& reader, const std::string& group_of_part, const std::string& name,
                  RailPartFiles& part)
{
  for (ParameterReader& group : reader.readGroups(name))
  {
    RailSectionFile section{0, {group_of_part + name + "/file", "", part.reading}};
    group.read("x", rules::finite, section.x);
    group.read("file", section.file.value);
    group.refuseUnknown();
    group.require("x", "place of the section on the line [m]");
    group.require("file", "profile of the section");
    group.refuseIf(!part.sections.empty() && !(section.x > part.sections.back().x), "x",
                   "greater than that of the section before");
    part.sections.push_back(section);
  }
  reader.refuseIf(reader.has(name) && part.sections.empty(), name, "a list of at least one section");
}

/// Reads one part of a rail: `slices`, a list of `sections`, or one `file` that holds everywhere.
/// @param group   name of the group of the part in messages, with "/"; empty for the running rail
/// @param prefix  before the names: "" in a group of its own
RailPartFiles readPart(ParameterReader& reader, const std::string& group, const std::string& prefix)
{
  const std::string slices = prefix + "slices", sections = prefix + "sections", file = prefix + "file";
  RailPartFiles part;
  readProfileOptions(reader, prefix, part.reading);
  reader.refuseIf(part.reading.origin.has_value(), prefix + "origin",
                  "omitted: sections keep the origin of their files; shift moves them");
  part.slices = {group + slices, "", part.reading};
  reader.read(slices, part.slices.value);
  readSections(reader, group, sections, part);
  NamedFile only{group + file, "", part.reading};
  reader.read(file, only.value);
  if (prefix.empty())
  {
    reader.refuseUnknown();
  }
  const std::vector<std::string> names{slices, sections, file};
  const auto given = std::find_if(names.begin(), names.end(), [&](const auto& name) { return reader.has(name); });
  const auto other = std::find_if(names.rbegin(), names.rend(), [&](const auto& name) { return reader.has(name); });
  if (given == names.end())
  {
    reader.require(slices, "give slices, sections or file");
  }
  reader.refuseIf(*given != *other, *other, "omitted: of slices, sections and file, only one may be given");
  if (reader.has(file))
  {
    part.sections.push_back({0, only});
  }
  return part;
}

/// Reads a rail of several parts, or with a profile that changes along the line.
RailFiles readParts(ParameterReader& reader, const std::string& name)
{
  using Placement = core::RailSections::Placement;
  const std::string prefix = name + "/", parts = prefix + "parts";
  RailFiles rail;
  rail.parameter = name;
  rail.placement = reader.has(prefix + "slices") ? Placement::coordinates : Placement::gauge;
  reader.read(prefix + "placement", {{"gauge", Placement::gauge}, {"coordinates", Placement::coordinates}},
              rail.placement);
  std::vector<ParameterReader> further = reader.readGroups(parts);
  rail.parts.push_back(readPart(reader, "", prefix));
  for (ParameterReader& group : further)
  {
    rail.parts.push_back(readPart(group, parts + "/", ""));
  }
  return rail;
}

/// Reads the profile of a rail: as readProfile(), or a group with sections. Unchanged if it is not given.
void readRail(ParameterReader& reader, const std::string& name, RailFiles& rail)
{
  const std::string prefix = name + "/";
  const auto has = [&](const char* member) { return reader.has(prefix + member); };
  reader.refuseIf(reader.has(name) && (has("slices") || has("sections") || has("parts") || has("placement")), name,
                  "either a name or a group");
  if (has("slices") || has("sections") || has("parts"))
  {
    rail = readParts(reader, name);
    return;
  }
  for (const char* member : {"slices", "sections", "parts", "placement"})
  {
    reader.know(prefix + member);
  }
  reader.refuseIf(has("placement"), prefix + "placement", "given together with slices, sections or parts");
  if (reader.has(name) || has("file"))
  {
    rail = RailFiles{};
  }
  readProfile(reader, name, rail.profile);
}

void readTables(ParameterReader& reader, core::Sides<NamedFile>& tables)
{
  tables = NamedFile{"rail_bending/table", "", {}};
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
}

bool isGiven(const RailFiles& rail)
{
  return !rail.parts.empty() || !rail.profile.value.empty();
}
}  // namespace

void readWheels(ParameterReader& reader, core::ContactModelConfig& model, ModelFiles& files)
{
  readProfile(reader, "wheel/profile", files.wheel_profile.left);
  files.wheel_profile.right = files.wheel_profile.left;
  core::Sides<double>& radius = model.wheelset.rolling_radius;
  reader.read("wheelset/rolling_radius", rules::finite, radius.left);
  radius.right = radius.left;
  for (const core::Side side : core::sides)
  {
    readProfile(reader, sideGroup("wheel", side) + "profile", files.wheel_profile[side]);
    reader.read(sideGroup("wheel", side) + "rolling_radius", rules::finite, radius[side]);
    readOutOfRound(reader, sideGroup("wheel", side) + "out_of_round", radius[side], files.rim[side],
                   files.out_of_round[side]);
  }
  readMaterials(reader, "wheel", model.wheel_material);
}

void readRails(ParameterReader& reader, core::ContactModelConfig& model, ModelFiles& files)
{
  reader.refuseIf(reader.has("track/cant"), "track/cant",
                  "renamed to track/rail_inclination (cant is the superelevation of the track)");
  core::Sides<double>& inclination = model.track.rail_inclination;
  readInclination(reader, "track/rail_inclination", inclination.left);
  inclination.right = inclination.left;
  readRail(reader, "rail/profile", files.rail.left);
  files.rail.right = files.rail.left;
  for (const core::Side side : core::sides)
  {
    readRail(reader, sideGroup("rail", side) + "profile", files.rail[side]);
    readInclination(reader, sideGroup("rail", side) + "inclination", inclination[side]);
  }
  readMaterials(reader, "rail", model.rail_material);
  readTables(reader, files.table);
}

void requireProfiles(const ParameterReader& reader, const ModelFiles& files)
{
  constexpr const char* why = "give the name of a profile or a file";
  if (files.wheel_profile.left.value.empty() || files.wheel_profile.right.value.empty())
  {
    reader.require("wheel/profile", why);
  }
  if (!isGiven(files.rail.left) || !isGiven(files.rail.right))
  {
    reader.require("rail/profile", why);
  }
}
}  // namespace wheel_rail_contact
