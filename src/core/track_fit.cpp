// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

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
constexpr double back_tolerance = 2e-3;    ///< of the flange back: wear, and the position of a measuring device
constexpr double least_back_rise = 3e-3;   ///< of a profile behind its flange tip, if it reaches the flange back
constexpr double back_slope = 5;           ///< least slope of a flange back [-]
constexpr double farthest_touch = 10e-3;   ///< from the running circle at y = 0, in height
constexpr double front_depth = 10e-3;      ///< of the front of the flange below the running circle (EN 15313)
constexpr double usual_clearance = 20e-3;  ///< of one flange: of worn flanges on a wide gauge
constexpr double largest_clearance = 35e-3;

std::string dimensions(const ContactModelConfig& config)
{
  return formatted("wheelset/flange_back_distance = %.10g m, wheelset/tape_circle = %.10g m, track/gauge = %.10g m",
                   config.wheelset.flange_back_distance, config.wheelset.tape_circle, config.track.gauge);
}

/// y of the flange tip and of the end of a wheel profile behind it [m].
struct FlangeEnds
{
  CurvePoint back, tip;
};

FlangeEnds flangeEnds(const Profile& wheel)
{
  FlangeEnds ends{wheel.at(0), wheel.at(0)};
  for (double u = 0; u < wheel.length(); u += ContactSearch::spacing)
  {
    const CurvePoint p = wheel.at(u);
    ends.back = p.y < ends.back.y ? p : ends.back;
    ends.tip = p.z < ends.tip.z ? p : ends.tip;
  }
  return ends;
}

/// Compares the flange back of a profile with wheelset/tape_circle.
void checkFlangeBack(const Profile& wheel, double tape_circle, double scale)
{
  const FlangeEnds ends = flangeEnds(wheel);
  const bool is_seen = ends.back.z > ends.tip.z + scale * least_back_rise &&
                       std::abs(ends.back.dz) > back_slope * std::abs(ends.back.dy);
  const double beyond = -tape_circle - ends.back.y;
  if (beyond > scale * back_tolerance || (is_seen && beyond < -scale * back_tolerance))
  {
    throw std::invalid_argument(
        formatted("wheelset/tape_circle = %.10g m: the flange back of wheel profile %s is %s from "
                  "its running circle",
                  tape_circle, wheel.name().c_str(), millimetres(-ends.back.y).c_str()));
  }
}

/// Distance of the front of the flange from the running circle, outward, at a depth below it [m]; nothing if the flange
/// does not reach it.
std::optional<double> frontOfFlange(const Profile& wheel, double depth)
{
  const FlangeEnds ends = flangeEnds(wheel);
  std::optional<double> front;
  for (double u = 0; u < wheel.length(); u += ContactSearch::spacing)
  {
    const CurvePoint p = wheel.at(u);
    front = p.y > ends.tip.y && p.y < 0 && p.z < -depth ? p.y : front;
  }
  return front;
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
  const Profile& wheel = *config.wheel_profile[side];
  checkFlangeBack(wheel, config.wheelset.tape_circle, scale);
  const auto front = frontOfFlange(wheel, scale * front_depth);
  const double clearance = front ? 0.5 * config.track.gauge - config.wheelset.halfBase() - *front : 0;
  if (clearance < 0 || clearance > scale * largest_clearance)
  {
    throw std::invalid_argument(dimensions(config) + ": the clearance of the flange of the " + nameOf(side) +
                                " wheel in the track is " + millimetres(clearance) + ", must be 0 to " +
                                millimetres(scale * largest_clearance));
  }
  const PlacedRail rail(runningProfile(config, side), config.track, side);
  ContactSearch search(wheel, rail.profile());
  search.setRail(rail);
  search.setWheel({wheel, config.wheelset, side, {}});
  InitialContact touch;
  const bool touches = search.nearest(touch);
  const double height = touches ? wheel.at(touch.wheel_u).z : 0;
  if (!touches || std::abs(height) > scale * farthest_touch || rail.at(touch.rail_u).z < -scale * gauge_depth)
  {
    throw std::invalid_argument(dimensions(config) + ": at y = 0 the " + nameOf(side) + " wheel " +
                                (touches
                                     ? "touches its rail " + millimetres(std::abs(height)) +
                                           (height < 0 ? " below" : " above") + " the running circle, not on the tread"
                                     : "is beside its rail"));
  }
  return clearance > scale * usual_clearance
             ? dimensions(config) + ": the clearance of the flange of the " + nameOf(side) + " wheel is " +
                   millimetres(clearance) + ", more than " + millimetres(scale * usual_clearance)
             : "";
}
}  // namespace

std::vector<std::string> checkFit(const ContactModelConfig& config)
{
  const double scale = modelScale(config.track, config.wheelset);
  std::vector<std::string> remarks;
  const double radius = config.wheelset.meanRadius();
  if (radius > 0.5 * config.track.gauge)
  {
    remarks.push_back(
        formatted("wheelset/rolling_radius = %.10g m is more than half of track/gauge: is it the diameter?", radius));
  }
  for (const Side side : sides)
  {
    const std::string remark = fitOf(config, side, scale);
    if (!remark.empty())
    {
      remarks.push_back(remark);
    }
  }
  return remarks;
}
}  // namespace wheel_rail_contact::core
