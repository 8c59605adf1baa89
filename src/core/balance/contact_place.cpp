// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/contact_place.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_steps = 20;         ///< of the search for the opposite point
constexpr double longest_step = 5e-3;  ///< a longer one leads to another place of the profile [m]
constexpr double accuracy = 1e-9;      ///< [m]

/// Arc length from the origin of a profile to the parameter u [m].
double arcFromOrigin(const Profile& profile, double u)
{
  return arcLength(profile, profile.partAt(u).origin, u);
}

/// Parameter of the wheel profile whose point, in the section at x [m], lies on the normal of the rail at `origin` [m].
/// Newton's method from `u`: a wheel turns little over the distance.
double opposite(const PlacedWheel& wheel, const PlanePoint& origin, double x, double u)
{
  for (int i = 0; i < most_steps; ++i)
  {
    PlanePoint point{};
    if (!wheel.section(wheel.profile().at(u), x, point))
    {
      break;
    }
    const double step = ((origin.y - point.y) * origin.dy + (origin.z - point.z) * origin.dz) /
                        (point.dy * origin.dy + point.dz * origin.dz);
    if (!(std::abs(step) < longest_step))
    {
      break;
    }
    u += step;
    if (std::abs(step) < accuracy)
    {
      break;
    }
  }
  return u;
}
}  // namespace

void placeOnBodies(const ContactModelConfig& config, const WheelsetPose& axle, const PlacedRail& rail,
                   const ProfilePlaces& places, PatchResult& patch)
{
  const Eigen::Vector3d along_axle(-std::sin(axle.yaw) * std::cos(axle.roll), std::cos(axle.yaw) * std::cos(axle.roll),
                                   std::sin(axle.roll));
  const Eigen::Vector3d forward(std::cos(axle.yaw), std::sin(axle.yaw), 0);
  const Eigen::Vector3d up = forward.cross(along_axle);
  const Eigen::Vector3d place(patch.pose.x, patch.pose.y - axle.y, patch.pose.z - axle.z);
  patch.wheel_angle = std::atan2(place.dot(forward), -place.dot(up));

  const Profile& wheel = *config.wheel_profile[patch.side];
  const PlacedWheel placed(wheel, config.wheelset, patch.side, toSide(patch.side, axle));
  const double wheel_u = opposite(placed, rail.at(places.rail_u), patch.pose.x, places.wheel_u);
  const CurvePoint on_wheel = wheel.at(wheel_u);
  patch.rolling_radius = config.wheelset.rolling_radius[patch.side] - on_wheel.z;
  patch.wheel_s = arcFromOrigin(wheel, wheel_u);
  patch.rail_s = arcFromOrigin(rail.profile(), places.rail_u);
  patch.curvature_along = std::abs(on_wheel.dy) / std::hypot(on_wheel.dy, on_wheel.dz) / patch.rolling_radius;
  patch.curvature_across = on_wheel.curvature() - rail.profile().at(places.rail_u).curvature();
}
}  // namespace wheel_rail_contact::core
