// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/patch_columns.h"

#include <algorithm>

#include "core/balance/tuning.h"
#include "core/normal/estimate/unseen_slope.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Slope of the gap across the track at the middle of a column: on the normal of a rail that turns by k per unit of its
/// arc, a body at the height g moves past by 1 - k g.
double gapSlope(const std::vector<SurfaceColumn>& columns, const PatchGap& patch, Eigen::Index j)
{
  const auto at = [&](Eigen::Index i) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(i)]; };
  const double turn = at(j + 1).turnFrom(at(j - 1)) / (2 * patch.grid.dy);
  const Eigen::Index middle = patch.grid.symmetric ? 0 : patch.gap.rows() / 2;
  return at(j).wheel_slope * (1 - turn * patch.gap(middle, j));
}
}  // namespace

void leaveOutWalls(const std::vector<SurfaceColumn>& columns, PatchGap& patch)
{
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    if (columns[static_cast<std::size_t>(j)].perUp() < tuning::smallest_opening)
    {
      patch.gap.col(j).setConstant(no_body_gap);
    }
  }
}

void setNormals(const std::vector<SurfaceColumn>& columns, PatchGap& patch, ColumnNormals& normals)
{
  const auto at = [&](Eigen::Index j) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(j)]; };
  const auto lowest = [&](Eigen::Index j) { return patch.gap.col(j).minCoeff(); };
  Eigen::Index row = 0, deepest = 0;
  patch.gap.minCoeff(&row, &deepest);
  patch.weight = std::max(at(deepest).perUp(), tuning::smallest_opening);
  normals.weight.resize(patch.grid.ny);
  double turn_least = 0, turn_most = 0;
  for (Eigen::Index j = 0; j < patch.grid.ny; ++j)
  {
    normals.weight[j] = std::max(at(j).perUp(), tuning::smallest_opening) / patch.weight;
    const double turn = lowest(j) < 0 ? at(j).turnFrom(at(deepest)) : 0;
    turn_least = std::min(turn_least, turn);
    turn_most = std::max(turn_most, turn);
  }
  const bool turns = turn_most - turn_least > tuning::plane_turn;
  normals.turn.setZero(patch.grid.ny);
  for (Eigen::Index j = 0; turns && j < patch.grid.ny; ++j)
  {
    normals.turn[j] = at(j).angle() - at(deepest).angle();
  }
}

void setUnseenSlope(const std::vector<SurfaceColumn>& columns, PatchGap& patch)
{
  fillUnseenSlope(patch, [&](Eigen::Index j) { return gapSlope(columns, patch, j); });
}
}  // namespace wheel_rail_contact::core
