// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/rail_compliance.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
void requireFinite(const char* name, double value)
{
  if (!std::isfinite(value))
  {
    throw std::invalid_argument(std::string("rail_bending/table: ") + name + " must be a finite number");
  }
}

void requireNonNegative(const char* name, double value)
{
  requireFinite(name, value);
  if (value < 0)
  {
    throw std::invalid_argument(std::string("rail_bending/table: ") + name + " = " + std::to_string(value) +
                                " must not be negative");
  }
}
}  // namespace

void ComplianceTable::validate() const
{
  requireNonNegative("lateral_lateral", lateral_lateral);
  requireFinite("lateral_roll", lateral_roll);
  requireNonNegative("roll_roll", roll_roll);
  requireNonNegative("vertical_vertical", vertical_vertical);
  if (lateral_roll * lateral_roll > lateral_lateral * roll_roll)
  {
    throw std::invalid_argument(
        "rail_bending/table: lateral_roll² is greater than lateral_lateral * roll_roll: the compliance matrix must be "
        "positive semidefinite");
  }
}

RailDeflection deflection(const ComplianceTable& table, const RailForce& force)
{
  return {table.lateral_lateral * force.lateral + table.lateral_roll * force.moment,
          -table.vertical_vertical * force.vertical,
          table.lateral_roll * force.lateral + table.roll_roll * force.moment};
}

RailDeflection deflectionInTrack(const ComplianceTable& table, const RailForce& force, double inclination)
{
  // Axes of the rail in track axes (outward, up): its outward direction is (cos, sin), its up direction (-sin, cos).
  const double cosine = std::cos(inclination);
  const double sine = std::sin(inclination);
  const RailForce own{cosine * force.lateral - sine * force.vertical, sine * force.lateral + cosine * force.vertical,
                      force.moment};
  const RailDeflection moved = deflection(table, own);
  return {cosine * moved.lateral - sine * moved.vertical, sine * moved.lateral + cosine * moved.vertical, moved.roll};
}

void validate(const RailBendingConfig& bending)
{
  const RailDeflection& given = bending.prescribed;
  requireWithin("rail_bending/prescribed/lateral", given.lateral, 0.1, "must be within ±0.1 m");
  requireWithin("rail_bending/prescribed/vertical", given.vertical, 0.1, "must be within ±0.1 m");
  requireWithin("rail_bending/prescribed/roll", given.roll, 0.2, "must be within ±0.2 rad");
  require(std::isfinite(bending.lateral_force_value), "rail_bending/lateral_force", bending.lateral_force_value,
          "must be a finite number");
  bending.table.left.validate();
  bending.table.right.validate();
}
}  // namespace wheel_rail_contact::core
