// SPDX-License-Identifier: BSD-3-Clause
#include "core/option_check.h"

#include <cmath>
#include <stdexcept>

namespace wheel_rail_contact::core
{
void require(bool rule, const std::string& option, double value, const char* text)
{
  if (!rule)
  {
    throw std::invalid_argument(option + " = " + std::to_string(value) + " " + text);
  }
}

void requirePositive(const std::string& option, double value)
{
  require(std::isfinite(value) && value > 0, option, value, "must be a positive number");
}

void requireWithin(const std::string& option, double value, double limit, const char* text)
{
  require(std::abs(value) <= limit, option, value, text);
}
}  // namespace wheel_rail_contact::core
