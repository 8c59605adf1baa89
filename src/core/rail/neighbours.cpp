// SPDX-License-Identifier: BSD-3-Clause
#include "core/rail/neighbours.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace wheel_rail_contact::core
{
namespace
{
[[noreturn]] void refuse(const std::vector<RailInfluence>& listed, double distance)
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

ComplianceTable influenceAt(const std::vector<RailInfluence>& listed, double distance)
{
  const auto after = std::find_if(listed.begin(), listed.end(),
                                  [distance](const RailInfluence& entry) { return entry.distance >= distance; });
  if (after == listed.end() || (after == listed.begin() && after->distance != distance))
  {
    refuse(listed, distance);
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
