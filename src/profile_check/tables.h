// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "profile_check/checked_profile.h"

namespace wheel_rail_contact::core::profile_check
{
/// Writes the tables from which the picture is drawn, as CSV in SI units:
///
/// * curve.csv: the curve every 0.1 mm, with its arc length, curvature and errors (standard deviations);
/// * points.csv: the used points of the file, with their arc length and their distance from the curve, positive above;
/// * standard.csv: the nearest standard profile, moved onto the profile;
/// * marks.csv: points of the profile by name: those of WheelMeasures and RailMeasures;
/// * values.csv: kind, report, smoothing, and the line on the nearest standard profile.
/// @throw std::runtime_error if a file cannot be written
void writeTables(const CheckedProfile& checked, const std::filesystem::path& folder);
}  // namespace wheel_rail_contact::core::profile_check
