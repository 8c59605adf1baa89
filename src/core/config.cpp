// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/config.h"

#include <stdexcept>

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
void validate(const ContactConfig& contact)
{
  require(contact.tolerance > 0 && contact.tolerance < 1, "contact/tolerance", contact.tolerance,
          "must be between 0 and 1");
  const bool by_hand = contact.cells_along != 0 || contact.cells_across != 0;
  const auto fits = [](int cells) { return cells >= 4 && cells <= 256 && cells % 2 == 0; };
  require(!by_hand || fits(contact.cells_along), "contact/grid/along", contact.cells_along,
          "must be an even number from 4 to 256 (or 0 both along and across)");
  require(!by_hand || fits(contact.cells_across), "contact/grid/across", contact.cells_across,
          "must be an even number from 4 to 256 (or 0 both along and across)");
}

namespace
{
/// Moduli and stresses far beyond any metal or plastic [Pa]: one in MPa or GPa is below.
constexpr double least_modulus = 1e9, least_yield = 1e6, most_pascal = 1e13;

void validateMaterial(const Material& material, const std::string& option)
{
  validate(material, option);
  require(material.young >= least_modulus && material.young <= most_pascal, option + "/young", material.young,
          "must be from 1e9 to 1e13, in Pa");
  require(material.yield == 0 || (material.yield >= least_yield && material.yield <= most_pascal), option + "/yield",
          material.yield, "must be 0, or from 1e6 to 1e13, in Pa");
}
}  // namespace

void validate(const ContactModelConfig& config)
{
  for (const Side side : sides)
  {
    const std::string name = nameOf(side);
    refuseIf(config.wheel_profile[side] == nullptr, "wheel/profile or wheel/" + name + "/profile is not set");
    for (const auto& profile : {config.wheel_profile[side], config.rail_profile[side]})
    {
      if (profile && profile->parts().size() != 1)
      {
        throw std::invalid_argument("profile '" + profile->name() +
                                    "' has several parts, which only rail_sections may have");
      }
    }
    refuseIf(config.rail_profile[side] == nullptr && config.rail_sections[side] == nullptr,
             "rail/profile or rail/" + name + "/profile is not set");
    validateMaterial(config.wheel_material[side],
                     optionOf(config.wheel_material, side, "material/wheel", "wheel", "material"));
    validateMaterial(config.rail_material[side],
                     optionOf(config.rail_material, side, "material/rail", "rail", "material"));
  }
  validate(config.track);
  validate(config.wheelset);
  checkFit(config);
  validate(config.contact);
  validate(config.stress);
  validate(config.rail_bending);
  validate(config.creep);
  refuseIf(config.creep.method != CreepMethod::none && (config.rail_sections.left || config.rail_sections.right),
           "creep/method = " + std::string(toString(config.creep.method)) + ": friction is for rails without sections");
}
}  // namespace wheel_rail_contact::core
