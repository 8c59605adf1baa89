// SPDX-License-Identifier: BSD-3-Clause
#include "core/option_check.h"

#include <cmath>
#include <sstream>

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

void requireLength(const std::string& option, double value, const LengthRange& range)
{
  std::ostringstream rule;
  rule << "must be from " << range.least << " to " << range.most << ", in metres";
  require(value >= range.least && value <= range.most, option, value, rule.str().c_str());
}
}  // namespace wheel_rail_contact::core
