// SPDX-License-Identifier: BSD-3-Clause
#include "core/wheel_wrench.h"

#include <Eigen/Geometry>

#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
Eigen::Vector3d forceOnWheel(const PatchResult& patch)
{
  return {-patch.slope_along * patch.normal_force, -sideSign(patch.side) * patch.lateral_force, patch.vertical_force};
}

WheelWrench wheelWrench(const WheelsetResult& result, Side side)
{
  WheelWrench wheel;
  double weight = 0;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      const Eigen::Vector3d arm(patch.pose.x, patch.pose.y - result.y, patch.pose.z - result.z);
      const Eigen::Matrix3d axes = patch.pose.rotation().toRotationMatrix();
      const CreepForce& friction = patch.creep.force;
      Eigen::Vector3d force = forceOnWheel(patch);
      force.x() += axes(0, 0) * friction.x + axes(0, 1) * friction.y;
      wheel.wrench += {force, arm.cross(force) + friction.moment * axes.col(2)};
      wheel.centre += patch.normal_force * arm;
      weight += patch.normal_force;
    }
  }
  wheel.centre /= weight > 0 ? weight : 1;
  wheel.wrench.moment -= wheel.centre.cross(wheel.wrench.force);
  return wheel;
}
}  // namespace wheel_rail_contact::core
