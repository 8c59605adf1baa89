// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wheel_rail_contact::core
{
/// @throw std::invalid_argument "option = value text" unless `rule` holds.
void require(bool rule, const std::string& option, double value, const char* text);
/// Same for a finite value above zero.
void requirePositive(const std::string& option, double value);
/// Same for an absolute value of at most `limit`.
void requireWithin(const std::string& option, double value, double limit, const char* text);
}  // namespace wheel_rail_contact::core
