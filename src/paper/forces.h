// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::paper
{
/// A compliance table with its name and range.
struct NamedTable
{
  std::string name;
  ComplianceTable table;
  double linear_range;  ///< largest |Y|/Q for which it holds [-]; infinite: no limit
};

/// What of a rail's deflection is taken into account.
enum class DeflectionShare
{
  whole,           ///< all of the table
  without_moment,  ///< the wheel load off the rail's axis does not turn the rail
  shift_only       ///< the rail's displacement across the track by the lateral force: neither roll nor wheel load
};
const char* toString(DeflectionShare share);

/// The left wheel on rails that give way to a lateral force (outward, the same on both rails) and the wheel load.
struct ForceRow
{
  std::string table;
  DeflectionShare share;
  double y;                   ///< wheelset's position, towards the flange [m]
  double lateral_force;       ///< [N]
  bool in_range;              ///< of the table
  RailDeflection deflection;  ///< of the head's reference point
  Figures figures;            ///< zero where there is no solution
};

/// Both rails under lateral forces of the given values at each of the positions, wheel loads as printed.
std::vector<ForceRow> underForces(const ContactModelConfig& config, const NamedTable& table, DeflectionShare share,
                                  const std::vector<double>& positions, const std::vector<double>& forces);
}  // namespace wheel_rail_contact::core::paper
