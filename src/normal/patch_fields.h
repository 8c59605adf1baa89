// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lanes.h"
#include "wheel_rail_contact/normal/operator_cache.h"
#include "wheel_rail_contact/normal/problem.h"

namespace wheel_rail_contact
{
/// Where a patch's fields lie in the solver's arrays, and what turns them into metres and newtons.
struct PatchLayout
{
  std::shared_ptr<const InfluenceOperator> influence;
  Grid grid;
  int begin = 0, size = 0;  ///< range in the arrays
  double compliance = 0;    ///< of the operator: dy / (pi E*) [m/Pa]
  double weight = 1;
  double cell_area = 0;  ///< [m²]
};

/// Gap in cells that only pad the arrays: never touched [m].
constexpr double kNoSurface = 1e300;

/// True if the problem can be solved at all: cells, finite gaps, weights, modulus and value in range.
bool isValid(const NormalProblem& problem);

/// Lays out the patches one after another; returns the arrays' length.
int layOut(const NormalProblem& problem, OperatorCache& cache, std::vector<PatchLayout>& patches);

/// Copies an Eigen array (rows × columns) to and from a field.
void toField(const PatchLayout& patch, const Eigen::ArrayXXd& values, double* field);
void fromField(const PatchLayout& patch, const double* field, Eigen::ArrayXXd& values);
}  // namespace wheel_rail_contact
