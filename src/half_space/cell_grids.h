// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "half_space/loaded_wheel.h"

namespace wheel_rail_contact::core::half_space
{
/// Numbers of cells on half a contact, x > 0.
struct CellCount
{
  int rows = 28;     ///< along the track
  int columns = 56;  ///< across the track
};

/// Cells on which finite elements and half-spaces are compared, on the surface of the rail; for one contact under all
/// loads.
struct CellGrid
{
  Grid grid;  ///< symmetric
  SurfaceOrigin origin;
};

/// Grids that cover the pressed parts of all loads with a margin.
/// @param parts  of each load; parts of different loads that overlap are in one grid
/// @throw std::invalid_argument if a number of cells is below 2
std::vector<CellGrid> cellGrids(const PlacedRail& rail, const std::vector<std::vector<PressedPart>>& parts,
                                const CellCount& count);
}  // namespace wheel_rail_contact::core::half_space
