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
  /// @throw std::runtime_error if there is no service within a minute, or the node expects another
  /// load (requireWheelLoads()).
  ServiceContact(const std::string& node, std::string frame);

  double rollingRadius() const override { return rolling_radius_; }
  /// @throw std::runtime_error if the service fails.
  ContactReply evaluate(const ContactRequest& request) override;

 private:
  std::string frame_;
  const double rolling_radius_;  ///< [m]
  ros::NodeHandle nh_;
  ros::ServiceClient client_;
};
}  // namespace simulate_wheelset
