// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../manchester_scene.h"

namespace wheel_rail_contact::core::stability
{
/// S1002 on rigid rails 60E1.
inline ContactModelConfig standard()
{
  ContactModelConfig config = manchesterScene();
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  return config;
}

/// The same on rails that bend.
inline ContactModelConfig standardOn(const ComplianceTable& table)
{
  ContactModelConfig config = standard();
  bend(config, table);
  return config;
}
}  // namespace wheel_rail_contact::core::stability
