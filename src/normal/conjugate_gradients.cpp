// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/normal/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "lanes.h"
#include "patch_fields.h"
#include "pressure_measures.h"
#include "starting_pressure.h"

namespace wheel_rail_contact
{
namespace
{
/// A step along the chord to a clipped trial point is rounded up to the whole chord if the energy allows: then the
/// clipped cells leave the contact for good. Any value above 1/2 keeps the energy falling.
constexpr double kWholeChord = 0.6;

/// Products without a new lowest residual after which the iteration counts as stalled.
constexpr int kPatience = 40;

void check(const ConjugateGradientsOptions& options)
{
  if (!(options.residual > 0 && options.residual < 1))
  {
    throw std::invalid_argument("residual = " + std::to_string(options.residual) + ": must lie in (0, 1)");
  }
  if (options.max_products <= 0)
  {
    throw std::invalid_argument("max_products = " + std::to_string(options.max_products) + ": must be positive");
  }
}
}  // namespace

/// All state of a solve; fields hold the patches one after another, pressures as lengths (see PatchLayout).
class ConjugateGradients::Iteration
{
 public:
  explicit Iteration(const ConjugateGradientsOptions& options) : options_(options) {}

  OperatorCache& cache() { return cache_; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution);

 private:
  void begin(const NormalProblem& problem);
  SolveStatus iterate();
  bool goOn(SolveStatus& status);
  void multiply(const LaneBuffer& in, LaneBuffer& out);
  void fitToApproach();
  void advance(double length);
  void updateResidual();
  double precondition();
  bool aim(double beta, double trial_length);
  SolveStatus stepLength(bool clipped, double& length) const;
  void finish(SolveStatus status, NormalSolution& solution);

  ConjugateGradientsOptions options_;
  OperatorCache cache_;
  InfluenceOperator::Workspace workspace_;
  PressureMeasures measures_;
  const LaneKernels& kernels_ = laneKernels();

  const NormalProblem* problem_ = nullptr;
  bool load_controlled_ = true;
  std::vector<PatchLayout> patches_;
  LaneBuffer p_, u_, gap_;        ///< pressure, displacement, gap
  LaneBuffer r_, r_old_;          ///< residual -w on the cells that may move, now and one step before
  LaneBuffer z_, d_, q_, trial_;  ///< preconditioned residual, direction, its displacement, trial pressure
  double approach_ = 0;           ///< [m]
  double residual_ = 1;           ///< relative [-]
  double z_r_ = 0;                ///< inner product of the last z and r; 0: start afresh
  double best_ = 0;               ///< lowest residual so far
  int products_ = 0, best_at_ = 0;
};

void ConjugateGradients::Iteration::solve(const NormalProblem& problem, bool warm, NormalSolution& solution)
{
  solution.patches.resize(problem.patches.size());
  products_ = 0;
  residual_ = 1;
  if (!isValid(problem))
  {
    solution.status = SolveStatus::invalid_problem;
    solution.iterations = 0;
    return;
  }
  begin(problem);
  const bool started = (warm && warmStart(problem, patches_, solution, p_)) || coldStart(problem, patches_, gap_, p_);
  finish(started ? iterate() : SolveStatus::no_contact, solution);
}

void ConjugateGradients::Iteration::begin(const NormalProblem& problem)
{
  problem_ = &problem;
  load_controlled_ = problem.control == NormalProblem::Control::load;
  approach_ = problem.value;
  const int length = layOut(problem, cache_, patches_);
  for (LaneBuffer* field : {&p_, &u_, &gap_, &r_, &r_old_, &z_, &d_, &q_, &trial_})
  {
    field->resize(length);
  }
  std::fill_n(p_.data(), length, 0.0);
  std::fill_n(d_.data(), length, 0.0);
  std::fill_n(q_.data(), length, 0.0);
  std::fill_n(gap_.data(), length, kNoSurface);
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    workspace_.reserve(*patches_[k].influence);
    toField(patches_[k], 1, problem.patches[k].gap, gap_);
  }
  z_r_ = 0;
  best_ = std::numeric_limits<double>::infinity();
  best_at_ = 0;
}

SolveStatus ConjugateGradients::Iteration::iterate()
{
  multiply(p_, u_);
  if (!load_controlled_)
  {
    fitToApproach();
  }
  advance(0);
  updateResidual();
  double trial_length = 1;
  SolveStatus status = SolveStatus::converged;
  while (goOn(status))
  {
    const bool clipped = aim(precondition(), trial_length);
    multiply(d_, q_);
    double length = 0;
    status = stepLength(clipped, length);
    if (status != SolveStatus::converged)
    {
      return status;
    }
    advance(length);
    updateResidual();
    if (clipped)
    {
      z_r_ = 0;
    }
    else
    {
      trial_length = length;
    }
  }
  return status;
}

/// Looks at the residual: false at the end, whose reason is then in `status`.
bool ConjugateGradients::Iteration::goOn(SolveStatus& status)
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
  return products_ < options_.max_products && products_ - best_at_ <= kPatience;
}

void ConjugateGradients::Iteration::multiply(const LaneBuffer& in, LaneBuffer& out)
{
  for (const PatchLayout& patch : patches_)
  {
    patch.influence->multiply(in.data() + patch.begin, out.data() + patch.begin, workspace_);
  }
  ++products_;
}

/// Scales the first pressure to the least energy at the given approach.
void ConjugateGradients::Iteration::fitToApproach()
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

/// Moves along the direction and, in load control, finds the approach.
void ConjugateGradients::Iteration::advance(double length)
{
  double sum = 0, weights = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const CellSum cells = kernels_.advance(patch.size, length, d_.data() + at, q_.data() + at, gap_.data() + at,
                                           p_.data() + at, u_.data() + at);
    sum += patch.force * patch.weight * cells.sum;
    weights += patch.force * patch.weight * patch.weight * cells.count;
  }
  if (load_controlled_)
  {
    approach_ = sum / weights;
  }
}

void ConjugateGradients::Iteration::updateResidual()
{
  std::swap(r_, r_old_);
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

/// Computes z, free of load where that is given; returns the share of the last direction in the next one.
double ConjugateGradients::Iteration::precondition()
{
  double sum = 0, weights = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    patch.influence->precondition(r_.data() + at, z_.data() + at, workspace_);
    const CellSum cells = kernels_.maskedSum(patch.size, r_.data() + at, z_.data() + at);
    sum += patch.force * patch.weight * cells.sum;
    weights += patch.force * patch.weight * patch.weight * cells.count;
  }
  const double shift = load_controlled_ ? sum / weights : 0;
  double z_r = 0, z_r_old = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const DirectionSums sums =
        kernels_.project(patch.size, patch.weight * shift, r_.data() + at, r_old_.data() + at, z_.data() + at);
    z_r += patch.force * sums.z_r;
    z_r_old += patch.force * sums.z_r_old;
  }
  const double beta = z_r_ > 0 ? std::max(0.0, (z_r - z_r_old) / z_r_) : 0;
  z_r_ = z_r;
  return beta;
}

/// Sets the direction to the trial point p + length (z + beta d), with negative pressures cut and the load restored.
/// Returns whether any was cut.
bool ConjugateGradients::Iteration::aim(double beta, double trial_length)
{
  double load = 0, cut = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const CellSum sums = kernels_.trial(patch.size, beta, trial_length, p_.data() + at, z_.data() + at, d_.data() + at,
                                        trial_.data() + at);
    load += patch.force * patch.weight * sums.sum;
    cut += sums.count;
  }
  if (cut == 0)
  {
    return false;
  }
  const double scale = load_controlled_ ? problem_->value / load : 1;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    kernels_.chord(patch.size, scale, p_.data() + at, trial_.data() + at, d_.data() + at);
  }
  return true;
}

/// Length of the step to the least energy along the direction.
SolveStatus ConjugateGradients::Iteration::stepLength(bool clipped, double& length) const
{
  double r_d = 0, d_q = 0, fall = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const StepSums sums = kernels_.stepSums(patch.size, p_.data() + at, r_.data() + at, d_.data() + at, q_.data() + at);
    r_d += patch.force * sums.r_d;
    d_q += patch.force * sums.d_q;
    fall = std::max(fall, sums.fall);
  }
  if (!(d_q > 0))
  {
    return SolveStatus::indefinite;
  }
  if (!(r_d > 0))
  {
    return SolveStatus::stalled;
  }
  length = r_d / d_q;
  if (clipped && length > kWholeChord)
  {
    length = 1;
  }
  length = fall * length > 1 ? 1 / fall : length;
  return SolveStatus::converged;
}

void ConjugateGradients::Iteration::finish(SolveStatus status, NormalSolution& solution)
{
  solution.status = status;
  solution.iterations = products_;
  solution.approach = approach_;
  solution.residual = status == SolveStatus::no_contact ? 0 : residual_;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    fromField(patches_[k], patches_[k].stiffness, p_, solution.patches[k].pressure);
    measures_.measure(patches_[k].grid, solution.patches[k]);
  }
}

ConjugateGradients::ConjugateGradients(const ConjugateGradientsOptions& options)
{
  check(options);
  iteration_ = std::make_unique<Iteration>(options);
}
ConjugateGradients::~ConjugateGradients() = default;
ConjugateGradients::ConjugateGradients(ConjugateGradients&&) noexcept = default;
ConjugateGradients& ConjugateGradients::operator=(ConjugateGradients&&) noexcept = default;

void ConjugateGradients::prepare(int nx, int ny, bool symmetric)
{
  iteration_->cache().prepare(nx, ny, symmetric);
}

void ConjugateGradients::solve(const NormalProblem& problem, bool warm, NormalSolution& solution)
{
  iteration_->solve(problem, warm, solution);
}
}  // namespace wheel_rail_contact
