// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <wheel_rail_contact/WheelsetContact.h>

#include <string>
#include <utility>

#include "examples/simulate_wheelset/contact_source.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace simulate_wheelset
{
/// The core library in this process.
class InProcessContact : public ContactSource
{
 public:
  /// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
  explicit InProcessContact(wheel_rail_contact::core::ContactModelConfig config) : contact_(std::move(config)) {}

  ContactReply evaluate(const ContactRequest& request) override { return contact_.evaluate(request.state); }

 private:
  wheel_rail_contact::core::WheelsetContact contact_;
};

/// Parameters of the contact for this program: friction, and the balance for its load.
constexpr const char* contact_parameters = "package://wheel_rail_contact/config/simulate_contact.yaml";

/// Reads parameters of the contact node for use in this process.
/// @param file  YAML file, applied over config/default.yaml and contact_parameters; empty: no further file
/// @throw std::invalid_argument with the name, the value and the broken rule; also for parameters that expect another
/// load or another state than the example has.
wheel_rail_contact::core::ContactModelConfig readContact(const std::string& file);

/// A contact node, over its service `evaluate` with one persistent connection.
class ServiceContact : public ContactSource
{
 public:
  /// Waits for the service.
  /// @param node  name of the contact node
  /// @param frame its parameter track/frame
  /// @throw std::runtime_error if there is no service within a minute, or the node expects another
  /// load (requireLoad()).
  ServiceContact(const std::string& node, std::string frame);

  /// @throw std::runtime_error if the service fails.
  ContactReply evaluate(const ContactRequest& request) override;

 private:
  std::string frame_;
  ros::NodeHandle nh_;
  ros::ServiceClient client_;
};

/// A contact node, over its topics, in lockstep: publishes pose, twist and load, and waits for the result with their
/// stamp.
///
/// The subscriber uses TCP without delay. Without this option each result may wait up to 40 ms in the socket.
class TopicContact : public ContactSource
{
 public:
  /// Waits until the node replies.
  /// @param node  name of the contact node
  /// @param frame its parameter track/frame
  /// @throw std::runtime_error if there is no reply within a minute, or the node expects another load
  /// (requireLoad()).
  TopicContact(const std::string& node, std::string frame);

  /// @throw std::runtime_error if there is no result within 10 s.
  ContactReply evaluate(const ContactRequest& request) override;

 private:
  void send(const ContactRequest& request);
  bool waitFor(const ros::Time& stamp, double seconds);

  std::string frame_;
  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  ros::Publisher pose_publisher_, twist_publisher_, load_publisher_;
  ros::Subscriber subscriber_;
  wheel_rail_contact::WheelsetContact::ConstPtr latest_;  ///< result of the last request; null before it is here
};

/// Checks that the load of the dynamics (WheelsetDynamics::request()) is the one that a contact node expects. It is for
/// wheelset/balance: moments, wheelset/free: [z, roll], and friction in the node (creep/method).
/// @param node name of the contact node
/// @throw std::runtime_error if the node has other values on the parameter server.
void requireLoad(const std::string& node);
}  // namespace simulate_wheelset
