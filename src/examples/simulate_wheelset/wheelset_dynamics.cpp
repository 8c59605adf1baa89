// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/wheelset_dynamics.h"

#include <Eigen/LU>
#include <stdexcept>
#include <utility>

namespace simulate_wheelset
{
constexpr int most_iterations = 20;
constexpr double tolerance = 1e-6;   ///< of the velocities of y, and of yaw at 1 m, over the running speed
constexpr double difference = 1e-5;  ///< for the derivatives, of the same velocities
constexpr double slow = 0.3;         ///< share that is left of a change, from which the derivatives are renewed
/// Iterations after which changes that point back are halved: where a contact takes another grid of cells, the force
/// jumps, and the step ends at the jump.
constexpr int newton_iterations = 4;
constexpr double half_distance = 0.75;  ///< of the rails [m], for the roll by the line

const ContactReply& HeldContact::evaluate(const ContactRequest& request)
{
  ContactReply reply = source_.evaluate(request);
  if (isUsable(reply.status))
  {
    in_a_row_ = 0;
    last_ = std::move(reply);
    return last_;
  }
  ++in_a_row_;
  if (!isUsable(last_.status) || in_a_row_ > most_)
  {
    throw std::runtime_error("no usable contact in " + std::to_string(in_a_row_) + " successive steps, at " +
                             std::to_string(1e-9 * static_cast<double>(request.time)) +
                             " s, y = " + std::to_string(1e3 * request.state.y) + " mm: " + nameOf(reply.status) +
                             (reply.reason.empty() ? "" : ": ") + reply.reason);
  }
  ++held_;
  return last_;
}

const ContactReply& HeldContact::evaluateAgain(const ContactRequest& request)
{
  if (ContactReply reply = isHeld() ? ContactReply() : source_.evaluate(request); isUsable(reply.status))
  {
    last_ = std::move(reply);
  }
  return last_;
}

WheelsetDynamics::WheelsetDynamics(const Parameters& parameters)
    : parameters_(parameters), step_(1e-9 * static_cast<double>(parameters.run.stepNanoseconds()))
{
  motion_.y = parameters.run.y;
  motion_.yaw = parameters.run.yaw;
  line_.fill(Eigen::Vector2d::Zero());
}

ContactRequest WheelsetDynamics::request() const
{
  ContactRequest request = requestAt({motion_.y_rate, motion_.yaw_rate});
  request.state.yaw = motion_.yaw;
  return request;
}

/// State of the contact in a step with these new velocities: the yaw is that at its end.
ContactRequest WheelsetDynamics::requestAt(const Eigen::Vector2d& velocities) const
{
  const SuspensionParameters& s = parameters_.suspension;
  const WheelsetParameters& w = parameters_.wheelset;
  const Eigen::Vector2d line_acceleration = (line_[0] - 2 * line_[1] + line_[2]) / (step_ * step_);
  ContactRequest request;
  request.time = steps_ * parameters_.run.stepNanoseconds();
  request.state.distance = parameters_.run.start + parameters_.run.speed * 1e-9 * static_cast<double>(request.time);
  request.state.motion.speed = parameters_.run.speed;
  request.state.y = motion_.y;
  request.state.motion.lateral_velocity = velocities.x();
  request.state.yaw = motion_.yaw + step_ * velocities.y();
  request.state.motion.yaw_rate = velocities.y();
  request.state.force_z = -w.axle_load - w.line_inertia * w.mass * line_acceleration.x();
  request.state.torque_x = -2 * s.vertical_stiffness * s.half_spacing * s.half_spacing * roll_ -
                           w.line_inertia * w.yaw_inertia * line_acceleration.y() +
                           w.gyroscopic * w.spin_inertia * rotation_ * velocities.y();
  return request;
}

/// Velocities after the step, less `velocities`.
Eigen::Vector2d WheelsetDynamics::residual(const Eigen::Vector2d& velocities, const ContactReply& contact) const
{
  const SuspensionParameters& s = parameters_.suspension;
  const WheelsetParameters& w = parameters_.wheelset;
  const double lateral =
      contact.rail_wrench.force.y() - 2 * s.lateral_stiffness * motion_.y - 2 * s.lateral_damping * velocities.x();
  const double spring_moment = s.longitudinal_stiffness * motion_.yaw + s.longitudinal_damping * velocities.y();
  const double yaw_moment = contact.rail_wrench.moment.z() - 2 * s.half_spacing * s.half_spacing * spring_moment -
                            w.gyroscopic * w.spin_inertia * rotation_ * roll_rate_;
  return Eigen::Vector2d(motion_.y_rate, motion_.yaw_rate) +
         step_ * Eigen::Vector2d(lateral / w.mass, yaw_moment / w.yaw_inertia) - velocities;
}

void WheelsetDynamics::differentiate(const Eigen::Vector2d& velocities, const Eigen::Vector2d& value,
                                     HeldContact& contact)
{
  const double h = difference * parameters_.run.speed;
  Eigen::Matrix2d derivatives;
  for (int k = 0; k < 2; ++k)
  {
    const Eigen::Vector2d shifted = velocities + h * Eigen::Vector2d::Unit(k);
    derivatives.col(k) = (residual(shifted, contact.evaluateAgain(requestAt(shifted))) - value) / h;
  }
  correction_ = -derivatives.inverse();
}

const ContactReply& WheelsetDynamics::advance(HeldContact& contact)
{
  const double least = tolerance * parameters_.run.speed;
  Eigen::Vector2d velocities = Eigen::Vector2d(motion_.y_rate, motion_.yaw_rate) + change_;
  const ContactReply* reply = &contact.evaluate(requestAt(velocities));
  const double left = reply->rail.left.given.vertical, right = reply->rail.right.given.vertical;
  addLine({0.5 * (left + right), 0.5 * (left - right) / half_distance});
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  double share = 1;
  for (int i = 0; i < most_iterations; ++i)
  {
    const Eigen::Vector2d value = residual(velocities, *reply);
    Eigen::Vector2d change = share * correction_ * value;
    if (change.norm() <= least)
    {
      finish(velocities + change, *reply);
      return *reply;
    }
    if (i > 0 ? change.norm() > slow * last.norm() : steps_ == 0)
    {
      differentiate(velocities, value, contact);
      share *= i >= newton_iterations && change.dot(last) < 0 ? 0.5 : 1;
      change = share * correction_ * value;
    }
    velocities += change;
    last = change;
    reply = &contact.evaluateAgain(requestAt(velocities));
  }
  throw std::runtime_error("the velocities of the wheelset do not converge in a step of " + std::to_string(step_) +
                           " s");
}

void WheelsetDynamics::addLine(const Eigen::Vector2d& height_and_roll)
{
  const Eigen::Vector2d last = steps_ > 0 ? line_[0] : height_and_roll;
  // Before the start the line is straight.
  line_ = {height_and_roll, last, steps_ > 1 ? line_[1] : 2 * last - height_and_roll};
}

void WheelsetDynamics::finish(const Eigen::Vector2d& velocities, const ContactReply& contact)
{
  change_ = velocities - Eigen::Vector2d(motion_.y_rate, motion_.yaw_rate);
  motion_ = {motion_.y + step_ * velocities.x(), motion_.yaw + step_ * velocities.y(), velocities.x(), velocities.y()};
  roll_rate_ = steps_ > 0 ? (contact.roll - roll_) / step_ : 0;
  roll_ = contact.roll;
  rotation_ = contact.rotation;
  ++steps_;
}
}  // namespace simulate_wheelset
