// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
/// @throw Error if there is a fault. Only then are the parts of the reason joined.
template <typename Error = std::invalid_argument, typename... Parts>
void refuseIf(bool fault, const Parts&... parts)
{
  if (fault)
  {
    std::ostringstream reason;
    (reason << ... << parts);
    throw Error(reason.str());
  }
}
/// @throw std::invalid_argument "option = value text" unless `rule` is true.
void require(bool rule, const std::string& option, double value, const char* text);
/// Same unless `value` is finite and above zero.
void requirePositive(const std::string& option, double value);
/// Same unless the absolute value is at most `limit`.
void requireWithin(const std::string& option, double value, double limit, const char* text);

/// Range of a length [m].
struct LengthRange
{
  double least, most;
};
/// Same unless `value` is in the range. The message gives the unit, because lengths are often given in millimetres.
void requireLength(const std::string& option, double value, const LengthRange& range);

/// True if both values are equal, or if neither of them is equal to itself (NaN).
template <typename Value>
bool areSame(const Value& a, const Value& b)
{
  const auto equal = [](const Value& one, const Value& other) { return one == other; };
  return equal(a, b) || !(equal(a, a) || equal(b, b));
}

/// Name of an option of a side in messages: that for both sides if their values are the same, otherwise
/// body/left|right/option.
template <typename Value>
std::string optionOf(const Sides<Value>& values, Side side, const char* both, const char* body, const char* option)
{
  return areSame(values.left, values.right) ? both : std::string(body) + '/' + nameOf(side) + '/' + option;
}
}  // namespace wheel_rail_contact::core
