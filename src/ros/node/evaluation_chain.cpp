// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/evaluation_chain.h"

namespace wheel_rail_contact
{
constexpr double poll_period = 0.002;  ///< [s]

EvaluationChain::EvaluationChain(const NodeConfig& config, const TransformStore& transforms,
                                 const NeighbourForces& neighbours)
    : preparation_(config, transforms, neighbours), evaluator_(config), hold_(config)
{
}

ContactOutput EvaluationChain::evaluate(const ContactInput& input, const std::function<bool()>& ended)
{
  waitForTransform(input, ended);
  const ros::WallTime start = ros::WallTime::now();
  ContactOutput output = evaluator_.evaluate(preparation_.prepare(input));
  hold_.apply(output);
  output.solve_time = (ros::WallTime::now() - start).toSec();
  return output;
}

void EvaluationChain::restart()
{
  preparation_.restart();
  hold_.restart();
}

void EvaluationChain::waitForTransform(const ContactInput& input, const std::function<bool()>& ended) const
{
  const ros::WallTime deadline = input.arrival + ros::WallDuration(InputPreparation::transform_timeout);
  while (!preparation_.isReady(input) && ros::WallTime::now() < deadline && !ended())
  {
    ros::WallDuration(poll_period).sleep();
  }
}
}  // namespace wheel_rail_contact
