// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/contact_iteration.h"

#include <algorithm>

#include "core/constants.h"

namespace wheel_rail_contact::core
{
/// If the trial point was clipped, a step along the chord that is longer than this share is extended to the whole
/// chord. The clipped cells then leave the contact at once. The energy decreases for any value above 1/2.
constexpr double whole_chord = 0.6;

/// Limits for the change of the trial length in one step, and for the length itself (1: the preconditioner is the exact
/// inverse).
constexpr double shortest_change = 0.25, longest_change = 2, shortest_trial = 0.02, longest_trial = 3;

/// A relative decrease of a pressure within this of 1 is taken as a decrease to zero.
constexpr double rounding = 1e-9;

/// Number of products without a new lowest residual after which the iteration is regarded as stalled.
constexpr int patience = 40;

/// A trial point is accepted only if the slope of the energy along the chord is at least this share of the slope of the
/// unclipped direction. Otherwise up to most_attempts shorter ones are tried.
constexpr double enough_slope = 0.2;
constexpr int most_attempts = 2;

void ContactIteration::begin(const NormalProblem& problem, const CurvedProblem* curved, OperatorCache& cache)
{
  problem_ = &problem;
  load_controlled_ = problem.control == NormalProblem::Control::load;
  approach_ = problem.value;
  const int length = layOut(problem, &cache, patches_);
  for (LaneBuffer* field : {&p_, &u_, &gap_, &r_, &z_, &s_, &last_, &q_})
  {
    field->resize(length);
  }
  for (LaneBuffer* field : {&p_, &u_, &s_, &q_})
  {
    std::fill_n(field->data(), length, 0.0);
  }
  std::fill_n(gap_.data(), length, no_surface_gap);
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    workspace_.reserve(*patches_[k].influence);
    toField(patches_[k], 1, problem.patches[k].gap, gap_);
  }
  columns_.begin(curved, patches_, length, gap_);
  residual_ = 1;
  s_q_ = 0;
  trial_length_ = 1;
  best_ = infinity;
  best_at_ = 0;
  products_ = 0;
}

bool ContactIteration::start(const NormalSolution* earlier)
{
  Start found = earlier ? warmStart(*problem_, patches_, *earlier, p_, u_) : Start::none;
  if (found == Start::complete && (columns_.turned() || columns_.coupled()))
  {
    found = Start::pressure;  // the displacement was compared with the product for equal normals, without coupling
  }
  if (found != Start::none && columns_.scaled())
  {
    columns_.scale(p_, u_);
    if (load_controlled_)
    {
      scaleToLoad(*problem_, patches_, p_, &u_);
    }
  }
  if (found == Start::none)
  {
    found = coldStart(*problem_, patches_, gap_, p_);
  }
  if (found == Start::pressure)
  {
    multiply(p_, u_);
  }
  if (found == Start::none)
  {
    return false;
  }
  if (!load_controlled_)
  {
    scaleToApproach();
  }
  return true;
}

SolveStatus ContactIteration::iterate()
{
  advance(0);
  updateResidual();
  SolveStatus status = SolveStatus::converged;
  while (shouldContinue(status))
  {
    const double slope = chooseStep();
    if (!(slope > 0))
    {
      return SolveStatus::stalled;
    }
    multiply(s_, q_);
    double length = 0;
    if (!stepLength(slope, length))
    {
      return SolveStatus::indefinite;
    }
    advance(length);
    updateResidual();
  }
  return status;
}

/// Checks the residual. Returns false at the end of the iteration and sets `status` to the reason.
bool ContactIteration::shouldContinue(SolveStatus& status)
{
  if (residual_ <= options_.residual)
  {
    status = SolveStatus::converged;
    return false;
  }
  if (residual_ < best_)
  {
    best_ = residual_;
    best_at_ = products_;
  }
  status = products_ >= options_.max_products ? SolveStatus::iteration_limit : SolveStatus::stalled;
  return products_ < options_.max_products && products_ - best_at_ <= patience;
}

void ContactIteration::multiply(const LaneBuffer& in, LaneBuffer& out)
{
  columns_.multiply(patches_, in, out, workspace_);
  ++products_;
}

/// Scales the first pressure to the lowest energy at the given approach.
void ContactIteration::scaleToApproach()
{
  double work = 0, stored = 0;
  for (const PatchLayout& patch : patches_)
  {
    const double* p = p_.data() + patch.begin;
    const double sum = kernels_.sum(patch.size, p), closing = kernels_.dot(patch.size, p, gap_.data() + patch.begin);
    work += patch.force * (patch.weight * approach_ * sum - closing);
    stored += patch.force * kernels_.dot(patch.size, p, u_.data() + patch.begin);
  }
  if (work > 0 && stored > 0)
  {
    for (const PatchLayout& patch : patches_)
    {
      kernels_.scale(patch.size, work / stored, p_.data() + patch.begin);
      kernels_.scale(patch.size, work / stored, u_.data() + patch.begin);
    }
  }
}

/// Moves along the step. In load control, computes the approach.
void ContactIteration::advance(double length)
{
  double sum = 0, weights = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const CellSum cells = kernels_.advance(patch.size, length, s_.data() + at, q_.data() + at, gap_.data() + at,
                                           p_.data() + at, u_.data() + at);
    sum += patch.force * patch.weight * cells.sum;
    weights += patch.force * patch.weight * patch.weight * cells.count;
  }
  if (load_controlled_)
  {
    approach_ = sum / weights;
  }
}

void ContactIteration::updateResidual()
{
  double worst = 0, depth = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const double own_approach = patch.weight * approach_;
    const Violation violation =
        kernels_.residual(patch.size, own_approach, p_.data() + at, u_.data() + at, gap_.data() + at, r_.data() + at);
    worst = std::max({worst, violation.inside, violation.outside});
    depth = std::max(depth, own_approach - patch.least_gap);
  }
  residual_ = worst / depth;
}

/// Sets the step s_ to the chord to a trial point. Returns the decrease of the energy per length along it (zero: no
/// such chord found).
///
/// The preconditioned direction, clipped at the bounds, nearly always decreases the energy. If it does not, a shorter
/// trial step does in most cases, and the plain gradient in all cases.
double ContactIteration::chooseStep()
{
  std::swap(s_, last_);
  TrialStep step = precondition();
  double slope = chord(z_, step);
  step.beta = 0;
  step.shift = 0;
  for (int attempt = 0; attempt < most_attempts && !(slope > enough_slope * step.length * z_r_); ++attempt)
  {
    slope = chord(z_, step);
    step.length *= shortest_change;
  }
  return slope > enough_slope * step.length * z_r_ ? slope : gradientChord();
}

/// Computes z and the share of the last step in the next one that makes both conjugate.
TrialStep ContactIteration::precondition()
{
  double weights = 0, sum_z = 0, sum_q = 0, z_q = 0;
  z_r_ = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    columns_.precondition(patch, r_, z_, workspace_);
    const MaskedSums sums = kernels_.masked_sums(patch.size, r_.data() + at, z_.data() + at, q_.data() + at);
    weights += patch.force * patch.weight * patch.weight * sums.count;
    sum_z += patch.force * patch.weight * sums.z;
    sum_q += patch.force * patch.weight * sums.q;
    z_q += patch.force * sums.z_q;
    z_r_ += patch.force * sums.z_r;
  }
  TrialStep step;
  step.length = trial_length_;
  step.shift = load_controlled_ ? sum_z / weights : 0;
  step.beta = s_q_ > 0 ? (step.shift * sum_q - z_q) / s_q_ : 0;
  return step;
}

/// Sets s_ to the chord from p to the trial point along `direction`. The pressures of the trial point are clipped at
/// zero and scaled to the load.
double ContactIteration::chord(const LaneBuffer& direction, const TrialStep& step)
{
  double load = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    TrialStep own = step;
    own.shift = patch.weight * step.shift;
    load += patch.force * patch.weight *
            kernels_.trial(patch.size, own, r_.data() + at, p_.data() + at, direction.data() + at, last_.data() + at,
                           s_.data() + at);
  }
  const double scale = load_controlled_ ? problem_->value / load : 1;
  double slope = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    slope += patch.force * kernels_.chord(patch.size, scale, r_.data() + at, p_.data() + at, s_.data() + at);
  }
  return slope;
}

/// Same as chooseStep(), along the plain residual.
///
/// The residual is taken at the approach for which it is orthogonal to the pressure. Scaling the trial point to the
/// load then does no work, and the share of each cell in the slope is positive. The slope vanishes only at a solution.
double ContactIteration::gradientChord()
{
  double work = 0, load = 0;
  for (const PatchLayout& patch : patches_)
  {
    const double* p = p_.data() + patch.begin;
    work += patch.force * (kernels_.dot(patch.size, p, u_.data() + patch.begin) +
                           kernels_.dot(patch.size, p, gap_.data() + patch.begin));
    load += patch.force * patch.weight * kernels_.sum(patch.size, p);
  }
  const double level = load_controlled_ ? work / load : approach_;
  double r_z = 0, r_r = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    r_z += kernels_.dot(patch.size, r_.data() + at, z_.data() + at);
    r_r += kernels_.dot(patch.size, r_.data() + at, r_.data() + at);
    kernels_.residual(patch.size, patch.weight * level, p_.data() + at, u_.data() + at, gap_.data() + at,
                      r_.data() + at);
  }
  TrialStep step;
  step.length = trial_length_ * r_z / r_r;
  return chord(r_, step);
}

/// Length of the step s_ to the lowest energy, within p >= 0. Returns false if the energy has no minimum along the
/// step.
bool ContactIteration::stepLength(double slope, double& length)
{
  double fall = 0;
  s_q_ = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const StepSums sums = kernels_.step_sums(patch.size, p_.data() + at, s_.data() + at, q_.data() + at);
    s_q_ += patch.force * sums.s_q;
    fall = std::max(fall, sums.fall);
  }
  if (!(s_q_ > 0))
  {
    return false;
  }
  length = slope / s_q_;
  trial_length_ =
      std::clamp(trial_length_ * std::clamp(length, shortest_change, longest_change), shortest_trial, longest_trial);
  if (fall > 1 - rounding)  // the trial point was clipped
  {
    length = length > whole_chord ? 1 : length;
    s_q_ = 0;
  }
  else if (fall * length > 1)
  {
    length = 1 / fall;
  }
  return true;
}
}  // namespace wheel_rail_contact::core
