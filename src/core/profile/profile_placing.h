// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/profile/file_profile.h"

namespace wheel_rail_contact::core
{
/// Unit and directions of the coordinates of a file.
struct FileAxes
{
  double unit;  ///< [m]
  ProfileReading::Y y;
  ProfileReading::Z z;
};

/// Points of a file in the profile frame [m].
struct PlacedPoints
{
  std::vector<FilePoint> points;
  double moved_y = 0, moved_z = 0;  ///< distances by which the origin was moved outward and up [m]
};

/// Unit and axes, as stated by `reading`, or by the file or its format; nothing if one is not known.
/// @throw TextError if `reading` contradicts the unit in the file.
std::optional<FileAxes> knownAxes(const TextFile& file, const FileProfile& content, const ProfileReading& reading);

/// Brings the points to the profile frame: unit, axes, origin, shift, rotation and mirror, in this order.
/// @throw TextError if the points have no such origin.
PlacedPoints placedPoints(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
                          const ProfileReading& reading);
}  // namespace wheel_rail_contact::core
