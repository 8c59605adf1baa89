// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/config.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact
{
namespace
{
void require(bool rule, const std::string& option, double value, const char* text)
{
  if (!rule)
  {
    throw std::invalid_argument(option + " = " + std::to_string(value) + " " + text);
  }
}

void requirePositive(const std::string& option, double value)
{
  require(std::isfinite(value) && value > 0, option, value, "must be a positive number");
}

void requireWithin(const std::string& option, double value, double limit, const char* text)
{
  require(std::abs(value) <= limit, option, value, text);
}

void validate(const std::string& option, const Material& material)
{
  requirePositive(option + "/young", material.young);
  require(material.poisson > -1 && material.poisson <= 0.5, option + "/poisson", material.poisson,
          "must lie above -1 and not above 0.5");
}

void validate(const TrackConfig& track)
{
  requirePositive("track/gauge", track.gauge);
  requirePositive("track/gauge_depth", track.gauge_depth);
  requireWithin("track/cant", track.cant, 0.2, "must lie within 0.2 rad");
}

void validate(const WheelsetConfig& wheelset)
{
  requirePositive("wheelset/rolling_radius", wheelset.rolling_radius);
  requirePositive("wheelset/flange_back_distance", wheelset.flange_back_distance);
  requirePositive("wheelset/tape_circle", wheelset.tape_circle);
}

void validate(const ContactConfig& contact)
{
  require(contact.tolerance > 0 && contact.tolerance < 1, "contact/tolerance", contact.tolerance,
          "must lie between 0 and 1");
  const bool by_hand = contact.cells_along != 0 || contact.cells_across != 0;
  const auto fits = [](int cells) { return cells >= 4 && cells <= 256 && cells % 2 == 0; };
  require(!by_hand || fits(contact.cells_along), "contact/grid/along", contact.cells_along,
          "must be an even number from 4 to 256 (or 0 both along and across)");
  require(!by_hand || fits(contact.cells_across), "contact/grid/across", contact.cells_across,
          "must be an even number from 4 to 256 (or 0 both along and across)");
}

void validate(const RailBendingConfig& bending)
{
  const RailDeflection& given = bending.prescribed;
  requireWithin("rail_bending/prescribed/lateral", given.lateral, 0.1, "must lie within 0.1 m");
  requireWithin("rail_bending/prescribed/vertical", given.vertical, 0.1, "must lie within 0.1 m");
  requireWithin("rail_bending/prescribed/roll", given.roll, 0.2, "must lie within 0.2 rad");
  require(std::isfinite(bending.lateral_force_value), "rail_bending/lateral_force", bending.lateral_force_value,
          "must be a finite number");
  bending.table.validate();
}
}  // namespace

const char* toString(NormalMethod method)
{
  switch (method)
  {
    case NormalMethod::hertz:
      return "hertz";
    case NormalMethod::kik_piotrowski:
      return "kik_piotrowski";
    case NormalMethod::seidel:
      return "seidel";
    case NormalMethod::seidel_printed:
      return "seidel_printed";
    case NormalMethod::conjugate_gradient:
      return "conjugate_gradient";
    default:
      return "auto";
  }
}

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
  validate("material/wheel", config.wheel_material);
  validate("material/rail", config.rail_material);
  validate(config.track);
  validate(config.wheelset);
  validate(config.contact);
  validate(config.rail_bending);
}
}  // namespace wheel_rail_contact
