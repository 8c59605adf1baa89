// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// Where in its grid a pressure lies. Edges are where the square of the crest's pressure, carried on from the two
/// outermost loaded cells, falls to zero (it is linear in the distance from the edge of any smooth contact).
struct PressureExtent
{
  bool empty = true;
  int first_column = 0, last_column = -1;  ///< with pressure
  int first_row = 0, last_row = -1;        ///< with pressure
  double y_begin = 0, y_end = 0;           ///< edges across, patch frame [m]
  double half_length = 0;                  ///< largest |x| of the edges along [m]
};

PressureExtent findExtent(const Grid& grid, const Eigen::ArrayXXd& pressure);
}  // namespace wheel_rail_contact
