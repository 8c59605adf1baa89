// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/track.h"

#include <string>

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
// Far wider than on real tracks and wheelsets, but without a usual length in millimetres.
constexpr LengthRange gauges{0.2, 3};  ///< and flange back distances
constexpr LengthRange gauge_depths{1e-5, 0.1};
constexpr LengthRange rolling_radii{0.05, 2};
constexpr LengthRange tape_circles{0.005, 0.5};
}  // namespace

void validate(const TrackConfig& track)
{
  requireLength("track/gauge", track.gauge, gauges);
  requireLength("track/gauge_depth", track.gauge_depth, gauge_depths);
  for (const Side side : sides)
  {
    requireWithin(optionOf(track.rail_inclination, side, "track/rail_inclination", "rail", "inclination"),
                  track.rail_inclination[side], 0.2, "must be within ±0.2 rad");
  }
}

void validate(const WheelsetConfig& wheelset)
{
  for (const Side side : sides)
  {
    requireLength(optionOf(wheelset.rolling_radius, side, "wheelset/rolling_radius", "wheel", "rolling_radius"),
                  wheelset.rolling_radius[side], rolling_radii);
  }
  requireLength("wheelset/flange_back_distance", wheelset.flange_back_distance, gauges);
  requireLength("wheelset/tape_circle", wheelset.tape_circle, tape_circles);
}
}  // namespace wheel_rail_contact::core
