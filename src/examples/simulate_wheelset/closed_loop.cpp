// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/closed_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"

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
  { return !KalkerTable::contains(point.semi_axis_along / point.semi_axis_across); };
  summary.saturated += std::any_of(forces.creep.begin(), forces.creep.end(), is_saturated) ? 1 : 0;
  summary.outside_table += std::any_of(contact.points.begin(), contact.points.end(), is_outside) ? 1 : 0;
  ++summary.steps;
}
}  // namespace

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
