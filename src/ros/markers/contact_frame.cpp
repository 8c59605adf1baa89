// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_frame.h"

#include <cmath>

namespace wheel_rail_contact
{
using Eigen::Vector3d;

std::optional<Eigen::Isometry3d> contactFrame(const core::WheelsetResult& result, core::Side side)
{
  double total = 0;
  Vector3d place = Vector3d::Zero(), force = Vector3d::Zero();
  for (const core::PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      const double n = patch.normal_force;
      total += n;
      place += n * Vector3d(patch.pose.x, patch.pose.y, patch.pose.z);
      force += n * Vector3d(0, -std::sin(patch.pose.angle), std::cos(patch.pose.angle));
    }
  }
  if (!(total > 0))
  {
    return std::nullopt;
  }
  return Eigen::Translation3d(place / total) * Eigen::AngleAxisd(std::atan2(-force.y(), force.z()), Vector3d::UnitX());
}

Eigen::Isometry3d railFrame(const core::PlacedRail& at_rest, core::Side side)
{
  const core::PlanePoint p = at_rest.referencePoint();
  return Eigen::Isometry3d(Eigen::Translation3d(0, core::sideSign(side) * p.y, p.z));
}
}  // namespace wheel_rail_contact
