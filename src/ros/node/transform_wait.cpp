// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/transform_wait.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double poll_period = 0.002;  ///< [s]
}  // namespace

void waitForTransform(const InputPreparation& preparation, const ContactInput& input, const tf2::BufferCore& transforms,
                      const std::function<bool()>& ended)
{
  const ros::WallTime deadline = input.arrival + ros::WallDuration(InputPreparation::transform_timeout);
  while (!preparation.isReady(input, transforms) && ros::WallTime::now() < deadline && !ended())
  {
    ros::WallDuration(poll_period).sleep();
  }
}
}  // namespace wheel_rail_contact
