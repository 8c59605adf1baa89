// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/balance/wheel_patch.h"

namespace wheel_rail_contact::core
{
/// Where a contact lay in its overlapping stretch.
struct PatchMemory
{
  std::optional<OverlapInterval> interval;  ///< stretch expected at the solved descent, the wheel being where it was
  double rail_u = 0;                        ///< place of the contact on the rail, to know it again [m]
  double center = 0;       ///< middle of the pressure, in half-widths of the stretch from its middle [-]
  double begin = 0;        ///< edges of the pressure, likewise [-]
  double end = 0;          ///< likewise [-]
  double half_length = 0;  ///< of the pressure along the track, in half-lengths of the overlap [-]
  double turn = 0;         ///< plane against the chord of the stretch [rad]
  double turned = 0;       ///< by how much this memory has turned the plane; for the same state, no swinging [rad]
  double shift_x = 0;      ///< pressure's centre against the wheel's contact locus [m]
  Grid grid;               ///< as laid after this memory; no cells: not laid yet
  double width = 0;        ///< of the pressure as expected when the grid was laid [m]
  double length = 0;       ///< likewise, along the track [m]
};

/// What to expect of a contact never seen before.
PatchMemory firstGuess(const OverlapInterval& interval);

/// What to keep of a solved patch. `grown`: factor by which the solved descent makes the stretch larger than the
/// descent it was found for [-]. Sides at which the grid cut the pressure off are widened.
PatchMemory remember(const PlacedWheel& wheel, const PlacedRail& rail, const WheelPatch& patch, const Grid& grid,
                     double grown);

/// Lays plane and grid over the patch's stretch (patch.zone and patch.half_overlap are given), as remembered; the
/// memory keeps the grid. `held`: the wheel is where it was when the memory was made, but for its height; the patch
/// then lies where it was, and does not move with a stretch whose far end comes and goes with the descent.
void layPatch(const PlacedWheel& wheel, const PlacedRail& rail, const GridSize& size, bool held, PatchMemory& memory,
              WheelPatch& patch, Grid& grid);
}  // namespace wheel_rail_contact::core
