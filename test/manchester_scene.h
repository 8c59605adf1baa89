// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "wheel_rail_contact/core/profile_reader.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace wheel_rail_contact::core
{
/// Model of the Manchester contact benchmark (Shackleton and Iwnicki 2008, Vehicle System Dynamics 46): S1002 on UIC60,
/// rail inclination 1:40, gauge 1435 mm, back-to-back distance 1360 mm, rolling radius 460 mm.
inline ContactModelConfig manchesterScene()
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<Profile>(railUic60Manchester());
  return config;
}

/// Rail on pads of 40 kN/mm (lateral) and 100 kN/mm (vertical) every 0.6 m. Source: see config/rails/pads_40_100.yaml.
inline ComplianceTable softPads()
{
  return {60.5e-9, 303e-9, 2.63e-6, 5.6e-9};
}

/// Rail on pads of 10 kN/mm (lateral) and 25 kN/mm (vertical). Source: see config/rails/pads_10_25.yaml. On this rail,
/// a simple iteration between rail deflection and contact oscillates between tread and flange.
inline ComplianceTable verySoftPads()
{
  return {135.8e-9, 612e-9, 4.60e-6, 14.5e-9};
}

/// Lets the rails bend.
inline void bend(ContactModelConfig& config, const ComplianceTable& table)
{
  config.rail_bending.model = RailBendingConfig::Model::compliance;
  config.rail_bending.table = table;
}

/// The model on rails that bend.
inline ContactModelConfig onPads(const ComplianceTable& table)
{
  ContactModelConfig config = manchesterScene();
  bend(config, table);
  return config;
}
}  // namespace wheel_rail_contact::core
