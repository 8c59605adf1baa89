// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// Normal, vertical and lateral force of a patch on its wheel, track axes [N]: without friction along the track.
Eigen::Vector3d forceOnWheel(const PatchResult& patch);

/// Force of a rail on its wheel, of normal pressure and friction.
struct WheelWrench
{
  /// From the axle centre, track axes [m]: mean of the centres of pressure of the patches, weighted by their normal
  /// forces; zero if the wheel carries no load.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Wrench wrench;  ///< track axes; its moment is about `centre`: by spin, and by several patches
};

/// Wrench of a wheel. Both together are WheelsetResult::rail_wrench.
WheelWrench wheelWrench(const WheelsetResult& result, Side side);
}  // namespace wheel_rail_contact::core
