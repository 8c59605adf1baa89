// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/profile/profile_file.h"

namespace wheel_rail_contact::core
{
/// Edits and units a Simpack file states, by keyword.
using SimpackSettings = std::map<std::string, double>;

/// Applies the edits in Simpack's order to points as listed in the file, z down, and brings them to the profile frame.
/// @throw std::out_of_range if a setting is missing.
void applySimpackEdits(const SimpackSettings& settings, std::vector<FilePoint>& points);
}  // namespace wheel_rail_contact::core
