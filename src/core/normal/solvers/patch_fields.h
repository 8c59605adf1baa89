// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/operator/lanes.h"
#include "core/normal/operator/operator_cache.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Where a patch's fields lie in the solver's arrays, and what turns them into pascals and newtons.
///
/// In the arrays a pressure p stands as the length p dy / (pi E*), so that the operator's product with it is the
/// displacement [m] itself.
struct PatchLayout
{
  std::shared_ptr<const InfluenceOperator> influence;  ///< null: cells in the order of the gap arrays
  Grid grid;
  int begin = 0, size = 0;  ///< range in the arrays
  double weight = 1;        ///< share of the approach and of the load [-]
  double stiffness = 0;     ///< pi E* / dy [Pa/m]: from a length in the arrays to a pressure
  double force = 0;         ///< normal force of a length 1 m in one stored cell [N/m]
  double least_gap = 0;     ///< [m]
};

/// Gap in cells that only pad the arrays: never touched [m].
constexpr double kNoSurface = 1e300;

/// True if the problem can be solved at all: cells, finite gaps, weights, modulus and value in range.
bool isValid(const NormalProblem& problem);

/// Lays out the patches one after another: with a cache in their operators' order of cells, without one in that of the
/// gap arrays. Returns the arrays' length.
int layOut(const NormalProblem& problem, OperatorCache* cache, std::vector<PatchLayout>& patches);

/// Writes factor * values into the patch's cells of a field; padding stays as it is.
void toField(const PatchLayout& patch, double factor, const Eigen::ArrayXXd& values, LaneBuffer& field);

/// Writes a value for each column of cells into all cells of it; only for patches laid out with a cache.
void columnsToField(const PatchLayout& patch, const Eigen::Ref<const Eigen::ArrayXd>& values, LaneBuffer& field);

/// Writes factor * field into `values`, rows × columns.
void fromField(const PatchLayout& patch, double factor, const LaneBuffer& field, Eigen::ArrayXXd& values);
}  // namespace wheel_rail_contact::core
