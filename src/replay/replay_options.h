// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "bag/bag_contents.h"
#include "config/node_config.h"
#include "ros/evaluation/input_topic.h"

namespace wheel_rail_contact
{
/// Wheelsets in a bag, and the names of their input topics.
struct BagInputs
{
  std::vector<std::string> wheelsets{""};  ///< namespaces, "" or "/name"
  /// Names that differ from nameOf(): relative to the namespace of each wheelset, or absolute (only with one wheelset).
  std::map<InputTopic, std::string> names;

  /// Absolute name of an input topic of a wheelset.
  std::string topicOf(const std::string& wheelset, InputTopic topic) const;
  /// @param topics  inputs that the parameters require
  /// @throw std::invalid_argument if the name of another input is given, or if two inputs are on one topic.
  void check(const std::vector<InputTopic>& topics) const;

 private:
  void requireUsed(const std::vector<InputTopic>& topics) const;
  void requireDistinct(const std::vector<InputTopic>& topics) const;
};

/// Command line option that gives the name of an input topic, for example "--left-rail-force".
std::string optionOf(InputTopic topic);

/// Command line options of contact_replay.
struct ReplayOptions
{
  std::string input;                 ///< bag to read
  std::string output;                ///< bag to write
  std::vector<std::string> configs;  ///< parameter files, each applied over those before
  BagInputs inputs;                  ///< wheelsets and their topics
  std::string tf_static;             ///< bag whose /tf_static is read first; empty: none
  std::string csv;                   ///< table of patches to write; empty: no table
  std::string compression = "none";  ///< of the output: none or lz4
  BagSpan span;                      ///< inputs that become complete in this span are evaluated
  std::uint64_t most_expanded = 0;   ///< of the input, see BagFile [B]
  int threads = 1;                   ///< threads that evaluate, at least 1
  bool grids = true;                 ///< false: the pressure grids are left empty
  bool keep_topics = false;          ///< true: the other messages of the input are copied
  bool resume = false;               ///< true: an interrupted run is continued
  bool help = false;                 ///< true: only the usage is printed
};

/// Parses the arguments without the program name.
/// @throw std::invalid_argument with the argument and the violated rule.
ReplayOptions parseReplayOptions(const std::vector<std::string>& arguments);

/// Prints the text of --help.
void printReplayUsage(std::ostream& out);

/// Parameters of a replay: config/default.yaml, with the files of the options applied over it.
/// @throw std::exception if a file cannot be read.
ParameterTree replayParameters(const ReplayOptions& options);

/// Field of the description in the connection headers of the results.
constexpr const char* description_field = "contact_replay";
/// Beginning of the last line of the description if only a part of the input was evaluated.
constexpr const char* part_line = "part: ";

/// Description of a replay as text: size of the input, message type, options and parameters. Resuming requires an equal
/// description. Of files named by parameters (profiles, tables) it contains only the names.
/// @param input_size size of the input bag [B]
std::string replayDescription(const ReplayOptions& options, const ParameterTree& parameters, std::uint64_t input_size);

/// Namespaces of the wheelsets in a description.
std::vector<std::string> describedWheelsets(const std::string& description);
}  // namespace wheel_rail_contact
