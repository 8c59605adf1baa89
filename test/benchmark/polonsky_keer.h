// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/normal/operator/influence_operator.h"
#include "core/normal/operator/lanes.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact
{
/// Conjugate gradients as Polonsky and Keer 1999 (Wear 231, 206–219) print them, without preconditioner, to compare
/// with: two products with the influence matrix an iteration. One patch of weight one, load given.
class PolonskyKeer
{
 public:
  /// Sets out from the square root of the overlap below the grid's mean gap.
  /// @param residual  as that of ConjugateGradients, at which it ends
  explicit PolonskyKeer(double residual) : residual_(residual) {}

  /// @return false if it did not get there in 500 iterations.
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
  core::LaneBuffer p_, gap_, g_, t_, q_;  ///< pressure, gap, gap after deformation, direction, its displacement
  int size_ = 0, products_ = 0;
  double approach_ = 0, least_gap_ = 0;
  double last_norm_ = 0;  ///< of g over the contact; 0: start along the gradient
};
}  // namespace wheel_rail_contact
