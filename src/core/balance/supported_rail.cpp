// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/supported_rail.h"

namespace wheel_rail_contact::core
{
SupportedRail::SupportedRail(const ContactModelConfig& config, Side side)
    : along_(railAlong(config, side)), bends_(config.rail_bending.model == RailBendingConfig::Model::compliance)
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
  offset_ = prescribed_ + toCoordinates(displacement);
}
}  // namespace wheel_rail_contact::core
