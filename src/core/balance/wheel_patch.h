// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/balance/pressure_extent.h"
#include "core/track/contact_search.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
/// Number of cells of a patch's grid.
struct GridSize
{
  int along = 0;   ///< along the track
  int across = 0;  ///< across the track
};

/// Equality of both numbers.
inline bool operator==(const GridSize& one, const GridSize& other)
{
  return one.along == other.along && one.across == other.across;
}

/// A solved patch, except its pressure.
struct WheelPatch
{
  OverlapInterval interval;        ///< overlap interval of the patch
  double touch_gap = 0;            ///< vertical gap at the first touch of the whole wheel [m]
  double least_gap = 0;            ///< leastGap() along the normal, with the axle at the first touch [m]
  double half_overlap = 0;         ///< half-length of the overlap along the track [m]
  double expected_width = 0;       ///< expected width of the pressure when the grid was laid [m]
  double expected_length = 0;      ///< the same along the track [m]
  ContactPlane plane;              ///< plane of the solution
  double turned = 0;               ///< turn of the plane after the last solution of the same state [rad]
  std::vector<GapColumn> columns;  ///< one for each column of the grid
  PressureExtent extent;           ///< extent of the pressure
  double slope = 0;                ///< pressure-weighted mean slope of the common normal relative to the plane [-]
  double center_x = 0;             ///< x of the pressure centre, patch frame [m]
  double center_y = 0;             ///< y of the pressure centre, patch frame [m]
};

/// Rail profile parameter at position `t` of the patch frame [m], interpolated between the columns and extrapolated
/// beyond them.
double railParameter(const Grid& grid, const std::vector<GapColumn>& columns, double t);

/// Minimum of a gap [m], also between the cells: from parabolas along and across the track through the lowest cell and
/// its neighbours.
double leastGap(const Grid& grid, const Eigen::ArrayXXd& gap);

/// Determines centre, mean normal and extent of the pressure.
void measurePatch(const Grid& grid, const Eigen::ArrayXXd& pressure, WheelPatch& patch);

/// True if all of the pressure lies on both profiles.
bool onProfiles(const WheelPatch& patch, const Profile& wheel, const Profile& rail);
}  // namespace wheel_rail_contact::core
