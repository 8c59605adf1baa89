// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/config.h"

#include <stdexcept>
#include <string>

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
void validate(const ContactModelConfig& config)
{
  for (const Side side : sides)
  {
    const std::string name = nameOf(side);
    if (config.wheel_profile[side] == nullptr)
    {
      throw std::invalid_argument("wheel/profile or wheel/" + name + "/profile is not set");
    }
    for (const auto& profile : {config.wheel_profile[side], config.rail_profile[side]})
    {
      if (profile && profile->parts().size() != 1)
      {
        throw std::invalid_argument("profile '" + profile->name() +
                                    "' has several parts, which only rail_sections may have");
      }
    }
    if (config.rail_profile[side] == nullptr && config.rail_sections[side] == nullptr)
    {
      throw std::invalid_argument("rail/profile or rail/" + name + "/profile is not set");
    }
    validate(config.wheel_material[side], optionOf(config.wheel_material, side, "material/wheel", "wheel", "material"));
    validate(config.rail_material[side], optionOf(config.rail_material, side, "material/rail", "rail", "material"));
  }
  validate(config.track);
  validate(config.wheelset);
  validate(config.contact);
  validate(config.stress);
  validate(config.rail_bending);
}
}  // namespace wheel_rail_contact::core
