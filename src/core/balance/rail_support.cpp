// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/rail_support.h"

namespace wheel_rail_contact::core
{
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

SupportedRail::SupportedRail(const ContactModelConfig& config, Side side)
    : along_(config.rail_sections[side] ? RailAlong(*config.rail_sections[side], config.track, side)
                                        : RailAlong(config.rail_profile[side], config.track, side)),
      bends_(config.rail_bending.model == RailBendingConfig::Model::compliance)
{
  if (bends_)
  {
    compliance_ = supportCompliance(config.rail_bending.table[side], config.track.rail_inclination[side]);
  }
  if (config.rail_bending.model == RailBendingConfig::Model::prescribed)
  {
    prescribed_ = toCoordinates(config.rail_bending.prescribed);
  }
  offset_ = prescribed_;
}

void SupportedRail::displace(const RailDeflection& displacement)
{
  displacement_ = displacement;
  offset_ = prescribed_ + toCoordinates(displacement) + compliance_ * borne_;
}

PlacedRail SupportedRail::placedAt(Eigen::Vector3d coordinates, const WheelRim& rim) const
{
  coordinates[1] += course_.rise;
  PlacedRail rail = atRest().deflected(toDeflection(coordinates));
  rail.setMotion(course_.motion, rim);
  return rail;
}

void SupportedRail::bear(const Eigen::Vector3d& forces)
{
  borne_ = forces;
  displace(displacement_);
}
}  // namespace wheel_rail_contact::core
