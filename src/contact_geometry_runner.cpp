// SPDX-License-Identifier: BSD-3-Clause
// The calculations of the command contact_geometry, which checks the options and draws the picture. Lengths in metres.
//   contact_geometry_runner OUT Y_FIRST Y_LAST Y_STEP ROLL DISTANCE AMPLITUDE_FIRST AMPLITUDE_LAST CONFIG.yaml...
// ROLL is solved or none. Each CONFIG.yaml is applied over those before.
#include <csignal>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "contact_geometry/tables.h"
#include "ros/parameters/file_names.h"
#include "ros/parameters/parameters.h"

namespace
{
using namespace wheel_rail_contact;

constexpr std::size_t first_config = 8;  ///< among the arguments

NodeConfig readConfig(const std::vector<std::string>& arguments)
{
  ParameterTree tree = readParameterFile(arguments[first_config]);
  for (std::size_t i = first_config + 1; i < arguments.size(); ++i)
  {
    tree = overlay(tree, readParameterFile(resolveFile(arguments[i], ".")));
  }
  return readNodeConfig(tree, "", std::filesystem::current_path().string());
}

/// Reports parameters that move the rails: the contact geometry is that of the ideal track.
void reportUnused(const NodeConfig& config)
{
  const auto report = [](const char* parameter)
  { std::cerr << "contact_geometry: " << parameter << " is not used: the rails are rigid, in the ideal track\n"; };
  if (config.model.rail_bending.model != core::RailBendingConfig::Model::none)
  {
    report("rail_bending/model");
  }
  if (config.model.track.line)
  {
    report("track/line");
  }
  if (config.displacement_topic)
  {
    report("track/displacement");
  }
}

void run(const std::vector<std::string>& arguments)
{
  const NodeConfig config = readConfig(arguments);
  for (const std::string& note : config.notes)
  {
    std::cerr << "contact_geometry: " << note << '\n';
  }
  reportUnused(config);
  core::ContactGeometryOptions options;
  options.y_first = std::stod(arguments[1]);
  options.y_last = std::stod(arguments[2]);
  options.y_step = std::stod(arguments[3]);
  options.roll = arguments[4] == "solved";
  options.distance = std::stod(arguments[5]);
  const std::filesystem::path folder = arguments[0];
  const core::ContactGeometry geometry = core::contactGeometry(config.model, options);
  core::contact_geometry::writePoints(geometry, folder / "contact_geometry.csv");
  core::contact_geometry::writeConicity(geometry, config.model.wheelset,
                                        {std::stod(arguments[6]), std::stod(arguments[7]), options.y_step},
                                        folder / "equivalent_conicity.csv");
}
}  // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() <= first_config)
  {
    std::cerr
        << "usage: contact_geometry_runner OUT Y_FIRST Y_LAST Y_STEP ROLL DISTANCE AMPLITUDE_FIRST AMPLITUDE_LAST "
           "CONFIG.yaml...\n";
    return 2;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // at the file size limit, writing fails with an error as on a full disk
  try
  {
    run(arguments);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "contact_geometry: " << error.what() << '\n';
    return 1;
  }
}
