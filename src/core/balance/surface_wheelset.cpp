// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/surface_wheelset.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double greatest_step = 2e-3;     ///< of the roll [rad]
constexpr double tread_slope = -1.5;       ///< change of the height difference per roll on the tread [m/rad]
constexpr double flattest_slope = -0.1;    ///< limit of the slope in a step [m/rad]
constexpr double height_tolerance = 1e-3;  ///< remaining difference of the heights, over the smaller overlap [-]
constexpr double finest_bracket = 1e-9;    ///< width at which a bracket without a zero ends the search [rad]
constexpr int most_rolls = 60;             ///< bisection alone needs fewer

SurfaceContact wheelOn(const ContactModelConfig& config, NormalSolver& solver, const SurfaceContactOptions& options)
{
  return {*config.wheel_profile,
          config.wheelset,
          PlacedRail(config.rail_profile, config.track),
          contactModulus(config.wheel_material, config.rail_material),
          solver,
          options};
}
}  // namespace

SurfaceWheelset::SurfaceWheelset(const ContactModelConfig& config, NormalSolver& solver,
                                 const SurfaceContactOptions& options)
    : config_(config), wheels_{wheelOn(config, solver, options), wheelOn(config, solver, options)}
{
}

/// Finds the heights of both wheels under their loads, and the height of the left one minus that of the right one.
SolveStatus SurfaceWheelset::heightsAt(const WheelsetState& state, double roll, double& difference)
{
  SolveStatus worst = SolveStatus::converged;
  for (const Side side : {Side::left, Side::right})
  {
    const auto k = static_cast<std::size_t>(side);
    const double load = -0.5 * state.force_z - sideSign(side) * state.torque_x / (2 * config_.wheelset.halfBase());
    const SolveStatus status = wheels_[k].solveLoad(toSide(side, {state.y, heights_[k], state.yaw, roll}), load);
    solutions_ += wheels_[k].solutions();
    heights_[k] = wheels_[k].height();
    worst = isUsable(status) ? worst : status;
  }
  difference = heights_[0] - heights_[1];
  return worst;
}

SolveStatus SurfaceWheelset::solve(const WheelsetState& state, double start_z, double start_roll)
{
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  double slope = tread_slope, last_roll = 0, last_difference = 0;
  heights_.fill(start_z);
  roll_ = start_roll;
  solutions_ = 0;
  for (int i = 0; i < most_rolls; ++i)
  {
    double difference = 0;
    const SolveStatus status = heightsAt(state, roll_, difference);
    z_ = 0.5 * (heights_[0] + heights_[1]);
    const double overlap = std::min(wheels_[0].overlap(), wheels_[1].overlap());
    if (!isUsable(status) || std::abs(difference) <= height_tolerance * overlap || most - least < finest_bracket)
    {
      return status;
    }
    (difference > 0 ? least : most) = roll_;
    if (i > 0)
    {
      slope = std::min((difference - last_difference) / (roll_ - last_roll), flattest_slope);
    }
    last_roll = roll_;
    last_difference = difference;
    roll_ -= std::clamp(difference / slope, -greatest_step, greatest_step);
    if (!(roll_ > least && roll_ < most))
    {
      roll_ = 0.5 * (least + most);
    }
  }
  return SolveStatus::iteration_limit;
}
}  // namespace wheel_rail_contact::core
