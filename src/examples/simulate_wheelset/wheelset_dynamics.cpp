// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/wheelset_dynamics.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

namespace simulate_wheelset
{
namespace
{
constexpr int most_iterations = 50;
constexpr double tolerance = 1e-11;  ///< of the velocities at the circumference of the wheels, over the running speed
constexpr double difference = 1e-7;  ///< for the derivatives, of the same velocities

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

WheelsetDynamics::WheelsetDynamics(const Parameters& parameters, double rolling_radius)
    : parameters_(parameters),
      rolling_radius_(rolling_radius),
      step_(1e-9 * static_cast<double>(parameters.run.stepNanoseconds())),
      law_(parameters.creep)
{
  motion_.y = parameters.run.y;
  motion_.yaw = parameters.run.yaw;
  motion_.spin = parameters.run.speed / rolling_radius;
}

ContactRequest WheelsetDynamics::request(std::int64_t time, double roll) const
{
  const SuspensionParameters& s = parameters_.suspension;
  ContactRequest request;
  request.time = time;
  request.distance = parameters_.run.start + parameters_.run.speed * 1e-9 * static_cast<double>(time);
  request.y = motion_.y;
  request.yaw = motion_.yaw;
  request.force_z = -parameters_.wheelset.axle_load + forces_.creep_force.z();
  request.torque_x = -2 * s.vertical_stiffness * s.half_spacing * s.half_spacing * roll +
                     rolling_radius_ * forces_.normal_force.y() + forces_.creep_moment.x();
  return request;
}

Motion WheelsetDynamics::trialAt(const Eigen::Vector3d& velocities) const
{
  Motion trial = motion_;
  trial.y_rate = velocities.x();
  trial.yaw_rate = velocities.y();
  trial.spin = velocities.z();
  trial.yaw += step_ * velocities.y();
  return trial;
}

Eigen::Vector3d WheelsetDynamics::accelerations(const ContactReply& contact, const Motion& trial,
                                                RailForces& forces) const
{
  const SuspensionParameters& s = parameters_.suspension;
  const WheelsetParameters& w = parameters_.wheelset;
  forces = railForces(contact, trial, parameters_.run.speed, law_);
  const double lateral =
      forces.force().y() - 2 * s.lateral_stiffness * motion_.y - 2 * s.lateral_damping * trial.y_rate;
  const double spring_moment = s.longitudinal_stiffness * motion_.yaw + s.longitudinal_damping * trial.yaw_rate;
  const double yaw_moment = forces.moment().z() - 2 * s.half_spacing * s.half_spacing * spring_moment;
  return {lateral / w.mass, yaw_moment / w.yaw_inertia, forces.spin_moment / w.spin_inertia};
}

void WheelsetDynamics::advance(const ContactReply& contact)
{
  const double speed = parameters_.run.speed;
  // Velocities at the circumference have one scale.
  const Eigen::Vector3d scale(1, 1, rolling_radius_);
  const Eigen::Vector3d old(motion_.y_rate, motion_.yaw_rate, motion_.spin);
  const auto residual = [&](const Eigen::Vector3d& v, RailForces& forces) -> Eigen::Vector3d
  { return v - old - step_ * accelerations(contact, trialAt(v), forces); };
  Eigen::Vector3d velocities = old;
  for (int i = 0; i < most_iterations; ++i)
  {
    const Eigen::Vector3d value = residual(velocities, forces_);
    Eigen::Matrix3d derivatives;
    RailForces ignored;
    for (int k = 0; k < 3; ++k)
    {
      const double h = difference * speed / scale[k];
      derivatives.col(k) = (residual(velocities + h * Eigen::Vector3d::Unit(k), ignored) - value) / h;
    }
    const Eigen::Vector3d change = -derivatives.partialPivLu().solve(value);
    velocities += change;
    if (change.cwiseProduct(scale).norm() <= tolerance * speed)
    {
      motion_ = trialAt(velocities);
      motion_.y += step_ * velocities.x();
      return;
    }
  }
  throw std::runtime_error("the velocities of the wheelset do not converge in a step of " + std::to_string(step_) +
                           " s");
}
}  // namespace simulate_wheelset
