// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/track.h"

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
void validate(const TrackConfig& track)
{
  requirePositive("track/gauge", track.gauge);
  requirePositive("track/gauge_depth", track.gauge_depth);
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
    requirePositive(optionOf(wheelset.rolling_radius, side, "wheelset/rolling_radius", "wheel", "rolling_radius"),
                    wheelset.rolling_radius[side]);
  }
  requirePositive("wheelset/flange_back_distance", wheelset.flange_back_distance);
  requirePositive("wheelset/tape_circle", wheelset.tape_circle);
}
}  // namespace wheel_rail_contact::core
