// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/ros/rail_motion.h"

#include <Eigen/Geometry>

namespace wheel_rail_contact
{
std::optional<PlacedRail> restingRail(const ContactModelConfig* model)
{
  return model ? std::make_optional<PlacedRail>(model->rail_profile, model->track) : std::nullopt;
}

RailDeflection scaled(const RailDeflection& deflection, double scale)
{
  return {scale * deflection.lateral, scale * deflection.vertical, scale * deflection.roll};
}

PatchPose carriedByRail(const PlacedRail& at_rest, Side side, const RailDeflection& from, const RailDeflection& to,
                        const PatchPose& pose)
{
  const PlacedRail before = at_rest.deflected(from), after = at_rest.deflected(to);
  const PlanePoint a = before.referencePoint(), b = after.referencePoint();
  const double turn = after.angle() - before.angle(), sign = sideSign(side);
  const Eigen::Vector2d moved =
      Eigen::Vector2d(b.y, b.z) + Eigen::Rotation2Dd(turn) * Eigen::Vector2d(sign * pose.y - a.y, pose.z - a.z);
  return {pose.x, sign * moved.x(), moved.y(), pose.angle + sign * turn};
}
}  // namespace wheel_rail_contact
