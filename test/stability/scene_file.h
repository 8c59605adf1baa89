// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

/// Files of regression scenes (test/stability/scenes/*.yaml).
///
/// The parameters are those of the node (config/default.yaml) with these differences:
///   description               the fault that was found
///   wheel/profile             standard profile, or a file next to the scene file or in test/stability/profiles
///   wheel/noise               standard deviation of the points of the file [m]; default: that of the file format
///   rail/profile, rail/noise  same for the rail
///   rail_bending/table        group of name, lateral_lateral, lateral_roll, roll_roll and vertical_vertical (as in
///                             config/rails) instead of a file
///   states                    list of states, evaluated in this order by one WheelsetContact: groups of y, z, yaw,
///                             roll, force_z, torque_x, rail_lateral_force/{left, right},
///                             rail_displacement/{left, right}/{lateral, vertical, roll}; units and signs as in
///                             WheelsetState; a missing number is 0
namespace wheel_rail_contact::core::stability
{
/// @throw std::exception with file, key, value and rule.
Scene readScene(const std::string& file);

/// Writes each number with as many digits as are needed to read the same number again. Parameters that do not affect
/// the core are not written, nor is `x` of a state, which is only copied to the result.
void writeScene(std::ostream& out, const Scene& scene);
}  // namespace wheel_rail_contact::core::stability
