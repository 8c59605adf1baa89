// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "profile_check/checked_profile.h"

namespace wheel_rail_contact::core::profile_check
{
/// Writes a profile as a table `y_mm,z_mm`, after comments with the name of its file and what was understood of it. The
/// points are those of the file if the curve passes through them, else points along the curve (pointsAlong()). The
/// table is then read: the curve must be the same within 0.1 um.
/// @param source  name of the file
/// @return what a user of the table must know: empty, or that it is to be read with `smoothing: 0`, because the curve
/// is so rough that it would be smoothed again
/// @throw std::runtime_error if the file cannot be written, or if the curve is another one: for example a rail that was
/// shifted so far that its origin is found again from its shape.
std::string writeCleanTable(const std::string& source, const CheckedProfile& checked,
                            const std::filesystem::path& file);
}  // namespace wheel_rail_contact::core::profile_check
