// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/profile/file_profile.h"

namespace wheel_rail_contact::core
{
/// Curve through or near the points of a file, with what is not known of it.
/// @param unit    length unit of the file [m]
/// @param points  in order, in the profile frame; points that lie off the curve are omitted
/// @param report  its noise and smoothing are set; a remark on what was done with the points is added
/// @throw TextError if the points are no smooth curve, or if a stated smoothing is not possible.
std::vector<ProfileSection> curveThrough(const TextFile& file, const FileProfile& content, double unit,
                                         const ProfileReading& reading, std::vector<FilePoint>& points,
                                         ProfileReport& report);
}  // namespace wheel_rail_contact::core
