// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core::paper
{
/// A compliance table with its name and its range.
struct NamedTable
{
  std::string name;
  ComplianceTable table;
  double linear_range;  ///< largest |Y|/Q for which the table is valid [-]; infinite: no limit
};

/// Whether a lateral force [N] is in the range of a table, with the printed wheel load.
bool isInRange(const NamedTable& table, double force);

/// Wheelset on rails that bend by a table under the lateral forces of its state.
ContactModelConfig onTable(const ContactModelConfig& config, const NamedTable& table);

/// State with the printed wheel loads.
/// @param y      lateral position of the wheelset, towards the flange of the left wheel positive [m]
/// @param force  lateral force on both rails, outward positive [N]
WheelsetState stateUnder(double y, double force);

/// Part of a rail's deflection that is taken into account.
enum class DeflectionShare
{
  whole,           ///< complete deflection of the table
  without_moment,  ///< without the roll by the eccentric wheel load
  shift_only       ///< lateral displacement by the lateral force only: no roll, no effect of the wheel load
};
const char* toString(DeflectionShare share);

/// Left wheel on rails that deflect under a lateral force (outward, the same on both rails) and the wheel load.
struct ForceRow
{
  std::string table;
  DeflectionShare share;
  double y;                   ///< lateral position of the wheelset, towards the flange positive [m]
  double lateral_force;       ///< [N]
  bool in_range;              ///< the force is in the range of the table
  RailDeflection deflection;  ///< deflection of the head, at its reference point
  Figures figures;            ///< zero if there is no solution
};

/// Solves both wheels at each position under each lateral force on both rails, with the printed wheel loads.
std::vector<ForceRow> underForces(const ContactModelConfig& config, const NamedTable& table, DeflectionShare share,
                                  const std::vector<double>& positions, const std::vector<double>& forces);
}  // namespace wheel_rail_contact::core::paper
