// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/balance/wheel_patch.h"

namespace wheel_rail_contact::core
{
/// Position of a contact in its overlap interval.
struct PatchMemory
{
  std::optional<OverlapInterval> interval;  ///< expected at the solved penetration and the same pose
  double rail_u = 0;                        ///< rail parameter of the contact, to recognise it [m]
  double center = 0;       ///< centre of the pressure, from the middle of the interval, in its half-widths [-]
  double begin = 0;        ///< first edge of the pressure, in the same unit [-]
  double end = 0;          ///< second edge of the pressure, in the same unit [-]
  double half_length = 0;  ///< half-length of the pressure along the track, in half-lengths of the overlap [-]
  double turn = 0;         ///< angle of the plane relative to the chord of the interval [rad]
  double turned = 0;       ///< last turn of the plane in the same state, to damp oscillations [rad]
  double shift_x = 0;      ///< position of the pressure centre relative to the contact locus of the wheel [m]
  Grid grid;               ///< grid laid from this memory; no cells: not laid yet
  double width = 0;        ///< expected width of the pressure when the grid was laid [m]
  double length = 0;       ///< the same along the track [m]
};

/// Initial guess for a new contact.
PatchMemory firstGuess(const OverlapInterval& interval);

/// Memory of a solved patch. The sides at which the grid cut the pressure off are widened.
/// @param grown  factor by which the solved penetration enlarges the interval, compared with the penetration for which
/// it was found [-]
PatchMemory remember(const PlacedWheel& wheel, const PlacedRail& rail, const WheelPatch& patch, const Grid& grid,
                     double grown);

/// Lays plane and grid over the interval of the patch (patch.interval and patch.half_overlap are given), as stored in
/// the memory. Stores the grid in the memory.
/// @param held  the pose of the wheel is that of the memory, except for the height. The patch then keeps its position
/// and does not move with an interval whose far end depends on the penetration.
void layPatch(const PlacedWheel& wheel, const PlacedRail& rail, const GridSize& size, bool held, PatchMemory& memory,
              WheelPatch& patch, Grid& grid);
}  // namespace wheel_rail_contact::core
