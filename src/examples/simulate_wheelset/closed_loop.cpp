// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/closed_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace simulate_wheelset
{
namespace core = wheel_rail_contact::core;

namespace
{
using Clock = std::chrono::steady_clock;

constexpr double saturated_share = 0.99;  ///< of the friction limit, from which a contact counts as saturated

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

bool isSaturated(const core::PatchResult& patch)
{
  return patch.creep.adhesion_share >= saturated_share;
}

constexpr int digits = 9;

/// Forces of one wheel.
struct Wheel
{
  double normal_force = 0;          ///< sum [N]
  double radius = 0;                ///< mean rolling radius, weighted with the normal forces [m]
  double creep_x = 0, creep_y = 0;  ///< friction on the wheel along x and y of the track [N]
  double adhesion_share = 0;        ///< largest of the contacts [-]
  bool is_saturated = false;        ///< whether the friction of a contact is at its limit
};

Wheel wheelOf(core::Side side, const ContactReply& contact)
{
  Wheel wheel;
  for (const core::PatchResult& patch : contact.patches)
  {
    if (patch.side == side)
    {
      wheel.normal_force += patch.normal_force;
      wheel.radius += patch.normal_force * patch.rolling_radius;
      wheel.creep_x += patch.creep.force.x;
      wheel.creep_y += patch.creep.force.y * std::cos(patch.pose.angle);
      wheel.adhesion_share = std::max(wheel.adhesion_share, patch.creep.adhesion_share);
      wheel.is_saturated = wheel.is_saturated || isSaturated(patch);
    }
  }
  wheel.radius = wheel.normal_force > 0 ? wheel.radius / wheel.normal_force : std::nan("");
  return wheel;
}

double frictionPower(const ContactReply& contact)
{
  return std::accumulate(contact.patches.begin(), contact.patches.end(), 0.0,
                         [](double sum, const core::PatchResult& patch) { return sum + patch.creep.power; });
}
}  // namespace

void Waves::add(double distance, double y, const ContactReply& contact)
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
    begun_.drag -= contact.rail_wrench.force.x();
    begun_.friction_power += simulate_wheelset::frictionPower(contact);
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
  stream_ << "time [s],distance [m],y [m],yaw [rad],y_rate [m/s],yaw_rate [rad/s],rotation [rad/s],z [m],roll [rad],"
             "force_z [N],torque_x [N m],lateral_force [N],yaw_moment [N m],friction_power [W]";
  for (const char* side : {"left", "right"})
  {
    stream_ << ',' << side << "_normal_force [N]," << side << "_rolling_radius [m]," << side << "_creep_x [N]," << side
            << "_creep_y [N]," << side << "_adhesion_share [-]," << side << "_saturated [-]";
  }
  stream_ << ",held [-]\n";
  check();
}

void MotionTable::add(const ContactRequest& request, const ContactReply& contact, bool is_held)
{
  const core::WheelsetState& state = request.state;
  stream_ << 1e-9 * static_cast<double>(request.time);
  for (const double value : {state.distance, state.y, state.yaw, state.motion.lateral_velocity, state.motion.yaw_rate,
                             contact.rotation, contact.z, contact.roll, state.force_z, state.torque_x,
                             contact.rail_wrench.force.y(), contact.rail_wrench.moment.z(), frictionPower(contact)})
  {
    stream_ << ',' << value;
  }
  for (const core::Side side : core::sides)
  {
    const Wheel wheel = wheelOf(side, contact);
    stream_ << ',' << wheel.normal_force << ',' << wheel.radius << ',' << wheel.creep_x << ',' << wheel.creep_y << ','
            << wheel.adhesion_share << ',' << (wheel.is_saturated ? 1 : 0);
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
  WheelsetDynamics dynamics(parameters);
  HeldContact held(source, static_cast<int>(parameters.run.held_steps));
  const int steps = parameters.run.steps();
  for (; summary.steps < steps; ++summary.steps)
  {
    const Clock::time_point begin = Clock::now();
    const ContactRequest request = dynamics.request();
    const ContactReply& contact = dynamics.advance(held);
    summary.times.add(secondsSince(begin));
    summary.saturated += std::any_of(contact.patches.begin(), contact.patches.end(), isSaturated) ? 1 : 0;
    if (3 * summary.steps >= 2 * steps)
    {
      summary.waves.add(request.state.distance, request.state.y, contact);
    }
    if (table != nullptr)
    {
      table->add(request, contact, held.isHeld());
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
