// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/option_check.h"
#include "core/profile/curve/measures.h"
#include "core/text/formatted.h"
#include "core/text/table_title.h"
#include "core/track/contact_search.h"
#include "core/track/placement.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core
{
namespace
{
// Limits at full size [m]; those of a model are smaller by its scale.
constexpr double back_tolerance = 2e-3;   ///< of the flange back: wear, and the place of a measuring device
constexpr double least_back_rise = 3e-3;  ///< of a profile behind its flange tip, if it reaches the flange back
constexpr double back_slope = 5;          ///< least slope of a flange back [-]
constexpr double farthest_touch = 10e-3;  ///< from the running circle at y = 0, in height
/// Clearance of one flange: at least on a narrowed track, and of worn flanges on a wide gauge.
constexpr double least_clearance = -4e-3, usual_clearance = 20e-3, largest_clearance = 35e-3;

/// Places of a flange. `front` is the end of what is deeper than its depth.
struct Flange
{
  CurvePoint back, tip, front;
};

Flange flangeOf(const Profile& wheel, double depth)
{
  Flange flange{wheel.at(0), wheel.at(0), wheel.at(0)};
  for (double u = 0; u < wheel.length(); u += ContactSearch::spacing)
  {
    const CurvePoint p = wheel.at(u);
    flange.back = p.y < flange.back.y ? p : flange.back;
    flange.tip = p.z < flange.tip.z && p.y < 0 ? p : flange.tip;
    flange.front = p.z < -depth && p.y < 0 ? p : flange.front;
  }
  return flange;
}

/// Compares the flange back of a profile with wheelset/tape_circle.
void checkFlangeBack(const Profile& wheel, const Flange& flange, double tape_circle, double scale)
{
  const bool is_seen = flange.back.z > flange.tip.z + scale * least_back_rise &&
                       std::abs(flange.back.dz) > back_slope * std::abs(flange.back.dy);
  const double beyond = -tape_circle - flange.back.y;
  refuseIf(
      beyond > scale * back_tolerance || (is_seen && beyond < -scale * back_tolerance),
      formatted("wheelset/tape_circle = %.10g m: the flange back of wheel profile %s is %s from its running circle",
                tape_circle, wheel.name().c_str(), millimetres(-flange.back.y).c_str()));
}

/// The profile by which a rail is placed.
std::shared_ptr<const Profile> runningProfile(const ContactModelConfig& config, Side side)
{
  const auto& sections = config.rail_sections[side];
  return sections ? sections->parts().front().front().profile : config.rail_profile[side];
}

/// Checks one side. @return a remark, or an empty text
std::string fitOf(const ContactModelConfig& config, Side side, double scale)
{
  const WheelsetConfig& wheelset = config.wheelset;
  const Profile& wheel = *config.wheel_profile[side];
  const Flange flange = flangeOf(wheel, scale * front_depth);
  checkFlangeBack(wheel, flange, wheelset.tape_circle, scale);
  const std::string dimensions = formatted(
      "wheelset/flange_back_distance = %.10g m, wheelset/tape_circle = %.10g m, track/gauge = %.10g m: the %s wheel ",
      wheelset.flange_back_distance, wheelset.tape_circle, config.track.gauge, nameOf(side));
  const double clearance = 0.5 * config.track.gauge - wheelset.halfBase() - flange.front.y;
  const std::string text = dimensions + "has a clearance of " + millimetres(clearance) + " beside its flange, ";
  refuseIf(clearance < scale * least_clearance || clearance > scale * largest_clearance,
           text + "must be " + millimetres(scale * least_clearance) + " to " + millimetres(scale * largest_clearance));
  const PlacedRail rail(runningProfile(config, side), config.track, side);
  ContactSearch search(wheel, rail.profile());
  search.setRail(rail);
  search.setWheel({wheel, wheelset, side, {}});
  InitialContact touch;
  refuseIf(!search.nearest(touch), dimensions + "is beside its rail at y = 0");
  const double height = wheel.at(touch.wheel_u).z;
  refuseIf(std::abs(height) > scale * farthest_touch || rail.at(touch.rail_u).z < -scale * gauge_depth,
           dimensions + "touches its rail " + millimetres(std::abs(height)) + (height < 0 ? " below" : " above") +
               " the running circle at y = 0, not on the tread and the head");
  return clearance < 0 || clearance > scale * usual_clearance
             ? text + "usual are 0 to " + millimetres(scale * usual_clearance)
             : "";
}
}  // namespace

std::vector<std::string> checkFit(const ContactModelConfig& config)
{
  constexpr double least_radius = 0.1, most_radius = 0.5;  // over the gauge: wheels of 0.15 m to 0.7 m on 1.435 m
  constexpr double field_side = -0.005;                    // inclination that is no tolerance [rad]
  const double scale = modelScale(config.track, config.wheelset), gauge = config.track.gauge;
  std::vector<std::string> remarks;
  for (const Side side : sides)
  {
    const double radius = config.wheelset.rolling_radius[side], inclination = config.track.rail_inclination[side];
    const bool is_usual = radius >= least_radius * gauge && radius <= most_radius * gauge;
    remarks.push_back(fitOf(config, side, scale));
    if (!is_usual)
    {
      remarks.push_back(
          formatted("wheelset/rolling_radius = %.10g m (%s) is not 0.1 to 0.5 of track/gauge: is it the "
                    "diameter, or in another unit?",
                    radius, nameOf(side)));
    }
    if (!(inclination > field_side))
    {
      remarks.push_back(
          formatted("track/rail_inclination = %.10g (%s) leans the rail to the field side", inclination, nameOf(side)));
    }
  }
  remarks.erase(std::remove(remarks.begin(), remarks.end(), ""), remarks.end());
  return remarks;
}
}  // namespace wheel_rail_contact::core
