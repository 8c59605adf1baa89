// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "bag/bag_contents.h"
#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// What contact_replay is told on its command line.
struct ReplayOptions
{
  std::string input;                       ///< bag to read
  std::string output;                      ///< bag to write
  std::vector<std::string> configs;        ///< parameter files, each laid over those before
  std::vector<std::string> wheelsets{""};  ///< namespaces, "" or "/name"
  std::string csv;                         ///< table of patches to write; empty: none
  std::string compression = "none";        ///< of the output: none or lz4
  BagSpan span;                            ///< what becomes ready in it is answered
  int threads = 1;                         ///< that evaluate, >= 1
  bool grids = true;                       ///< false leaves the pressure grids empty
  bool keep_topics = false;                ///< true copies the input's other messages
  bool resume = false;                     ///< true goes on with an output that was broken off
  bool help = false;                       ///< true: nothing but the usage is wanted
};

/// @throw std::invalid_argument naming the argument and the broken rule.
ReplayOptions parseReplayOptions(const std::vector<std::string>& arguments);

/// What --help prints.
void printReplayUsage(std::ostream& out);

/// The parameters of a replay: those of config/default.yaml, and over them the files of the options.
ParameterTree replayParameters(const ReplayOptions& options);

/// Field in the headers of the answers' connections that holds the description.
constexpr const char* description_field = "contact_replay";
/// How the last line of the description begins where only a part of the input was answered.
constexpr const char* part_line = "part: ";

/// What an output goes on with must be the same as in its first run, as text: size of the input, message type, options,
/// parameters.
/// Files that parameters name (profiles, tables) count by their names only.
std::string replayDescription(const ReplayOptions& options, const ParameterTree& parameters, std::uint64_t input_size);

/// The wheelsets' namespaces of a replay, as its description names them.
std::vector<std::string> describedWheelsets(const std::string& description);
}  // namespace wheel_rail_contact
