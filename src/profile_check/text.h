// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "profile_check/checked_profile.h"

namespace wheel_rail_contact::core::profile_check
{
/// What was understood of a file and measured on its profile, in lines of text.
std::string textOf(const std::string& file, const CheckedProfile& checked);

/// Nearest standard profile and its distance, in one line.
std::string textOf(const StandardFit& nearest);
}  // namespace wheel_rail_contact::core::profile_check
