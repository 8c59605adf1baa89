// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/text/formatted.h"

namespace wheel_rail_contact
{
using core::formatted;

/// Two sentences, either of which may be empty, as one text.
inline std::string sentences(const std::string& first, const std::string& second)
{
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}
}  // namespace wheel_rail_contact
