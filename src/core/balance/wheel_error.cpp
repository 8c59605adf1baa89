// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheel_error.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
void WheelError::add(const ContactMeasures& patch, const ErrorEstimate& error)
{
  const double height = patch.max_pressure / wheel_.max_pressure;
  pressure_ = std::max(pressure_, height - 1 + error.max_pressure * height);
  area_ += error.area * patch.area / wheel_.area;
  approach_ += error.approach * patch.force / wheel_.force;
}

double WheelError::largest() const
{
  return std::max({pressure_, area_, approach_});
}
}  // namespace wheel_rail_contact::core
