// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/profile/file_profile.h"

namespace wheel_rail_contact::core
{
/// Edits and units that are stated in a Simpack file, by keyword.
using SimpackSettings = std::map<std::string, double>;

/// Applies the edits in Simpack's own order to the points as listed in the file (z down), in the unit of the file.
/// @throw std::out_of_range if a setting is missing.
void applySimpackEdits(const SimpackSettings& settings, std::vector<FilePoint>& points);
}  // namespace wheel_rail_contact::core
