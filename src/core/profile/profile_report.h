// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Range of y in which points of a profile are missing [m].
struct MissingRange
{
  double y_first, y_last;
  double length;  ///< along the curve [m]
};

/// Ranges in which points are missing, from the gauge side.
std::vector<MissingRange> missingRanges(const Profile& profile);
/// One line with what was understood of a file.
std::string reportText(const Profile& profile, const ProfileReport& report);
}  // namespace wheel_rail_contact::core
