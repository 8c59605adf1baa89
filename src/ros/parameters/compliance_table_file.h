// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/rail/neighbours.h"

namespace wheel_rail_contact
{
/// A rail's compliance as it stands in a file (config/rails/*.yaml; the schema stands at the head of each).
struct ComplianceTableFile
{
  std::string name;                                               ///< of the rail and its supports
  core::ComplianceTable table;                                    ///< of the upright rail
  double linear_range = std::numeric_limits<double>::infinity();  ///< largest |Y|/Q for which the table holds [-]
  std::vector<core::RailInfluence> neighbours;  ///< of forces along the rail, distances rising; may be empty
};

/// Reads a compliance table strictly: every key required, none unknown, the matrix positive definite.
/// @throw std::invalid_argument with file, key, value and rule.
ComplianceTableFile readComplianceTable(const std::string& file);
}  // namespace wheel_rail_contact
