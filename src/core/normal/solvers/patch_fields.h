// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/operator/lanes.h"
#include "core/normal/operator/operator_cache.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// Position of the fields of a patch in the arrays of the solver, and their conversion to pascals and newtons.
///
/// In the arrays a pressure p is stored as the length p dy / (pi E*). The product of the operator with it is the
/// displacement [m].
struct PatchLayout
{
  std::shared_ptr<const InfluenceOperator> influence;  ///< null: cells in the order of the gap arrays
  Grid grid;
  int begin = 0, size = 0;  ///< range in the arrays
  double weight = 1;        ///< share of the approach and of the load [-]
  double stiffness = 0;     ///< pi E* / dy [Pa/m]: factor from a stored length to a pressure
  double force = 0;         ///< normal force of a stored length of 1 m in one stored cell [N/m]
  double least_gap = 0;     ///< smallest gap [m]
};

/// Gap of padding cells, which never touch [m].
constexpr double no_surface_gap = 1e300;

/// True if the problem is valid: cells, finite gaps, and weights, modulus and value in range.
bool isValid(const NormalProblem& problem);

/// True if normals and coupling of a problem fit its columns, and are in range.
bool hasValidSurface(const CurvedProblem& problem);

/// Arranges the patches one after another. With a cache, cells are in the order of the operators, otherwise in that of
/// the gap arrays. Returns the length of the arrays.
int layOut(const NormalProblem& problem, OperatorCache* cache, std::vector<PatchLayout>& patches);

/// Writes factor * values to the cells of the patch in a field. Padding is not changed.
void toField(const PatchLayout& patch, double factor, const Eigen::ArrayXXd& values, LaneBuffer& field);

/// Writes the value of each column to all of its cells. Only for patches arranged with a cache.
void columnsToField(const PatchLayout& patch, const Eigen::Ref<const Eigen::ArrayXd>& values, LaneBuffer& field);

/// Sets `sums` to the sum of the stored cells of each column of a field. Only for patches arranged with a cache.
void columnSums(const PatchLayout& patch, const LaneBuffer& field, Eigen::Ref<Eigen::VectorXd> sums);

/// Writes factor * field to `values` (rows × columns).
void fromField(const PatchLayout& patch, double factor, const LaneBuffer& field, Eigen::ArrayXXd& values);
}  // namespace wheel_rail_contact::core
