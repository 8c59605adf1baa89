// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/load_interpolation.h"

#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
namespace
{
void interpolate(const geometry_msgs::Vector3& after, double share, geometry_msgs::Vector3& value)
{
  value.x += share * (after.x - value.x);
  value.y += share * (after.y - value.y);
  value.z += share * (after.z - value.z);
}
}  // namespace

geometry_msgs::WrenchStamped interpolatedLoad(const geometry_msgs::WrenchStamped& before,
                                              const geometry_msgs::WrenchStamped& after, const ros::Time& stamp)
{
  geometry_msgs::WrenchStamped load = after;
  load.header.stamp = stamp;
  if (after.header.stamp == before.header.stamp)
  {
    return load;
  }
  const double share = (stamp - before.header.stamp).toSec() / (after.header.stamp - before.header.stamp).toSec();
  load.wrench = before.wrench;
  interpolate(after.wrench.force, share, load.wrench.force);
  interpolate(after.wrench.torque, share, load.wrench.torque);
  return load;
}

std::string interpolationFault(const geometry_msgs::WrenchStamped& before, const geometry_msgs::WrenchStamped& after)
{
  if (before.header.frame_id == after.header.frame_id)
  {
    return "";
  }
  return formatted(
      "load: frame_id is '%.60s' before the pose and '%.60s' after it, but must be the same to interpolate",
      before.header.frame_id.c_str(), after.header.frame_id.c_str());
}
}  // namespace wheel_rail_contact
