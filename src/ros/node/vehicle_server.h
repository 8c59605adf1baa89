// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <map>
#include <memory>
#include <string>

#include <wheel_rail_contact/EvaluateWheelsets.h>
#include "ros/node/contact_server.h"

namespace wheel_rail_contact
{
/// Implementation of node and nodelet: one wheelset, or with the parameter `wheelsets` several of them.
///
/// Each wheelset NAME has the topics, services and threads of a node of the same name in the namespace NAME, where its
/// parameters are also stored, for displays. The service `~evaluate_all` evaluates states of all of them at once.
class VehicleServer
{
 public:
  /// @throw std::invalid_argument for invalid parameters (wheelsetParameters(), ContactServer).
  VehicleServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  /// Ends after the current evaluations.
  ~VehicleServer();
  VehicleServer(const VehicleServer&) = delete;
  VehicleServer& operator=(const VehicleServer&) = delete;

 private:
  bool evaluateAll(EvaluateWheelsets::Request& request, EvaluateWheelsets::Response& response);
  WheelsetContact unknown(const WheelsetInput& input) const;

  std::map<std::string, std::unique_ptr<ContactServer>> wheelsets_;  ///< by name; "" without a list
  ros::CallbackQueue queue_;
  ros::ServiceServer service_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};
}  // namespace wheel_rail_contact
