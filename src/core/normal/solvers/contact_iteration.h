// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/lanes.h"
#include "core/normal/solvers/column_fields.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/patch_fields.h"
#include "core/normal/solvers/starting_pressure.h"

namespace wheel_rail_contact::core
{
/// Iteration of ConjugateGradients. Fields contain the patches one after another. Pressures are stored as lengths (see
/// PatchLayout).
class ContactIteration
{
 public:
  explicit ContactIteration(const ConjugateGradientsOptions& options) : options_(options) {}

  /// Sets fields and gap for a valid problem, without pressure. The problem must exist until the end of the solution.
  /// @param curved  the same problem, or null if it is plane
  void begin(const NormalProblem& problem, const CurvedProblem* curved, OperatorCache& cache);

  /// Finds a first pressure, from `earlier` if it is given and has the same shapes. Returns false if nothing touches.
  bool start(const NormalSolution* earlier);

  SolveStatus iterate();

  /// Removes the weights of the columns. Afterwards only the results may be read.
  void end() { columns_.unscale(p_, u_); }

  const std::vector<PatchLayout>& patches() const { return patches_; }
  const LaneBuffer& pressure() const { return p_; }
  /// Displacement of the half-spaces, after end().
  const LaneBuffer& displacement() const { return u_; }
  double approach() const { return approach_; }
  double residual() const { return residual_; }
  int products() const { return products_; }

 private:
  bool shouldContinue(SolveStatus& status);
  void multiply(const LaneBuffer& in, LaneBuffer& out);
  void scaleToApproach();
  void advance(double length);
  void updateResidual();
  double chooseStep();
  TrialStep precondition();
  double chord(const LaneBuffer& direction, const TrialStep& step);
  double gradientChord();
  bool stepLength(double slope, double& length);

  ConjugateGradientsOptions options_;
  InfluenceOperator::Workspace workspace_;
  const LaneKernels& kernels_ = laneKernels();

  const NormalProblem* problem_ = nullptr;
  bool load_controlled_ = true;
  std::vector<PatchLayout> patches_;

  ColumnFields columns_;
  LaneBuffer p_, u_, gap_;   ///< pressure, displacement, gap
  LaneBuffer r_, z_;         ///< residual -w on the cells that may move; its preconditioned form
  LaneBuffer s_, last_, q_;  ///< step, previous step, displacement by the step
  double approach_ = 0;      ///< [m]
  double residual_ = 1;      ///< relative [-]
  double z_r_ = 0;           ///< product of z and r: slope of the energy along z
  double s_q_ = 0;           ///< curvature along the last step; 0: the next one need not be conjugate
  double trial_length_ = 1;  ///< expected length of the next step, in units of z
  double best_ = 0;          ///< lowest residual so far
  int products_ = 0, best_at_ = 0;
};
}  // namespace wheel_rail_contact::core
