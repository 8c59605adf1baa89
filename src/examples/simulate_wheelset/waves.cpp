// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/waves.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace simulate_wheelset
{
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
}  // namespace simulate_wheelset
