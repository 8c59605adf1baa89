// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "wheel_rail_contact/core/contact_config.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/profile.h"
#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Everything a WheelsetContact is told when it is made.
struct ContactModelConfig
{
  std::shared_ptr<const Profile> wheel_profile;  ///< of the left wheel; the right one mirrors it
  std::shared_ptr<const Profile> rail_profile;   ///< of the left rail, upright; the right one mirrors it
  Material wheel_material;                       ///< of both wheels
  Material rail_material;                        ///< of both rails
  TrackConfig track;                             ///< where the rails stand
  WheelsetConfig wheelset;                       ///< where the wheels are on their axle
  ContactConfig contact;                         ///< method and tolerance
  RailBendingConfig rail_bending;                ///< how the rails give way
};

/// Checks every option against its rule.
/// @throw std::invalid_argument naming the option, its value and the broken rule.
void validate(const ContactModelConfig& config);
}  // namespace wheel_rail_contact::core
