// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wheel_rail_contact::core
{
/// @throw std::invalid_argument "option = value text" unless `rule` is true.
void require(bool rule, const std::string& option, double value, const char* text);
/// Same unless `value` is finite and above zero.
void requirePositive(const std::string& option, double value);
/// Same unless the absolute value is at most `limit`.
void requireWithin(const std::string& option, double value, double limit, const char* text);
}  // namespace wheel_rail_contact::core
