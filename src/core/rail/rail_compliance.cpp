// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/rail_compliance.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "core/option_check.h"
#include "core/rail/neighbours.h"

namespace wheel_rail_contact::core
{
namespace
{
void requireFinite(const char* name, double value)
{
  refuseIf(!std::isfinite(value), std::string("rail_bending/table: ") + name + " must be a finite number");
}

void requireNonNegative(const char* name, double value)
{
  requireFinite(name, value);
  require(value >= 0, std::string("rail_bending/table: ") + name, value, "must not be negative");
}

/// Linear interpolation from `a` (share 0) to `b` (share 1).
ComplianceTable between(const ComplianceTable& a, const ComplianceTable& b, double share)
{
  const auto mean = [share](double at_a, double at_b) { return (1 - share) * at_a + share * at_b; };
  ComplianceTable table;
  table.lateral_lateral = mean(a.lateral_lateral, b.lateral_lateral);
  table.lateral_roll = mean(a.lateral_roll, b.lateral_roll);
  table.roll_roll = mean(a.roll_roll, b.roll_roll);
  table.vertical_vertical = mean(a.vertical_vertical, b.vertical_vertical);
  return table;
}
}  // namespace

void ComplianceTable::validate() const
{
  requireNonNegative("lateral_lateral", lateral_lateral);
  requireFinite("lateral_roll", lateral_roll);
  requireNonNegative("roll_roll", roll_roll);
  requireNonNegative("vertical_vertical", vertical_vertical);
  refuseIf(
      lateral_roll * lateral_roll > lateral_lateral * roll_roll,
      "rail_bending/table: lateral_roll² is greater than lateral_lateral * roll_roll: the compliance matrix must be "
      "positive semidefinite");
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

ComplianceTable influenceAt(const std::vector<RailInfluence>& listed, double distance)
{
  const auto after = std::find_if(listed.begin(), listed.end(),
                                  [distance](const RailInfluence& entry) { return entry.distance >= distance; });
  if (after == listed.end() || (after == listed.begin() && after->distance != distance))
  {
    std::ostringstream text;
    text << "rail_bending/neighbours/distance = " << distance << " m must be within the distances of the table: ";
    if (listed.empty())
    {
      text << "the table has none";
    }
    else
    {
      text << listed.front().distance << " m to " << listed.back().distance << " m";
    }
    throw std::invalid_argument(text.str());
  }
  if (after->distance == distance)
  {
    return after->influence;
  }
  const RailInfluence& before = *(after - 1);
  return between(before.influence, after->influence,
                 (distance - before.distance) / (after->distance - before.distance));
}

RailDeflection neighbourDeflection(const std::vector<NeighbourForce>& neighbours, double inclination)
{
  RailDeflection sum;
  for (const NeighbourForce& neighbour : neighbours)
  {
    sum += deflectionInTrack(neighbour.influence, neighbour.force, inclination);
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
