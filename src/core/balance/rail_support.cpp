// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/rail_support.h"

namespace wheel_rail_contact::core
{
RailAlong railAlong(const ContactModelConfig& config, Side side)
{
  const auto& sections = config.rail_sections[side];
  return sections ? RailAlong(*sections, config.track, side) : RailAlong(config.rail_profile[side], config.track, side);
}

PlacedRail restingRail(const ContactModelConfig& config, Side side, double x)
{
  const auto& sections = config.rail_sections[side];
  return sections ? railAt(*sections, config.track, side, x)
                  : PlacedRail(config.rail_profile[side], config.track, side);
}

Eigen::Vector3d toCoordinates(const RailDeflection& deflection)
{
  return {deflection.lateral, deflection.vertical, deflection.roll};
}

RailDeflection toDeflection(const Eigen::Vector3d& coordinates)
{
  return {coordinates[0], coordinates[1], coordinates[2]};
}

Eigen::Matrix3d supportCompliance(const ComplianceTable& table, double inclination)
{
  Eigen::Matrix3d compliance;
  compliance.col(0) = toCoordinates(deflectionInTrack(table, {1, 0, 0}, inclination));
  compliance.col(1) = toCoordinates(deflectionInTrack(table, {0, -1, 0}, inclination));
  compliance.col(2) = toCoordinates(deflectionInTrack(table, {0, 0, 1}, inclination));
  return compliance;
}
}  // namespace wheel_rail_contact::core
