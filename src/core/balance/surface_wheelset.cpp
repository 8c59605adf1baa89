// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/surface_wheelset.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double greatest_step = 2e-3;     ///< of the roll in a pass [rad]
constexpr double flattest_slope = -0.1;    ///< limit of the slope of the height difference [m/rad]
constexpr double open_limit = 0.02;        ///< remaining approach of a wheel at the end, over its overlap [-]
constexpr double difference_limit = 0.01;  ///< difference of the heights at the end, over the smaller overlap [-]
constexpr double uncertain_share = 0.2;  ///< error of the difference, over the sum of (remaining approach)²/overlap [-]
constexpr double finest_bracket = 1e-9;  ///< width at which a bracket without a zero ends the search [rad]
constexpr int most_passes = 80;          ///< bisection alone needs fewer

SurfaceContact wheelOn(const ContactModelConfig& config, ConjugateGradients& solver,
                       const SurfaceContactOptions& options)
{
  return {*config.wheel_profile,
          config.wheelset,
          PlacedRail(config.rail_profile, config.track),
          contactModulus(config.wheel_material, config.rail_material),
          solver,
          options};
}
}  // namespace

SurfaceWheelset::SurfaceWheelset(const ContactModelConfig& config, ConjugateGradients& solver,
                                 const SurfaceContactOptions& options)
    : config_(config), wheels_{wheelOn(config, solver, options), wheelOn(config, solver, options)}
{
}

/// One pass of both wheels at a roll.
SolveStatus SurfaceWheelset::pass(const WheelsetState& state)
{
  const double transfer = 0.5 * state.torque_x / config_.wheelset.halfBase();
  for (const Side side : {Side::left, Side::right})
  {
    const auto k = static_cast<std::size_t>(side);
    const double load = -0.5 * state.force_z - sideSign(side) * transfer;
    const SolveStatus status = wheels_[k].pass(toSide(side, {state.y, heights_[k], state.yaw, roll_}), load);
    ++solutions_;
    if (!isUsable(status))
    {
      return status;
    }
    heights_[k] = wheels_[k].height();
    slopes_[k] = sideSign(side) * wheels_[k].heightPerRoll();
  }
  return SolveStatus::converged;
}

SolveStatus SurfaceWheelset::solve(const WheelsetState& state, double start_z, double start_roll)
{
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  heights_.fill(start_z);
  roll_ = start_roll;
  solutions_ = 0;
  for (int i = 0; i < most_passes; ++i)
  {
    const SolveStatus status = pass(state);
    if (!isUsable(status))
    {
      return status;
    }
    double uncertain = 0, open = 0, overlap = std::numeric_limits<double>::infinity();
    for (const SurfaceContact& wheel : wheels_)
    {
      uncertain += wheel.remaining() * wheel.remaining() / wheel.overlap();
      open = std::max(open, std::abs(wheel.remaining()) / wheel.overlap());
      overlap = std::min(overlap, wheel.overlap());
    }
    const double difference = heights_[0] - heights_[1];
    const double slope = std::min(slopes_[0] - slopes_[1], flattest_slope);
    if (std::abs(difference) > uncertain_share * uncertain)
    {
      (difference > 0 ? least : most) = roll_;
    }
    const double step = std::clamp(-difference / slope, -greatest_step, greatest_step);
    const bool settled = open <= open_limit && std::abs(difference) <= difference_limit * overlap;
    double next = roll_ + step;
    if (!settled && !(next > least && next < most))
    {
      const double crossed = next > least ? most : least;
      const bool bracketed = std::isfinite(least) && std::isfinite(most);
      next = 0.5 * (bracketed ? least + most : roll_ + crossed);
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
      heights_[k] += slopes_[k] * (next - roll_);
    }
    roll_ = next;
    z_ = 0.5 * (heights_[0] + heights_[1]);
    if (settled)
    {
      return status;
    }
    if (most - least < finest_bracket)  // the heights jump past one another
    {
      return SolveStatus::stalled;
    }
  }
  return SolveStatus::iteration_limit;
}
}  // namespace wheel_rail_contact::core
