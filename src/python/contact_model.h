// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <mutex>
#include <string>
#include <vector>

#include "config/node_config.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact
{
/// Side by its name.
/// @throw std::invalid_argument unless it is "left" or "right".
core::Side sideOf(const std::string& name);

/// Where the module finds files: names are relative to the working folder.
FileSearch fileSearch();

/// Text of a status as the node publishes it: with the warning of a rail beyond the linear range of its table.
std::string statusTextOf(const core::WheelsetResult& result, const core::Sides<double>& linear_range);

/// Contact of one wheelset with the parameters of the node, without ROS topics. Thread-safe: calls of several threads
/// wait for each other.
class ContactModel
{
 public:
  /// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
  explicit ContactModel(const std::vector<ParameterSource>& sources);

  /// Evaluates a state. Starts from the previous result.
  core::WheelsetResult evaluate(const core::WheelsetState& state);
  /// Stiffness of the contact of a wheel in the last result: see core::WheelsetContact::stiffness().
  Eigen::Matrix3d stiffness(core::Side side);
  /// Discards the previous result.
  void reset();

  /// Parameters as they were given.
  const ParameterTree& parameters() const { return parameters_; }
  /// Parameters as they were read.
  const NodeConfig& config() const { return config_; }

 private:
  ParameterTree parameters_;
  NodeConfig config_;
  std::mutex mutex_;  ///< of contact_
  core::WheelsetContact contact_;
};
}  // namespace wheel_rail_contact
