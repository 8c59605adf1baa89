// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/rail/neighbours.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact
{
/// Contents of a file with a compliance table (config/rails/*.yaml; the schema is at the head of each file).
struct ComplianceTableFile
{
  std::string name;                                               ///< of the rail and its supports
  core::ComplianceTable table;                                    ///< of the upright rail
  double linear_range = std::numeric_limits<double>::infinity();  ///< largest |Y|/Q for which the table is valid [-]
  std::vector<core::RailInfluence> neighbours;  ///< effect of forces at a distance, in order of distance; may be empty
};

/// Reads a compliance table strictly: all keys are required, unknown keys are refused, and the matrix must be positive
/// definite.
/// @throw std::invalid_argument with file, key, value and violated rule.
ComplianceTableFile readComplianceTable(const std::string& file);

/// Warning with side, Y, Q and |Y|/Q of each rail whose |Y|/Q exceeds the range of its table; empty if there is none.
/// @param linear_range largest |Y|/Q for which the table of each rail is valid [-]
std::string linearRangeWarning(const core::WheelsetResult& result, const core::Sides<double>& linear_range);
}  // namespace wheel_rail_contact
