// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace wheel_rail_contact::core
{
/// Text formatted as by printf(), cut at 255 bytes.
template <typename... Values>
std::string formatted(const char* format, Values... values)
{
  std::array<char, 256> text{};
  const int length = std::snprintf(text.data(), text.size(), format, values...);
  return {text.data(), std::min(static_cast<std::size_t>(std::max(length, 0)), text.size() - 1)};
}
}  // namespace wheel_rail_contact::core
