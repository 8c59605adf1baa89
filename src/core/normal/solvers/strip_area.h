// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Parabola along x that represents a column of a gap.
struct Strip
{
  double gap = 0;   ///< lowest value [m]
  double x = 0;     ///< position of the lowest value [m]
  double bend = 0;  ///< coefficient of x² [1/m]
};

/// Columns of a gap, with additional ones beyond the grid on both sides, and its deepest point. The deepest point may
/// lie between two columns.
struct StripGap
{
  std::vector<Strip> strips;  ///< by increasing y
  double y0 = 0, dy = 0;      ///< y of the first strip, distance of neighbouring strips [m]
  Strip deepest;
  double y = 0;  ///< y of the deepest point [m]
};

/// Fits parabolas through three cells of each column (two on a symmetric grid). Beyond the grid the gap is extrapolated
/// with the curvature at its edge, because the overlap may be wider than the contact. It is closed off where the
/// extrapolation would decrease or bend downwards. Returns false if the grid has fewer than 3 × 3 cells (symmetric: 2
/// stored rows).
bool fitStrips(const PatchGap& patch, StripGap& gap);

/// Contact area and pressure of Kik and Piotrowski, see kik_piotrowski.h.
struct StripArea
{
  bool sound = true;             ///< every loaded strip opens along x
  double level = 0;              ///< level of the gap below which strips are loaded [m]
  double half_length = 0;        ///< of the strip through the deepest point, uncorrected [m]
  double width = 0;              ///< uncorrected [m]
  double along = 1, across = 1;  ///< factors of the shape correction [-]
  double pressure = 0;           ///< at the deepest point [Pa]
  double force = 0;              ///< [N]
  double area = 0;               ///< [m²]
};

/// Area and pressure at the own approach of a patch [m]. The force is zero if the approach is not positive.
StripArea stripAreaAt(const StripGap& gap, double modulus, double approach);

/// Pressure at the cells' centres.
void fillPressure(const Grid& grid, const StripGap& gap, const StripArea& area, Eigen::ArrayXXd& pressure);
}  // namespace wheel_rail_contact::core
