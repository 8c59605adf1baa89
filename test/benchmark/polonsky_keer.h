// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/normal/operator/influence_operator.h"
#include "core/normal/operator/lanes.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact
{
/// Conjugate gradients as published by Polonsky and Keer (1999, Wear 231, 206–219), without preconditioner, for
/// comparison. Each iteration takes two products with the influence matrix. Solves problems with one patch of weight 1
/// under a given load.
class PolonskyKeer
{
 public:
  /// @param residual at which the iteration ends, as ConjugateGradientsOptions::residual
  explicit PolonskyKeer(double residual) : residual_(residual) {}

  /// Solves a problem. The initial pressure is proportional to √(mean gap − gap) where the gap is below its mean.
  /// @return false if the residual is not reached within 500 iterations, or if a step length is not positive
  bool solve(const core::NormalProblem& problem);

  double approach() const { return approach_; }
  int products() const { return products_; }

 private:
  void begin(const core::NormalProblem& problem);
  void start(double load);
  void scaleTo(double load);
  double shiftToContact(core::LaneBuffer& field) const;
  double measure();
  bool step();

  double residual_;
  std::shared_ptr<const core::InfluenceOperator> influence_;
  core::InfluenceOperator::Workspace workspace_;
  core::LaneBuffer p_, gap_, g_, t_, q_;  ///< pressure, gap, deformed gap, direction, displacement of the direction
  int size_ = 0, products_ = 0;
  double approach_ = 0, least_gap_ = 0;
  double last_norm_ = 0;  ///< sum of g² over the contact; 0: the next step follows the gradient
};
}  // namespace wheel_rail_contact
