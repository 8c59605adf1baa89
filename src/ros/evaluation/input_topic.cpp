// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/input_topic.h"

namespace wheel_rail_contact
{
std::vector<InputTopic> inputTopics(const NodeConfig& config)
{
  using Bending = core::RailBendingConfig;
  const Bending& bending = config.model.rail_bending;
  std::vector<InputTopic> topics{InputTopic::pose};
  if (config.model.wheelset.solve_height_and_roll)
  {
    topics.push_back(InputTopic::load);
  }
  if (bending.model == Bending::Model::compliance && bending.lateral_force == Bending::LateralForce::topic)
  {
    topics.insert(topics.end(), {InputTopic::left_rail_force, InputTopic::right_rail_force});
  }
  if (config.displacement_topic)
  {
    topics.push_back(InputTopic::rail_displacement);
  }
  if (config.distance_topic)
  {
    topics.push_back(InputTopic::distance);
  }
  if (config.model.creep.method != core::CreepMethod::none)
  {
    topics.push_back(InputTopic::twist);
  }
  return topics;
}

std::string nameOf(InputTopic topic)
{
  constexpr std::array names{"pose",     "load", "left_rail_force", "right_rail_force", "rail_displacement",
                             "distance", "twist"};
  return std::string("wheelset/") + names.at(static_cast<std::size_t>(topic));
}
}  // namespace wheel_rail_contact
