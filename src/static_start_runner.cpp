// SPDX-License-Identifier: BSD-3-Clause
// The calculation of the command static_start: height and roll of a wheelset at rest under its load. SI units.
//   static_start_runner FORCE_Z TORQUE_X Y YAW DISTANCE LEFT_FORCE RIGHT_FORCE CONFIG.yaml...
// Each CONFIG.yaml is applied over those before. Prints one line "name value [unit]" for each quantity.
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "ros/evaluation/contact_statistics.h"
#include "ros/evaluation/conversions.h"
#include "ros/evaluation/text.h"
#include "ros/parameters/file_names.h"
#include "ros/parameters/parameters.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace
{
using namespace wheel_rail_contact;

constexpr std::size_t first_config = 7;  ///< among the arguments
constexpr int not_usable = 4;            ///< exit status

NodeConfig readConfig(const std::vector<std::string>& arguments)
{
  ParameterTree tree = readParameterFile(arguments[first_config]);
  for (std::size_t i = first_config + 1; i < arguments.size(); ++i)
  {
    tree = overlay(tree, readParameterFile(resolveFile(arguments[i], ".")));
  }
  return readNodeConfig(tree, "", std::filesystem::current_path().string());
}

core::WheelsetState readState(const std::vector<std::string>& arguments)
{
  core::WheelsetState state;
  state.force_z = std::stod(arguments[0]);
  state.torque_x = std::stod(arguments[1]);
  state.y = std::stod(arguments[2]);
  state.yaw = std::stod(arguments[3]);
  state.distance = std::stod(arguments[4]);
  state.rail_lateral_force = {std::stod(arguments[5]), std::stod(arguments[6])};
  return state;
}

void print(const core::WheelsetResult& result)
{
  std::printf("status %s\n", statusName(toMessage(result.status)));
  if (!result.reason.empty())
  {
    std::printf("reason %s\n", result.reason.c_str());
  }
  if (!isUsable(result.status))
  {
    return;
  }
  std::printf("z %.9f m\nroll %.9e rad\n", result.z, result.roll);
  for (const core::Side side : core::sides)
  {
    const core::RailResult& rail = result.rail[side];
    std::printf("%s_vertical_force %.1f N\n%s_lateral_force %.1f N\n", core::nameOf(side), rail.vertical_force,
                core::nameOf(side), rail.lateral_force);
  }
}

/// Inputs of a node with this configuration that the command does not have, one text each.
std::vector<std::string> missingInputs(const NodeConfig& config, const core::WheelsetState& state)
{
  std::vector<std::string> texts;
  if (!config.neighbours.empty())
  {
    texts.emplace_back("rail_bending/neighbours: the forces of the neighbours are unknown, and taken as zero");
  }
  if (config.displacement_topic)
  {
    texts.emplace_back("track/displacement = topic: the displacements of the rails are unknown, and taken as zero");
  }
  if (config.distance_topic)
  {
    texts.push_back(
        formatted("track/distance = topic: the place on the line is that of --distance, %g m", state.distance));
  }
  return texts;
}

void printNotes(const std::vector<std::string>& notes)
{
  for (const std::string& note : notes)
  {
    std::cerr << "static_start: " << note << '\n';
  }
}

int run(const std::vector<std::string>& arguments)
{
  NodeConfig config = readConfig(arguments);
  const core::WheelsetState state = readState(arguments);
  printNotes(config.notes);
  printNotes(missingInputs(config, state));
  config.model.wheelset.solve_height_and_roll = true;
  core::WheelsetContact contact(config.model);
  const core::WheelsetResult& result = contact.evaluate(state);
  print(result);
  return isUsable(result.status) ? 0 : not_usable;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() <= first_config)
  {
    std::cerr << "usage: static_start_runner FORCE_Z TORQUE_X Y YAW DISTANCE LEFT_FORCE RIGHT_FORCE CONFIG.yaml...\n";
    return 2;
  }
  try
  {
    return run(arguments);
  }
  catch (const std::exception& error)
  {
    std::cerr << "static_start: " << error.what() << '\n';
    return 1;
  }
}
