// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/balance/wheel_patch.h"

namespace wheel_rail_contact::core
{
/// A solved patch as missed pressure is looked for beside it.
struct SolvedPatch
{
  const Grid& grid;                 ///< it was solved on
  const Eigen::ArrayXXd& pressure;  ///< [Pa]
  double modulus;                   ///< contact modulus E* [Pa]
  double penetration;               ///< of the axle below the first touch [m]
};

/// Looks at the stretch beyond a patch's grid: where the undeformed bodies overlap by more than its pressure pushes
/// them apart there, pressure was missed (a second lobe, say). Widens the patch's extent over such places, and
/// lengthens it where a yawed wheel comes nearest to the rail ahead of the grid or behind it.
/// @param stations  where the undeformed bodies overlap in the stretch; those over the grid's columns count for a yawed
///                  wheel only
/// The pressure must not be zero everywhere. @return true if pressure was missed.
bool growOverMissedPressure(const SolvedPatch& solved, const PlacedWheel& wheel, const std::vector<Station>& stations,
                            WheelPatch& patch);
}  // namespace wheel_rail_contact::core
