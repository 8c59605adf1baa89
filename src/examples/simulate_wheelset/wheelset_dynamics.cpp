// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/wheelset_dynamics.h"

#include <Eigen/LU>
#include <stdexcept>
#include <string>

namespace simulate_wheelset
{
namespace
{
constexpr int most_iterations = 50;
constexpr double tolerance = 1e-11;  ///< of the velocities at the circumference of the wheels, over the running speed
constexpr double difference = 1e-7;  ///< for the derivatives, of the same velocities
}  // namespace

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
