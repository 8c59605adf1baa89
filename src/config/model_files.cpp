// SPDX-License-Identifier: BSD-3-Clause
#include "config/model_files.h"

#include <cmath>

#include "config/compliance_table_file.h"
#include "config/text.h"

namespace wheel_rail_contact
{
namespace
{
/// Opens a file.
/// @param open function that opens the file `value`
/// @throw std::invalid_argument with the name of the parameter and the reason if `open` throws.
template <typename Open>
auto openFile(const NamedFile& file, const Open& open)
{
  try
  {
    return open(file.value);
  }
  catch (const std::exception& error)
  {
    const std::string reason = error.what();
    const bool names_file = reason.compare(0, file.value.size() + 1, file.value + ":") == 0;
    throw std::invalid_argument(file.parameter + " = " + (names_file ? "" : file.value + ": ") + reason);
  }
}

/// Number that YAML reads in the whole text, or nothing.
std::optional<double> numberIn(const std::string& text)
{
  double number = 0.0;
  return YAML::convert<double>::decode(YAML::Node(text), number) ? std::optional<double>(number) : std::nullopt;
}

/// Name of the standard profile that ROS has read as the number `value`, or `value` itself. On a command line, and in a
/// <param> without a type in a launch file, ROS reads `_rail/profile:=60E1` as 60e1: 600.
std::string nameFromNumber(const std::string& value)
{
  const std::optional<double> number = numberIn(value);
  for (const core::ProfileKind kind : {core::ProfileKind::wheel, core::ProfileKind::rail})
  {
    for (const std::string& name : core::standardProfileNames(kind))
    {
      if (number && numberIn(name) == number)
      {
        return name;
      }
    }
  }
  return value;
}

/// True unless the name can only be that of a standard profile.
bool isFile(const std::string& name)
{
  return name.find_first_of("./") != std::string::npos;
}

/// Opens profiles, and notes what was understood of each file.
class ProfileFiles
{
 public:
  /// @param config  to which notes and warnings are added
  ProfileFiles(const FileSearch& search, NodeConfig& config)
      : search_(search), config_(config), scale_(core::modelScale(config.model.track, config.model.wheelset))
  {
  }

  /// Opens a shipped profile, or a file if the value contains a dot or a slash.
  std::shared_ptr<const core::Profile> open(const NamedFile& file, core::ProfileKind kind)
  {
    return openFile(file,
                    [&](const std::string& value)
                    {
                      const std::string name = nameFromNumber(value);
                      core::DescribedProfile described = openProfile(name, kind, ofVehicle(file.reading), search_);
                      if (isFile(name))
                      {
                        addNote(file, described.report.text);
                        warnOfInclination(file, described.report.inclination);
                      }
                      return std::make_shared<const core::Profile>(std::move(described.profile));
                    });
  }

  core::RailSeries open(const RailPartFiles& part)
  {
    if (!part.slices.value.empty())
    {
      return openFile(part.slices,
                      [&](const std::string& value)
                      {
                        std::vector<std::string> notes;
                        core::RailSeries series =
                            core::readRailSlices(search_.find(value), ofVehicle(part.reading), notes);
                        for (const std::string& note : notes)
                        {
                          addNote(part.slices, note);
                        }
                        return series;
                      });
    }
    core::RailSeries series;
    std::map<std::string, std::shared_ptr<const core::Profile>> opened;  // the rail does not change between equal ones
    for (const RailSectionFile& section : part.sections)
    {
      std::shared_ptr<const core::Profile>& profile = opened[section.file.value];
      profile = profile ? profile : open(section.file, core::ProfileKind::rail_section);
      series.push_back({section.x, profile, {}});
    }
    return series;
  }

 private:
  void addNote(const NamedFile& file, const std::string& note)
  {
    std::string line = file.parameter;
    line.append(" = ").append(file.value).append(": ").append(note);
    config_.notes.push_back(line);
  }

  /// Options of a file, with the dimensions of the wheelset.
  core::ProfileReading ofVehicle(core::ProfileReading reading) const
  {
    reading.tape_circle = config_.model.wheelset.tape_circle;
    reading.scale = scale_;
    return reading;
  }

  /// Warns of a rail that is stored inclined and inclined once more, or to the field side.
  void warnOfInclination(const NamedFile& file, const std::optional<double>& stored)
  {
    constexpr double least = 0.01;  // [rad]
    const core::Sides<double>& added = config_.model.track.rail_inclination;
    const double more = std::max(std::abs(added.left), std::abs(added.right));
    if (stored && (*stored < -least || (*stored > least && more > least)))
    {
      config_.warnings.push_back(file.parameter + " = " + file.value +
                                 formatted(": the file looks inclined by 1:%.3g%s; rail_inclination adds %.3g rad",
                                           1 / std::tan(std::abs(*stored)), *stored < 0 ? " to the field side" : "",
                                           more));
    }
  }

  const FileSearch& search_;
  NodeConfig& config_;
  double scale_;  ///< of a model
};

/// Rail of one side: its profile, or its sections.
struct OpenRail
{
  std::shared_ptr<const core::Profile> profile;
  std::shared_ptr<const core::RailSections> sections;
};

OpenRail openRail(const RailFiles& rail, ProfileFiles& files)
{
  if (rail.parts.empty())
  {
    return {files.open(rail.profile, core::ProfileKind::rail), nullptr};
  }
  std::vector<core::RailSeries> parts;
  parts.reserve(rail.parts.size());
  for (const RailPartFiles& part : rail.parts)
  {
    parts.push_back(files.open(part));
  }
  try
  {
    return {nullptr, std::make_shared<core::RailSections>(std::move(parts), rail.placement)};
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(rail.parameter + ": " + error.what());
  }
}

/// Opens the files of both sides, common ones only once.
template <typename Files, typename Open>
auto openBoth(const core::Sides<Files>& files, const Open& open)
{
  auto left = open(files.left);
  auto right = files.left == files.right ? left : open(files.right);
  return core::Sides<decltype(left)>(std::move(left), std::move(right));
}

void openTables(const core::Sides<NamedFile>& files, const FileSearch& search, NodeConfig& config)
{
  const core::Sides<ComplianceTableFile> tables = openBoth(
      files, [&](const NamedFile& file)
      { return openFile(file, [&](const std::string& value) { return readComplianceTable(search.find(value)); }); });
  for (const core::Side side : core::sides)
  {
    config.model.rail_bending.table[side] = tables[side].table;
    config.linear_range[side] = tables[side].linear_range;
    for (NeighbourConfig& neighbour : config.neighbours)
    {
      neighbour.influence[side] = influenceAt(tables[side].neighbours, neighbour.distance);
    }
  }
}
}  // namespace

core::DescribedProfile openProfile(const std::string& name, core::ProfileKind kind, const core::ProfileReading& reading,
                                   const FileSearch& search)
{
  return core::describedProfile(isFile(name) ? search.find(name) : name, kind, reading);
}

void openFiles(const ModelFiles& files, const FileSearch& search, NodeConfig& config)
{
  ProfileFiles profiles(search, config);
  config.model.wheel_profile = openBoth(
      files.wheel_profile, [&](const NamedFile& file) { return profiles.open(file, core::ProfileKind::wheel); });
  const core::Sides<OpenRail> rails =
      openBoth(files.rail, [&](const RailFiles& rail) { return openRail(rail, profiles); });
  for (const core::Side side : core::sides)
  {
    config.model.rail_profile[side] = rails[side].profile;
    config.model.rail_sections[side] = rails[side].sections;
    core::OutOfRound wheel = files.out_of_round[side];
    if (!files.rim[side].value.empty())
    {
      wheel.table =
          openFile(files.rim[side], [&](const auto& file) { return core::readOutOfRound(search.find(file)); });
    }
    if (!wheel.table.empty() || !wheel.harmonics.empty() || !wheel.flats.empty())
    {
      config.model.wheelset.out_of_round[side] = std::make_shared<core::OutOfRound>(std::move(wheel));
    }
  }
  if (!files.line.value.empty())
  {
    config.model.track.line =
        openFile(files.line,
                 [&](const std::string& value)
                 {
                   core::LineReport report;
                   auto line = std::make_shared<core::TrackLine>(
                       core::readTrackLine(search.find(value), config.model.track.gauge, files.line_reading, &report));
                   const std::string name = "track/line " + value + ": ";
                   config.notes.push_back(name + report.text);
                   for (const std::string& doubt : report.doubts)
                   {
                     config.warnings.push_back(name + doubt);
                   }
                   return line;
                 });
    if (!config.fixed_frame.empty())
    {
      config.path = std::make_shared<core::TrackPath>(config.model.track.line);
    }
  }
  if (config.model.rail_bending.model == core::RailBendingConfig::Model::compliance)
  {
    openTables(files.table, search, config);
  }
}
}  // namespace wheel_rail_contact
