// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/contact_place.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Arc length from the origin of a profile to the parameter u [m].
double arcFromOrigin(const Profile& profile, double u)
{
  return arcLength(profile, profile.partAt(u).origin, u);
}
}  // namespace

void placeOnBodies(const ContactModelConfig& config, const WheelsetPose& axle, const Profile& rail,
                   const ProfilePlaces& places, PatchResult& patch)
{
  const Eigen::Vector3d along_axle(-std::sin(axle.yaw) * std::cos(axle.roll), std::cos(axle.yaw) * std::cos(axle.roll),
                                   std::sin(axle.roll));
  const Eigen::Vector3d forward(std::cos(axle.yaw), std::sin(axle.yaw), 0);
  const Eigen::Vector3d up = forward.cross(along_axle);
  const Eigen::Vector3d place(patch.pose.x, patch.pose.y - axle.y, patch.pose.z - axle.z);
  patch.wheel_angle = std::atan2(place.dot(forward), -place.dot(up));

  const Profile& wheel = *config.wheel_profile[patch.side];
  const CurvePoint on_wheel = wheel.at(places.wheel_u);
  patch.rolling_radius = config.wheelset.rolling_radius[patch.side] - on_wheel.z;
  patch.wheel_s = arcFromOrigin(wheel, places.wheel_u);
  patch.rail_s = arcFromOrigin(rail, places.rail_u);
  patch.curvature_along = std::abs(on_wheel.dy) / std::hypot(on_wheel.dy, on_wheel.dz) / patch.rolling_radius;
  patch.curvature_across = on_wheel.curvature() - rail.at(places.rail_u).curvature();
}
}  // namespace wheel_rail_contact::core
