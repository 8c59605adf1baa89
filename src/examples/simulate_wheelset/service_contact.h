// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

#include "examples/simulate_wheelset/contact_source.h"

namespace simulate_wheelset
{
/// A contact node, over its service `evaluate` with one persistent connection.
class ServiceContact : public ContactSource
{
 public:
  /// Waits for the service.
  /// @param node  name of the contact node
  /// @param frame its parameter track/frame
  /// @throw std::runtime_error if there is no service within a minute, or the node balances moments.
  ServiceContact(const std::string& node, std::string frame);

  /// @throw std::runtime_error if the service fails.
  ContactReply evaluate(const ContactRequest& request) override;

 private:
  std::string frame_;
  ros::NodeHandle nh_;
  ros::ServiceClient client_;
};
}  // namespace simulate_wheelset
