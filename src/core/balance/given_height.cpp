// SPDX-License-Identifier: BSD-3-Clause
// Given height and roll on rails that bend by a table. The other members of WheelsetBalance are in
// wheelset_balance.cpp.
#include <cmath>

#include "core/balance/both_sides.h"
#include "core/balance/wheelset_balance.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double height_share = 0.1;  ///< allowed height error over the approach, per unit of contact/tolerance [-]
}

/// Expected load under which a wheel lies at the given height [N]: the last load, or the load that lowers the rail by
/// the same distance. Zero if the wheel does not reach the rail at rest.
double WheelsetBalance::expectedLoad(Side side)
{
  const auto k = index(side);
  BendingRail& rail = rail_[k];
  const RigidTouch touch =
      rail.touchAtRest(poseOf(side, state_.roll), state_.rail_lateral_force[k], state_.rail_offset[k]);
  const double down = touch.axle_height - state_.z;
  if (!touch.found || !(down > 0))
  {
    return 0;
  }
  return warm_ && loaded_[k] ? rail.result().vertical_force : down / rail.deflectionPerLoad(touch);
}

/// True if the wheels lie at the given height. Otherwise sets other loads for the next pass.
bool WheelsetBalance::heightsMeet()
{
  bool all = true;
  for (std::size_t k = 0; k < wheel_.size(); ++k)
  {
    if (config_.wheelset.solve_height_and_roll || !loaded_[k])
    {
      continue;
    }
    const double elastic = wheel_[k].elasticPenetration();
    const double too_high = touch_[k].axle_height - penetration_[k] - rail_[k].remainingDeflection() - state_.z;
    const bool meets = std::abs(too_high) < height_share * config_.contact.tolerance * elastic;
    if (!meets && finds_loads_)
    {
      load_search_[k].record(too_high, rail_[k].deflectionPerLoad() + 2 * elastic / (3 * load_[k]));
      load_[k] = load_search_[k].load();
    }
    all = all && meets;
  }
  return all;
}
}  // namespace wheel_rail_contact::core
