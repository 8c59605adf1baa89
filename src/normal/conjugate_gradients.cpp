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

namespace wheel_rail_contact
{
namespace
{
const double kPi = std::acos(-1.0);

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

/// All state of a solve; fields hold the patches one after another, in the operators' order of cells.
class ConjugateGradients::Iteration
{
 public:
  explicit Iteration(const ConjugateGradientsOptions& options) : options_(options) {}

  OperatorCache& cache() { return cache_; }

  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution)
  {
    solution.patches.resize(problem.patches.size());
    if (!isValid(problem))
    {
      finish(SolveStatus::invalid_problem, solution);
      return;
    }
    begin(problem);
    const bool touching = warm && load(solution) ? true : guess();
    finish(touching ? iterate() : SolveStatus::no_contact, solution);
  }

 private:
  bool loadControlled() const { return problem_->control == NormalProblem::Control::load; }

  void begin(const NormalProblem& problem);
  bool load(const NormalSolution& solution);
  bool guess();
  double depthForLoad() const;
  double loadOf(const LaneBuffer& pressure) const;
  void scalePressure(double factor);

  SolveStatus iterate();
  void applyMatrix(const LaneBuffer& in, LaneBuffer& out);
  void advance(double step);
  void updateResidual();
  double direction();
  bool chordOf(double beta, double step);
  SolveStatus step(double& length, bool clipped);

  void finish(SolveStatus status, NormalSolution& solution) const;

  ConjugateGradientsOptions options_;
  OperatorCache cache_;
  InfluenceOperator::Workspace workspace_;

  const NormalProblem* problem_ = nullptr;
  std::vector<PatchLayout> patches_;
  int length_ = 0;
  LaneBuffer p_, u_, gap_, r_, r_old_, z_, d_, q_, trial_;
  double approach_ = 0, residual_ = 0, depth_ = 0;
  double z_r_ = 0;
  int products_ = 0;
};

void ConjugateGradients::Iteration::begin(const NormalProblem& problem)
{
  problem_ = &problem;
  length_ = layOut(problem, cache_, patches_);
  for (LaneBuffer* field : {&p_, &u_, &gap_, &r_, &r_old_, &z_, &d_, &q_, &trial_})
  {
    field->resize(length_);
  }
  std::fill_n(gap_.data(), length_, kNoSurface);
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    workspace_.reserve(*patches_[k].influence);
    toField(patches_[k], problem.patches[k].gap, gap_.data());
  }
  approach_ = loadControlled() ? 0 : problem.value;
  products_ = 0;
  z_r_ = 0;
  residual_ = 1;
}

double ConjugateGradients::Iteration::loadOf(const LaneBuffer& pressure) const
{
  double sum = 0;
  for (const PatchLayout& patch : patches_)
  {
    double patch_sum = 0;
    for (int i = patch.begin; i < patch.begin + patch.size; ++i)
    {
      patch_sum += pressure[i];
    }
    sum += patch.weight * patch.cell_area * patch_sum;
  }
  return sum;
}

void ConjugateGradients::Iteration::scalePressure(double factor)
{
  for (int i = 0; i < length_; ++i)
  {
    p_[i] *= factor;
  }
}

bool ConjugateGradients::Iteration::load(const NormalSolution& solution)
{
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const Eigen::ArrayXXd& pressure = solution.patches[k].pressure;
    const Grid& grid = patches_[k].grid;
    if (pressure.rows() != grid.rows() || pressure.cols() != grid.ny || !(pressure >= 0).all())
    {
      return false;
    }
    toField(patches_[k], pressure, p_.data());
  }
  const double held = loadOf(p_);
  if (!(held > 0) || !std::isfinite(held))
  {
    return false;
  }
  if (loadControlled())
  {
    scalePressure(problem_->value / held);
  }
  return true;
}

/// Depth of interpenetration that a circular Hertz contact of each patch's area would need to carry the load [m].
double ConjugateGradients::Iteration::depthForLoad() const
{
  double lowest = std::numeric_limits<double>::infinity(), highest = lowest;
  for (const PatchLayout& patch : patches_)
  {
    const double least = *std::min_element(gap_.data() + patch.begin, gap_.data() + patch.begin + patch.size);
    lowest = std::min(lowest, least / patch.weight);
    const double one_cell = patch.weight * patch.weight * problem_->modulus * std::sqrt(patch.cell_area);
    highest = std::min(highest, least / patch.weight + problem_->value / one_cell);
  }
  for (int halving = 0; halving < 16; ++halving)
  {
    const double middle = 0.5 * (lowest + highest);
    double carried = 0;
    for (const PatchLayout& patch : patches_)
    {
      double cells = 0, least = kNoSurface;
      for (int i = patch.begin; i < patch.begin + patch.size; ++i)
      {
        cells += gap_[i] < patch.weight * middle ? 1 : 0;
        least = std::min(least, gap_[i]);
      }
      const double radius = std::sqrt(cells * patch.cell_area / kPi);
      const double depth = std::max(patch.weight * middle - least, 0.0);
      carried += patch.weight * 8.0 / 3.0 * problem_->modulus * radius * depth;
    }
    (carried < problem_->value ? lowest : highest) = middle;
  }
  return highest;
}

/// Pressure of a first guess: the square root of the interpenetration at half the approach, as in a circular Hertz
/// contact.
bool ConjugateGradients::Iteration::guess()
{
  std::fill_n(p_.data(), length_, 0.0);
  double least = std::numeric_limits<double>::infinity();
  for (const PatchLayout& patch : patches_)
  {
    least = std::min(
        least, *std::min_element(gap_.data() + patch.begin, gap_.data() + patch.begin + patch.size) / patch.weight);
  }
  const double level = loadControlled() ? depthForLoad() : least + 0.55 * (problem_->value - least);
  if (!(level > least))
  {
    return false;
  }
  for (const PatchLayout& patch : patches_)
  {
    for (int i = patch.begin; i < patch.begin + patch.size; ++i)
    {
      p_[i] = problem_->modulus * std::sqrt(std::max(patch.weight * level - gap_[i], 0.0));
    }
  }
  const double held = loadOf(p_);
  if (loadControlled())
  {
    scalePressure(problem_->value / held);
  }
  return held > 0;
}

void ConjugateGradients::Iteration::applyMatrix(const LaneBuffer& in, LaneBuffer& out)
{
  for (const PatchLayout& patch : patches_)
  {
    double* result = out.data() + patch.begin;
    patch.influence->multiply(in.data() + patch.begin, result, workspace_);
    for (int i = 0; i < patch.size; ++i)
    {
      result[i] *= patch.compliance;
    }
  }
  ++products_;
}

/// Moves pressure and displacement along the direction and, in load control, finds the approach.
void ConjugateGradients::Iteration::advance(double step)
{
  double sum = 0, weights = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const LoadedCells cells = laneKernels().advance(patch.size, step, d_.data() + at, q_.data() + at, gap_.data() + at,
                                                    p_.data() + at, u_.data() + at);
    sum += patch.cell_area * patch.weight * cells.sum;
    weights += patch.cell_area * patch.weight * patch.weight * cells.count;
  }
  if (loadControlled())
  {
    approach_ = sum / weights;
  }
}

void ConjugateGradients::Iteration::updateResidual()
{
  std::swap(r_, r_old_);
  double worst = 0;
  depth_ = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const Violation violation = laneKernels().residual(patch.size, patch.weight * approach_, p_.data() + at,
                                                       u_.data() + at, gap_.data() + at, r_.data() + at);
    worst = std::max({worst, violation.inside, violation.outside});
    const double least = *std::min_element(gap_.data() + at, gap_.data() + at + patch.size);
    depth_ = std::max(depth_, patch.weight * approach_ - least);
  }
  residual_ = worst / depth_;
}

/// Preconditioned residual, free of load where that is given; returns the factor of the last direction.
double ConjugateGradients::Iteration::direction()
{
  double sum = 0, weights = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    patch.influence->precondition(r_.data() + at, z_.data() + at, workspace_);
    for (int i = at; i < at + patch.size; ++i)
    {
      z_[i] /= patch.compliance;
    }
    const LoadedCells cells = laneKernels().maskedSum(patch.size, r_.data() + at, z_.data() + at);
    sum += patch.cell_area * patch.weight * cells.sum;
    weights += patch.cell_area * patch.weight * patch.weight * cells.count;
  }
  const double shift = loadControlled() ? sum / weights : 0;
  double z_r = 0, z_r_old = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const DirectionSums sums =
        laneKernels().project(patch.size, patch.weight * shift, r_.data() + at, r_old_.data() + at, z_.data() + at);
    z_r += patch.cell_area * sums.z_r;
    z_r_old += patch.cell_area * sums.z_r_old;
  }
  const double beta = z_r_ > 0 ? std::max(0.0, (z_r - z_r_old) / z_r_) : 0;
  z_r_ = z_r;
  return beta;
}

/// Direction to the trial point p + step (z + beta d), with negative pressures cut and the load restored.
bool ConjugateGradients::Iteration::chordOf(double beta, double step)
{
  double load = 0, clipped = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const TrialSums sums =
        laneKernels().trial(patch.size, beta, step, p_.data() + at, z_.data() + at, d_.data() + at, trial_.data() + at);
    load += patch.cell_area * patch.weight * sums.sum;
    clipped += sums.clipped;
  }
  if (clipped == 0)
  {
    return false;
  }
  const double scale = loadControlled() ? problem_->value / load : 1;
  laneKernels().chord(length_, scale, p_.data(), trial_.data(), d_.data());
  return true;
}

SolveStatus ConjugateGradients::Iteration::step(double& length, bool clipped)
{
  double r_d = 0, d_q = 0, longest = std::numeric_limits<double>::infinity();
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const StepSums sums =
        laneKernels().stepLength(patch.size, p_.data() + at, r_.data() + at, d_.data() + at, q_.data() + at);
    r_d += patch.cell_area * sums.r_d;
    d_q += patch.cell_area * sums.d_q;
    longest = std::min(longest, sums.longest);
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
  length = std::min(length, longest);
  return SolveStatus::converged;
}

SolveStatus ConjugateGradients::Iteration::iterate()
{
  applyMatrix(p_, u_);
  advance(0);
  double trial_step = 1, best = std::numeric_limits<double>::infinity();
  int best_at = 0;
  while (true)
  {
    updateResidual();
    if (residual_ <= options_.residual)
    {
      return SolveStatus::converged;
    }
    if (residual_ < best)
    {
      best = residual_;
      best_at = products_;
    }
    if (products_ >= options_.max_products)
    {
      return SolveStatus::iteration_limit;
    }
    if (products_ - best_at > kPatience)
    {
      return SolveStatus::stalled;
    }
    const double beta = direction();
    const bool clipped = chordOf(beta, trial_step);
    applyMatrix(d_, q_);
    double length = 0;
    const SolveStatus status = step(length, clipped);
    if (status != SolveStatus::converged)
    {
      return status;
    }
    advance(length);
    if (clipped)
    {
      z_r_ = 0;
    }
    else
    {
      trial_step = length;
    }
  }
}

void ConjugateGradients::Iteration::finish(SolveStatus status, NormalSolution& solution) const
{
  solution.status = status;
  solution.iterations = products_;
  solution.approach = approach_;
  solution.residual = residual_;
  if (status == SolveStatus::invalid_problem)
  {
    return;
  }
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    fromField(patches_[k], p_.data(), solution.patches[k].pressure);
    measure(patches_[k].grid, solution.patches[k]);
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
