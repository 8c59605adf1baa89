// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/lanes.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/patch_fields.h"
#include "core/normal/solvers/starting_pressure.h"
#include "core/normal/solvers/support_field.h"

namespace wheel_rail_contact::core
{
/// The iteration behind ConjugateGradients. Fields hold the patches one after another, pressures as lengths (see
/// PatchLayout).
class ContactIteration
{
 public:
  explicit ContactIteration(const ConjugateGradientsOptions& options) : options_(options) {}

  /// Prepares for a valid problem, which must outlive the solve: fields, gap, no pressure.
  void begin(const NormalProblem& problem, OperatorCache& cache);

  /// Finds a first pressure, from `earlier` if that is given and fits. Returns false if nothing touches.
  bool start(const NormalSolution* earlier);

  SolveStatus iterate();

  /// Takes the support's share out of the displacement. After it only the results may be asked for.
  void end();

  const std::vector<PatchLayout>& patches() const { return patches_; }
  const LaneBuffer& pressure() const { return p_; }
  /// Of the half-spaces, after end().
  const LaneBuffer& displacement() const { return u_; }
  /// The support's coordinates, after end().
  const Eigen::Vector3d& support() const { return support_coordinates_; }
  double approach() const { return approach_; }
  double residual() const { return residual_; }
  int products() const { return products_; }

 private:
  bool goOn(SolveStatus& status);
  void multiply(const LaneBuffer& in, LaneBuffer& out);
  void deflectTo(const LaneBuffer& pressure, LaneBuffer& displacement);
  void fitToApproach();
  void advance(double length);
  double deflected() const;
  void updateResidual();
  double aim();
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

  SupportField support_;
  Eigen::Vector3d support_coordinates_ = Eigen::Vector3d::Zero();
  LaneBuffer p_, u_, gap_;  ///< pressure, displacement (with what the support's way from its place opens), gap
  LaneBuffer r_, z_;        ///< residual -w on the cells that may move, and its preconditioned form
  LaneBuffer s_, last_,
      q_;                    ///< step, the one before, displacement of the step multiplied last
  double approach_ = 0;      ///< [m]
  double residual_ = 1;      ///< relative [-]
  double z_r_ = 0;           ///< product of z and r: slope of the energy along z
  double s_q_ = 0;           ///< curvature along the last step; 0: none to be conjugate to
  double trial_length_ = 1;  ///< expected length of the next step, in z
  double best_ = 0;          ///< lowest residual so far
  int products_ = 0, best_at_ = 0;
};
}  // namespace wheel_rail_contact::core
