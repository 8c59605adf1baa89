// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// A column of a gap as a parabola along x.
struct Strip
{
  double gap = 0;   ///< lowest [m]
  double x = 0;     ///< where [m]
  double bend = 0;  ///< coefficient of x² [1/m]
};

/// Columns of a gap, some more beyond its grid on either side, and its deepest place, which may lie between two
/// columns.
struct StripGap
{
  std::vector<Strip> strips;  ///< by rising y
  double y0 = 0, dy = 0;      ///< of the first strip, and from one to the next [m]
  Strip deepest;
  double y = 0;  ///< of the deepest place [m]
};

/// Fits the columns: parabolas through three of their cells (two on a symmetric grid). Beyond the grid the gap goes on
/// with the curvature it has at its edge, for the overlap may be wider than the contact; it is closed off where it
/// would fall or bend downwards. Needs 3 × 3 cells (symmetric: 2 stored rows); false if there are fewer.
bool fitStrips(const PatchGap& patch, StripGap& gap);

/// Contact area and pressure by Kik and Piotrowski, see kik_piotrowski.h.
struct StripArea
{
  bool sound = true;             ///< every loaded strip opens along x
  double level = 0;              ///< gap below which strips are loaded [m]
  double half_length = 0;        ///< of the strip through the deepest place, uncorrected [m]
  double width = 0;              ///< uncorrected [m]
  double along = 1, across = 1;  ///< factors of the shape correction [-]
  double pressure = 0;           ///< in the deepest place [Pa]
  double force = 0;              ///< [N]
  double area = 0;               ///< [m²]
};

/// Area and pressure at a patch's own approach [m]; force zero where that is not positive.
StripArea stripAreaAt(const StripGap& gap, double modulus, double approach);

/// Pressure at the cells' centres.
void fillPressure(const Grid& grid, const StripGap& gap, const StripArea& area, Eigen::ArrayXXd& pressure);
}  // namespace wheel_rail_contact::core
