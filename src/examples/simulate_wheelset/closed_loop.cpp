// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/closed_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "wheel_rail_contact/core/creep.h"

namespace simulate_wheelset
{
namespace
{
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void count(const ContactReply& contact, const RailForces& forces, RunSummary& summary)
{
  const auto is_saturated = [](const CreepForce& force) { return force.isSaturated(); };
  const auto is_outside = [](const ContactPoint& point)
  {
    const double ratio = point.semi_axis_along / point.semi_axis_across;
    return std::max(ratio, 1 / ratio) > wheel_rail_contact::core::kalker_ratio_limit;
  };
  summary.saturated += std::any_of(forces.creep.begin(), forces.creep.end(), is_saturated) ? 1 : 0;
  summary.outside_table += std::any_of(contact.points.begin(), contact.points.end(), is_outside) ? 1 : 0;
  ++summary.steps;
}

constexpr int digits = 9;

/// Forces of one wheel.
struct Wheel
{
  double normal_force = 0;          ///< sum [N]
  double radius = 0;                ///< mean rolling radius, weighted with the normal forces [m]
  double creep_x = 0, creep_y = 0;  ///< creep force on the wheel along x and y of the track [N]
  double demand = 0;                ///< largest of the contacts [-]
  bool is_saturated = false;        ///< whether the creep force of a contact is at the friction limit
};

Wheel wheelOf(bool is_left, const ContactReply& contact, const RailForces& forces)
{
  Wheel wheel;
  for (std::size_t i = 0; i < contact.points.size(); ++i)
  {
    const ContactPoint& point = contact.points[i];
    if (point.is_left == is_left)
    {
      wheel.normal_force += point.normal_force;
      wheel.radius += point.normal_force * point.rolling_radius;
      wheel.creep_x += forces.creep[i].along;
      wheel.creep_y += forces.creep[i].across * std::cos(point.angle);
      wheel.demand = std::max(wheel.demand, forces.creep[i].demand);
      wheel.is_saturated = wheel.is_saturated || forces.creep[i].isSaturated();
    }
  }
  wheel.radius = wheel.normal_force > 0 ? wheel.radius / wheel.normal_force : std::nan("");
  return wheel;
}
}  // namespace

const ContactReply& HeldContact::evaluate(const ContactRequest& request)
{
  ContactReply reply = source_.evaluate(request);
  if (reply.is_usable)
  {
    in_a_row_ = 0;
    last_ = std::move(reply);
    return last_;
  }
  ++in_a_row_;
  if (!last_.is_usable || in_a_row_ > most_)
  {
    throw std::runtime_error("no usable contact in " + std::to_string(in_a_row_) + " successive steps, at " +
                             std::to_string(1e-9 * static_cast<double>(request.time)) +
                             " s, y = " + std::to_string(1e3 * request.y) + " mm: " + reply.status);
  }
  ++held_;
  return last_;
}

void Waves::add(double distance, double y, const RailForces& forces)
{
  if (has_last_ && last_y_ < 0 && y >= 0)
  {
    last_crossing_ = distance - (distance - last_distance_) * y / (y - last_y_);
    count_ += first_crossing_ ? 1 : 0;
    first_crossing_ = first_crossing_.value_or(last_crossing_);
    whole_ = begun_;
  }
  if (first_crossing_)
  {
    ++begun_.steps;
    begun_.drag -= forces.creep_force.x();
    begun_.friction_power += forces.friction_power;
  }
  has_last_ = true;
  last_distance_ = distance;
  last_y_ = y;
  largest_y_ = std::max(largest_y_, std::abs(y));
}

double Waves::wavelength() const
{
  return count_ > 0 ? (last_crossing_ - *first_crossing_) / count_ : 0;
}

double Waves::drag() const
{
  return count_ > 0 ? whole_.drag / whole_.steps : 0;
}

double Waves::frictionPower() const
{
  return count_ > 0 ? whole_.friction_power / whole_.steps : 0;
}

std::string Waves::text(double speed) const
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << "largest |y| " << 1e3 * largest_y_ << " mm, ";
  if (count_ == 0)
  {
    text << "no whole wave";
    return text.str();
  }
  text << "wavelength " << wavelength() << " m, drag " << drag() << " N = " << 1e-3 * speed * drag() << " kW, friction "
       << 1e-3 * frictionPower() << " kW";
  return text.str();
}

MotionTable::MotionTable(const std::string& file) : file_(file), stream_(file)
{
  stream_.precision(digits);
  stream_ << "time [s],distance [m],y [m],yaw [rad],y_rate [m/s],yaw_rate [rad/s],spin [rad/s],z [m],roll [rad],"
             "force_z [N],torque_x [N m],normal_force_y [N],creep_force_y [N],yaw_moment [N m],friction_power [W]";
  for (const char* side : {"left", "right"})
  {
    stream_ << ',' << side << "_normal_force [N]," << side << "_rolling_radius [m]," << side << "_creep_x [N]," << side
            << "_creep_y [N]," << side << "_demand [-]," << side << "_saturated [-]";
  }
  stream_ << ",held [-]\n";
  check();
}

void MotionTable::add(const ContactRequest& request, const Motion& motion, const ContactReply& contact,
                      const RailForces& forces, bool is_held)
{
  stream_ << 1e-9 * static_cast<double>(request.time);
  for (const double value : {request.distance, motion.y, motion.yaw, motion.y_rate, motion.yaw_rate, motion.spin,
                             contact.z, contact.roll, request.force_z, request.torque_x, forces.normal_force.y(),
                             forces.creep_force.y(), forces.moment().z(), forces.friction_power})
  {
    stream_ << ',' << value;
  }
  for (const bool is_left : {true, false})
  {
    const Wheel wheel = wheelOf(is_left, contact, forces);
    stream_ << ',' << wheel.normal_force << ',' << wheel.radius << ',' << wheel.creep_x << ',' << wheel.creep_y << ','
            << wheel.demand << ',' << (wheel.is_saturated ? 1 : 0);
  }
  stream_ << ',' << (is_held ? 1 : 0) << '\n';
  check();
}

void MotionTable::close()
{
  stream_.close();
  check();
}

void MotionTable::check()
{
  if (!stream_)
  {
    throw std::runtime_error(file_ + ": cannot be written");
  }
}

RunSummary runClosedLoop(const Parameters& parameters, ContactSource& source, MotionTable* table)
{
  RunSummary summary;
  WheelsetDynamics dynamics(parameters, source.rollingRadius());
  HeldContact held(source, static_cast<int>(parameters.run.held_steps));
  const std::int64_t step = parameters.run.stepNanoseconds();
  const int steps = parameters.run.steps();
  double roll = 0;
  for (int i = 0; i < steps; ++i)
  {
    const Clock::time_point begin = Clock::now();
    const Motion motion = dynamics.motion();
    const ContactRequest request = dynamics.request(i * step, roll);
    const ContactReply& contact = held.evaluate(request);
    roll = contact.roll;
    dynamics.advance(contact);
    summary.times.add(secondsSince(begin));
    count(contact, dynamics.forces(), summary);
    if (3 * i >= 2 * steps)
    {
      summary.waves.add(request.distance, motion.y, dynamics.forces());
    }
    if (table != nullptr)
    {
      table->add(request, motion, contact, dynamics.forces(), held.isHeld());
    }
  }
  summary.held = held.held();
  return summary;
}

std::string StepTimes::text() const
{
  if (seconds_.empty())
  {
    return "";
  }
  std::vector<double> sorted = seconds_;
  std::sort(sorted.begin(), sorted.end());
  const auto quantile = [&](double share)
  { return 1e3 * sorted[static_cast<std::size_t>(std::lround(share * static_cast<double>(sorted.size() - 1)))]; };
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << static_cast<double>(sorted.size()) / sum << " steps/s; step: median "
       << std::setprecision(3) << quantile(0.5) << " ms, 95 % " << quantile(0.95) << " ms, longest " << quantile(1)
       << " ms";
  return text.str();
}
}  // namespace simulate_wheelset
