// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheel_loads.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/track/placement.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double least_load = 0.1;  ///< smaller wheel loads are taken as zero: no overlap resolves them [N]
}  // namespace

WheelLoads::WheelLoads(const WheelsetConfig& wheelset, const WheelsetState& state)
    : by_moments_(wheelset.balance == WheelsetConfig::Balance::moments),
      half_(-0.5 * state.force_z),
      torque_(state.torque_x),
      half_base_(wheelset.halfBase())
{
}

bool WheelLoads::balances() const
{
  return by_moments_ && sum() > least_load;
}

Sides<double> WheelLoads::with(double transfer) const
{
  const double most = by_moments_ ? std::max(half_, 0.0) : infinity;
  return Sides<double>(
      [&](Side side)
      {
        const double load = half_ - sideSign(side) * std::clamp(transfer, -most, most);
        return load > least_load ? load : 0;
      });
}

Sides<double> WheelLoads::with(Side side, double load) const
{
  return with(sideSign(side) * (half_ - load));
}

Sides<double> WheelLoads::changed(const Sides<double>& loads, double transfer) const
{
  const Side lighter = loads.left < loads.right ? Side::left : Side::right;
  const double overlap = 1 - sideSign(lighter) * overlap_per_load * transfer / loads[lighter];
  return with(lighter, overlap > 0 ? std::min(loads[lighter] * std::pow(overlap, 1 / overlap_per_load), sum()) : 0);
}

bool WheelLoads::returnWheel(const Sides<double>& loads, const Sides<double>& moments, double share) const
{
  const double returning = -sideSign(lifted(loads)) * openMoment(moments) / (2 * half_base_);  // [N]
  return areLifted(loads) && returning > std::max(least_load, share * sum());
}
}  // namespace wheel_rail_contact::core
