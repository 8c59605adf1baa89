// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/balance/pressure_extent.h"
#include "core/track/contact_search.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
/// Cells of the grid laid over a patch.
struct GridSize
{
  int along = 0;   ///< cells along the track
  int across = 0;  ///< cells across
};

/// True if both are the same.
inline bool operator==(const GridSize& one, const GridSize& other)
{
  return one.along == other.along && one.across == other.across;
}

/// One patch as solved, beside its pressure.
struct WheelPatch
{
  OverlapInterval interval;        ///< stretch it was laid over
  double touch_gap = 0;            ///< vertical gap at the first touch of the whole wheel [m]
  double least_gap = 0;            ///< leastGap() along the normal, the axle at the first touch [m]
  double half_overlap = 0;         ///< half-length of the overlap along the track [m]
  double expected_width = 0;       ///< of the pressure, for which the grid was laid [m]
  double expected_length = 0;      ///< likewise, along the track [m]
  ContactPlane plane;              ///< in which it was solved
  double turned = 0;               ///< by how much the plane was turned after the last solution of the same state [rad]
  std::vector<GapColumn> columns;  ///< one for each column of the grid
  PressureExtent extent;           ///< of the pressure
  double slope = 0;                ///< pressure-weighted mean of the common normal's slope against the plane [-]
  double center_x = 0;             ///< pressure's centre in the patch frame [m]
  double center_y = 0;             ///< [m]
};

/// Parameter of the rail's profile at place `t` of the patch frame [m], from the columns, carried on beyond them.
double railParameter(const Grid& grid, const std::vector<GapColumn>& columns, double t);

/// The least of a gap [m], between its cells by the parabolas along and across through the least one and its
/// neighbours.
double leastGap(const Grid& grid, const Eigen::ArrayXXd& gap);

/// Finds the pressure's centre, mean normal and extent.
void measurePatch(const Grid& grid, const Eigen::ArrayXXd& pressure, WheelPatch& patch);

/// True if all of the pressure lies on both profiles.
bool onProfiles(const WheelPatch& patch, const Profile& wheel, const Profile& rail);
}  // namespace wheel_rail_contact::core
