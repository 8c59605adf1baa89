// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/load_transfer.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
void LoadTransfer::begin(double load, double torque, double levers, double uneven)
{
  half_load_ = 0.5 * load;
  widen();
  transfer_ = within(levers > 0 ? (torque + uneven * half_load_) / levers : 0);
}

void LoadTransfer::widen()
{
  least_ = -half_load_;
  most_ = half_load_;
  has_before_ = lifts_ = false;
}

double LoadTransfer::within(double transfer) const
{
  return std::clamp(transfer, -half_load_, half_load_);
}

double LoadTransfer::improve(double open, double levers)
{
  const double here = transfer_;
  lifts_ = std::abs(here) >= half_load_ && open * here >= 0;
  if (lifts_)
  {
    return 0;
  }
  (open > 0 ? least_ : most_) = here;
  const double secant = has_before_ ? (open - open_before_) / (here - before_) : 0;
  const double slope = secant < 0 ? secant : -levers;
  double next = slope < 0 ? within(here - open / slope) : (open > 0 ? half_load_ : -half_load_);
  if (!(next >= least_ && next <= most_) || next == before_)
  {
    next = 0.5 * (least_ + most_);
  }
  before_ = here;
  open_before_ = open;
  has_before_ = true;
  transfer_ = next;
  return next - here;
}
}  // namespace wheel_rail_contact::core
