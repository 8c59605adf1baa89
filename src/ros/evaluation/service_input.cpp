// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/service_input.h"

#include <boost/make_shared.hpp>

namespace wheel_rail_contact
{
namespace
{
template <typename Message>
boost::shared_ptr<const Message> copied(const Message& message)
{
  return boost::make_shared<const Message>(message);
}
}  // namespace

ContactInput inputOf(const EvaluateWheelset::Request& request, const NodeConfig& config)
{
  ContactInput input;
  for (const InputTopic topic : inputTopics(config))
  {
    switch (topic)
    {
      case InputTopic::pose:
        input.pose = copied(request.pose);
        break;
      case InputTopic::load:
        input.load = copied(request.load);
        break;
      case InputTopic::left_rail_force:
        input.rail_force.left = copied(request.left_rail_force);
        break;
      case InputTopic::right_rail_force:
        input.rail_force.right = copied(request.right_rail_force);
        break;
      case InputTopic::rail_displacement:
        input.rail_displacement = copied(request.rail_displacement);
        break;
      case InputTopic::distance:
        input.distance = copied(request.distance);
        break;
    }
  }
  return input;
}
}  // namespace wheel_rail_contact
