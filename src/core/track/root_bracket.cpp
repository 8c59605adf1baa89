// SPDX-License-Identifier: BSD-3-Clause
#include "core/track/root_bracket.h"

namespace wheel_rail_contact::core
{
void RootBracket::add(double x, double value)
{
  if (value == 0)
  {
    return;
  }
  slow_ = std::abs(value) > 0.5 * last_ ? slow_ + 1 : 0;
  last_ = std::abs(value);
  const bool is_least = value > 0;
  double &here = is_least ? at_least_ : at_most_, &other = is_least ? at_most_ : at_least_;
  if (here != 0)
  {
    other *= 0.5;
  }
  here = value;
  (is_least ? least_ : most_) = x;
}

double RootBracket::next(double x, double step) const
{
  const double newton = x + step;
  if (!std::isfinite(width()))
  {
    return contains(newton) ? newton : 0.5 * (x + (newton > least_ ? most_ : least_));
  }
  if (slow_ == 0 && contains(newton))
  {
    return newton;
  }
  const double chord = least_ + width() * at_least_ / (at_least_ - at_most_);
  return slow_ < 2 && contains(chord) ? chord : 0.5 * (least_ + most_);
}
}  // namespace wheel_rail_contact::core
