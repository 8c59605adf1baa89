// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "examples/simulate_wheelset/parameters.h"

namespace simulate_wheelset
{
/// The ways to the contact calculation.
enum class ContactWay
{
  in_process,
  topics,
  service
};

/// Command line of the program.
struct Options
{
  bool help = false;                            ///< --help
  ContactWay contact = ContactWay::in_process;  ///< --contact
  std::string config;                           ///< --config; empty: the defaults of Parameters
  std::string contact_config;                   ///< --contact-config, for in_process
  std::string out;                              ///< --out; empty: no table
  std::string node = "contact_node";            ///< --node: name of the contact node
  std::string frame = "track";                  ///< --frame: its parameter track/frame
  std::optional<double> speed, duration, step;  ///< over the values of the file [m/s], [s], [s]
};

/// Text of --help.
std::string usage();

/// @param arguments without the name of the program and without those of ROS
/// @throw std::invalid_argument with the option, the value and the broken rule.
Options parseOptions(const std::vector<std::string>& arguments);

/// Parameters of the file, with the values of the command line over them.
/// @throw std::invalid_argument with the name, the value and the broken rule.
Parameters parametersOf(const Options& options);
}  // namespace simulate_wheelset
