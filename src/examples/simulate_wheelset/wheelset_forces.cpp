// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/wheelset_forces.h"

#include <Eigen/Geometry>
#include <cmath>

namespace simulate_wheelset
{
namespace
{
/// Axes of a patch in track axes: y in the tangent plane, z out of the rail. The x axes are the same.
struct PatchAxes
{
  explicit PatchAxes(double angle)
      : across(0, std::cos(angle), std::sin(angle)), normal(0, -std::sin(angle), std::cos(angle))
  {
  }
  Eigen::Vector3d across, normal;
};

/// Direction of the axle, to the left.
Eigen::Vector3d axleDirection(double yaw, double roll)
{
  return {-std::sin(yaw) * std::cos(roll), std::cos(yaw) * std::cos(roll), std::sin(roll)};
}

/// Contact of a wheel with the largest normal force; null if it has none.
const ContactPoint* mainContact(const ContactReply& contact, bool is_left)
{
  const ContactPoint* main = nullptr;
  for (const ContactPoint& point : contact.points)
  {
    if (point.is_left == is_left && (main == nullptr || point.normal_force > main->normal_force))
    {
      main = &point;
    }
  }
  return main;
}
}  // namespace

FollowingRates followingRates(const ContactReply& contact, const Motion& motion)
{
  // No velocity along the normal: z' + roll' (p_y + tan(angle) p_z) = tan(angle) (y' + yaw' p_x).
  const ContactPoint* const left = mainContact(contact, true);
  const ContactPoint* const right = mainContact(contact, false);
  const auto lever = [](const ContactPoint& p) { return p.position.y() + std::tan(p.angle) * p.position.z(); };
  const auto rise = [&](const ContactPoint& p)
  { return std::tan(p.angle) * (motion.y_rate + motion.yaw_rate * p.position.x()); };
  if (left == nullptr || right == nullptr)
  {
    const ContactPoint* const only = left == nullptr ? right : left;
    return {only == nullptr ? 0 : rise(*only), 0};
  }
  // Both levers become equal only if the slopes add up to the base over the radius, about 3.3: flanges on both sides.
  const double roll_rate = (rise(*left) - rise(*right)) / (lever(*left) - lever(*right));
  return {rise(*left) - roll_rate * lever(*left), roll_rate};
}

Creepage creepageAt(const ContactPoint& point, const Motion& motion, const FollowingRates& rates, double roll,
                    double speed)
{
  const PatchAxes axes(point.angle);
  const Eigen::Vector3d body_rotation(rates.roll, 0, motion.yaw_rate);
  const Eigen::Vector3d rotation = body_rotation + motion.spin * axleDirection(motion.yaw, roll);
  const Eigen::Vector3d centre(speed, motion.y_rate, rates.z);
  const Eigen::Vector3d velocity = centre + rotation.cross(point.position);
  return {velocity.x() / speed, velocity.dot(axes.across) / speed, rotation.dot(axes.normal) / speed};
}

RailForces railForces(const ContactReply& contact, const Motion& motion, double speed, const CreepLaw& law)
{
  RailForces sum;
  const FollowingRates rates = followingRates(contact, motion);
  for (const ContactPoint& point : contact.points)
  {
    const PatchAxes axes(point.angle);
    const Creepage creepage = creepageAt(point, motion, rates, contact.roll, speed);
    const CreepForce creep = law.force({point.semi_axis_along, point.semi_axis_across, point.normal_force}, creepage);
    const Eigen::Vector3d normal = point.normal_force * axes.normal;
    const Eigen::Vector3d tangential = creep.along * Eigen::Vector3d::UnitX() + creep.across * axes.across;
    sum.normal_force += normal;
    sum.normal_moment += point.position.cross(normal);
    sum.creep_force += tangential;
    sum.creep_moment += point.position.cross(tangential) + creep.moment * axes.normal;
    sum.creep.push_back(creep);
    sum.friction_power -=
        speed * (creep.along * creepage.along + creep.across * creepage.across + creep.moment * creepage.spin);
  }
  // The normal forces of surfaces of revolution pass through the axle.
  sum.spin_moment = sum.creep_moment.dot(axleDirection(motion.yaw, contact.roll));
  return sum;
}
}  // namespace simulate_wheelset
