// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/load_transfer.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
constexpr int most_corrections = 5;  ///< a bracket or a step is seldom wrong twice
}  // namespace

void LoadTransfer::begin(double load, double torque, double levers, double lever_difference)
{
  half_load_ = 0.5 * load;
  corrections_ = 0;
  widen();
  transfer_ = within(levers > 0 ? (torque + lever_difference * half_load_) / levers : 0);
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

/// The transfer that closes the open moment, by a secant or by the lever arms.
double LoadTransfer::next(double levers) const
{
  const double secant = has_before_ ? (open_ - open_before_) / (transfer_ - before_) : 0;
  const double slope = secant < 0 ? secant : -levers;
  const double step = within(slope < 0 ? transfer_ - open_ / slope : open_ > 0 ? half_load_ : -half_load_);
  const bool is_new = step >= least_ && step <= most_ && step != transfer_ && step != before_;
  return is_new ? step : 0.5 * (least_ + most_);
}

void LoadTransfer::moveTo(double transfer)
{
  before_ = transfer_;
  open_before_ = open_;
  has_before_ = true;
  transfer_ = transfer;
}

LoadTransfer::Step LoadTransfer::advance(double open, double levers, double accuracy, double acceptable)
{
  open_ = open;
  lifts_ = std::abs(transfer_) >= half_load_ && open * transfer_ >= 0;
  if (lifts_)
  {
    return Step::closed;
  }
  (open > 0 ? least_ : most_) = transfer_;
  double to = next(levers);
  if (std::abs(to - transfer_) <= accuracy)
  {
    if (std::abs(open) <= acceptable)
    {
      return Step::closed;
    }
    if (++corrections_ > most_corrections)
    {
      return Step::failed;
    }
    widen();
    (open > 0 ? least_ : most_) = transfer_;
    to = next(levers);
  }
  moveTo(to);
  return Step::moved;
}

LoadTransfer::Step LoadTransfer::retreat()
{
  if (!has_before_ || ++corrections_ > most_corrections)
  {
    return Step::failed;
  }
  transfer_ = 0.5 * (transfer_ + before_);
  return Step::moved;
}
}  // namespace wheel_rail_contact::core
