// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact
{
/// True if a profile can be evaluated at every point.
inline bool isSound(const core::Profile& profile)
{
  constexpr int places = 1000;
  bool sound = std::isfinite(profile.length()) && profile.length() > 0;
  for (int i = 0; i <= places && sound; ++i)
  {
    const core::CurvePoint point = profile.at(profile.length() * i / places);
    sound = std::isfinite(point.y) && std::isfinite(point.z) && std::hypot(point.dy, point.dz) > 0;
  }
  return sound;
}
}  // namespace wheel_rail_contact
