// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/config.h"

#include <stdexcept>

namespace wheel_rail_contact::core
{
void validate(const ContactModelConfig& config)
{
  if (config.wheel_profile == nullptr)
  {
    throw std::invalid_argument("wheel/profile is not set");
  }
  if (config.rail_profile == nullptr)
  {
    throw std::invalid_argument("rail/profile is not set");
  }
  validate(config.wheel_material, "material/wheel");
  validate(config.rail_material, "material/rail");
  validate(config.track);
  validate(config.wheelset);
  validate(config.contact);
  validate(config.rail_bending);
}
}  // namespace wheel_rail_contact::core
