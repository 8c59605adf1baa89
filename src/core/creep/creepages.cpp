// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>

#include "core/option_check.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
namespace
{
using Eigen::Vector3d;

/// Vertical velocity [m/s] at which the wheel's profile follows the rail at a contact, less the part by the roll rate.
/// The direction of the rail moves the place of its profile with the running speed.
double followingRise(const WheelsetMotion& motion, const ContactPlace& place)
{
  const double lateral = motion.lateral_velocity + motion.yaw_rate * place.position.x() - place.rail_velocity_y -
                         motion.speed * place.slope_y;
  return std::tan(place.angle) * lateral + place.rail_velocity_z + motion.speed * place.slope_z;
}

/// Rise of the profile at a contact per roll rate, at which it neither opens nor closes [m].
double rollLever(const ContactPlace& place)
{
  return place.position.y() + std::tan(place.angle) * place.position.z();
}

Vector3d rotationOf(const WheelsetMotion& motion)
{
  return Vector3d(motion.roll_rate, 0, motion.yaw_rate) + motion.rotation * axleDirection(motion.yaw, motion.roll);
}

/// Velocity of the wheel's particles relative to those of the rail [m/s].
Vector3d slipOf(const WheelsetMotion& motion, const ContactPlace& place)
{
  return Vector3d(motion.speed, motion.lateral_velocity, motion.vertical_velocity) +
         rotationOf(motion).cross(place.position) - Vector3d(0, place.rail_velocity_y, place.rail_velocity_z);
}
}  // namespace

Vector3d axleDirection(double yaw, double roll)
{
  const double level = std::cos(roll);
  return {-std::sin(yaw) * level, std::cos(yaw) * level, std::sin(roll)};
}

Vector3d sectionNormal(const ContactPlace& place)
{
  return {0, -std::sin(place.angle), std::cos(place.angle)};
}

Eigen::Matrix3d patchAxes(const ContactPlace& place)
{
  const Vector3d along = Vector3d(1, place.slope_y, place.slope_z).normalized();
  const Vector3d section = sectionNormal(place);
  const Vector3d normal = (section - section.dot(along) * along).normalized();
  return (Eigen::Matrix3d() << along, normal.cross(along), normal).finished();
}

Creepage creepages(const WheelsetMotion& motion, const ContactPlace& place)
{
  require(std::isfinite(motion.speed) && motion.speed != 0, "speed", motion.speed, "must be finite and not 0");
  const Vector3d slip = slipOf(motion, place), rotation = rotationOf(motion);
  const Eigen::Matrix3d axes = patchAxes(place);
  const double speed = std::abs(motion.speed);
  return {slip.dot(axes.col(0)) / speed, slip.dot(axes.col(1)) / speed, rotation.dot(axes.col(2)) / speed};
}

double normalVelocity(const WheelsetMotion& motion, const ContactPlace& place)
{
  return slipOf(motion, place).dot(patchAxes(place).col(2));
}

void followRails(const ContactPlace& left, const ContactPlace& right, WheelsetMotion& motion)
{
  constexpr double least = 0.1;  // of the distance of the contacts
  const double lever = rollLever(left) - rollLever(right);
  const bool is_known = std::abs(lever) > least * std::abs(left.position.y() - right.position.y());
  motion.roll_rate = is_known ? (followingRise(motion, left) - followingRise(motion, right)) / lever : 0;
  motion.vertical_velocity = followingRise(motion, left) - motion.roll_rate * rollLever(left);
}
}  // namespace wheel_rail_contact::core
