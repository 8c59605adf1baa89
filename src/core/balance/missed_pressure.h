// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/balance/wheel_patch.h"

namespace wheel_rail_contact::core
{
/// A solved patch, as input of growOverMissedPressure().
struct SolvedPatch
{
  const Grid& grid;                 ///< grid of the solution
  const Eigen::ArrayXXd& pressure;  ///< [Pa]
  double modulus;                   ///< contact modulus E* [Pa]
  double penetration;               ///< penetration of the axle below the first touch [m]
};

/// Checks the overlap interval beyond the grid of a patch. Pressure was missed (for example a second lobe) where the
/// undeformed bodies overlap by more than the displacement that the pressure of the patch causes there. Widens the
/// extent of the patch over such positions. For a yawed wheel, lengthens it to the position in front of the grid or
/// behind it at which the wheel comes nearest to the rail.
/// @param stations  stations of the interval at which the undeformed bodies overlap; stations over the columns of the
/// grid are used for a yawed wheel only
/// @pre The pressure is not zero everywhere.
/// @return true if pressure was missed
bool growOverMissedPressure(const SolvedPatch& solved, const PlacedWheel& wheel, const std::vector<Station>& stations,
                            WheelPatch& patch);
}  // namespace wheel_rail_contact::core
