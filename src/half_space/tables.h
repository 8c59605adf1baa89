// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "half_space/cell_grids.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::half_space
{
/// Solves the left wheel at a lateral position under each load with all half-space models, and writes (SI units, side
/// axes):
/// * values.csv: contact modulus, and the axle at the largest load;
/// * models.csv: results of the models on fine grids;
/// * outlines.csv: profiles of both bodies at the largest load;
/// * cells.csv: cells of each contact, and columns.csv: their columns at the largest load;
/// * contacts.csv: half_space_ratio of each contact at each load, and whether the package projects its displacements
///   onto turned normals, and the stated model error;
/// * gaps.csv: gaps along the normals of the rail, and over the tangent plane, at each load;
/// * openings.csv: opening of each column per displacement of the wheel, at each load.
/// @throw std::invalid_argument for an invalid number, std::runtime_error if there is no solution or no file
void writeTables(const ContactModelConfig& config, double y, const std::vector<double>& loads, const CellCount& count,
                 const std::filesystem::path& folder);
}  // namespace wheel_rail_contact::core::half_space
