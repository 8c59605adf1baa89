// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/service_contact.h"

#include <wheel_rail_contact/EvaluateWheelset.h>

#include <stdexcept>
#include <utility>

#include "examples/simulate_wheelset/message_reply.h"
#include "examples/simulate_wheelset/node_parameters.h"

namespace simulate_wheelset
{
namespace
{
using wheel_rail_contact::EvaluateWheelset;

constexpr double longest_wait = 60;  ///< for the service [s]
}  // namespace

ServiceContact::ServiceContact(const std::string& node, std::string frame)
    : frame_(std::move(frame)), rolling_radius_(rollingRadiusOf(node))
{
  const std::string service = nh_.resolveName(node + "/evaluate");
  if (!ros::service::waitForService(service, ros::Duration(longest_wait)))
  {
    throw std::runtime_error("no service " + service + " within a minute");
  }
  requireWheelLoads(node);
  // A persistent client connects when it is made: the service must exist.
  client_ = nh_.serviceClient<EvaluateWheelset>(service, true);
}

ContactReply ServiceContact::evaluate(const ContactRequest& request)
{
  EvaluateWheelset call;
  call.request.pose = poseMessage(request, frame_);
  call.request.load = loadMessage(request, frame_);
  if (!client_.call(call))
  {
    throw std::runtime_error("the call of " + client_.getService() + " failed");
  }
  return replyOf(call.response.contact);
}
}  // namespace simulate_wheelset
