// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

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
}  // namespace wheel_rail_contact
