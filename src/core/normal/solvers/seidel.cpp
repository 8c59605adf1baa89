// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/seidel.h"

#include "core/normal/measures/pressure_measures.h"
#include "core/normal/operator/influence.h"
#include "core/normal/solvers/patch_fields.h"
#include "core/normal/solvers/starting_pressure.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest number of secant steps for the load. Few are needed; more are a sign that the sweeps ended too early for an
/// accurate load.
constexpr int most_secant_steps = 30;

void checkShare(const char* name, double value)
{
  refuseIf(!(value > 0 && value < 1), std::string(name) + " = " + std::to_string(value) + ": must be in (0, 1)");
}

void checkCount(const char* name, int value)
{
  refuseIf(value <= 0, std::string(name) + " = " + std::to_string(value) + ": must be positive");
}
}  // namespace

/// State of a solution. Fields contain the patches one after another, in the order of the gap arrays. Pressures are
/// stored as lengths (see PatchLayout).
class Seidel::Sweeps
{
 public:
  explicit Sweeps(const SeidelOptions& options) : options_(options) {}

  bool isPrinted() const { return options_.form == SeidelOptions::Form::printed; }
  void begin(const NormalProblem& problem);
  SolveStatus solvePrinted();
  SolveStatus solveRepaired(const NormalSolution* earlier);
  void finish(SolveStatus status, NormalSolution& solution);

 private:
  bool isLoadControlled() const { return problem_->control == NormalProblem::Control::load; }
  void clearPressure();
  void fillDisplacement();
  double sweep();
  void sweepPatch(std::size_t k);
  SolveStatus settle();
  SolveStatus applyApproach(double approach);
  bool holdLoad();
  void updateResidual();
  void checkForStripes();

  SeidelOptions options_;
  const NormalProblem* problem_ = nullptr;
  std::vector<PatchLayout> patches_;
  std::vector<InfluenceTable> tables_;
  PressureMeasures measures_;
  LaneBuffer p_, u_, gap_;        ///< pressure, displacement, gap
  LaneBuffer p_old_, u_old_, r_;  ///< values before the last sweep; residual
  double approach_ = 0;           ///< [m]
  double residual_ = 1;           ///< relative [-]
  int sweeps_ = 0;
  bool indefinite_ = false;  ///< a change of the pressure had negative energy
};

void Seidel::Sweeps::begin(const NormalProblem& problem)
{
  problem_ = &problem;
  const int length = layOut(problem, nullptr, patches_);
  for (LaneBuffer* field : {&p_, &u_, &gap_, &p_old_, &u_old_, &r_})
  {
    field->resize(length);
  }
  std::fill_n(gap_.data(), length, no_surface_gap);
  clearPressure();
  tables_.resize(std::max(tables_.size(), patches_.size()));
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    toField(patches_[k], 1, problem.patches[k].gap, gap_);
    tables_[k].set(patches_[k].grid, isPrinted() ? Kernel::point_force : Kernel::rectangle);
  }
  approach_ = problem.value;
  residual_ = 1;
  sweeps_ = 0;
  indefinite_ = false;
}

void Seidel::Sweeps::clearPressure()
{
  for (const PatchLayout& patch : patches_)
  {
    std::fill_n(p_.data() + patch.begin, patch.size, 0.0);
    std::fill_n(u_.data() + patch.begin, patch.size, 0.0);
  }
}

/// Recomputes the displacement from the whole pressure.
void Seidel::Sweeps::fillDisplacement()
{
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const PatchLayout& patch = patches_[k];
    std::fill_n(u_.data() + patch.begin, patch.size, 0.0);
    for (int cell = 0; cell < patch.grid.rows() * patch.grid.ny; ++cell)
    {
      const int row = cell % patch.grid.rows(), column = cell / patch.grid.rows();
      tables_[k].add(row, column, p_[patch.begin + cell], u_.data() + patch.begin);
    }
  }
}

/// One pass over all cells. Returns the root mean square change of the pressure over its root mean square.
double Seidel::Sweeps::sweep()
{
  double energy = 0, change = 0, square = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const PatchLayout& patch = patches_[k];
    double *p = p_.data() + patch.begin, *p_old = p_old_.data() + patch.begin;
    double *u = u_.data() + patch.begin, *u_old = u_old_.data() + patch.begin;
    std::copy_n(p, patch.size, p_old);
    std::copy_n(u, patch.size, u_old);
    sweepPatch(k);
    for (int cell = 0; cell < patch.size; ++cell)
    {
      const double moved = (p[cell] - p_old[cell]) * patch.stiffness, pressure = p[cell] * patch.stiffness;
      change += moved * moved;
      square += pressure * pressure;
      energy += patch.force * (p[cell] - p_old[cell]) * (u[cell] - u_old[cell]);
    }
  }
  indefinite_ = indefinite_ || energy < 0;
  ++sweeps_;
  return square > 0 ? std::sqrt(change / square) : 0;
}

/// p = max(p - w / a_own, 0), cell by cell.
void Seidel::Sweeps::sweepPatch(std::size_t k)
{
  const PatchLayout& patch = patches_[k];
  double *p = p_.data() + patch.begin, *u = u_.data() + patch.begin;
  const double* gap = gap_.data() + patch.begin;
  for (int column = 0, cell = 0; column < patch.grid.ny; ++column)
  {
    for (int row = 0; row < patch.grid.rows(); ++row, ++cell)
    {
      const double w = u[cell] + gap[cell] - patch.weight * approach_;
      const double moved = std::max(p[cell] - w / tables_[k].own(row), 0.0) - p[cell];
      if (moved != 0)
      {
        tables_[k].add(row, column, moved, u);
        p[cell] += moved;
      }
    }
  }
}

/// Sweeps until the change of the pressure is small.
SolveStatus Seidel::Sweeps::settle()
{
  while (sweeps_ < options_.max_sweeps)
  {
    if (sweep() <= options_.change)
    {
      return SolveStatus::converged;
    }
  }
  return SolveStatus::iteration_limit;
}

SolveStatus Seidel::Sweeps::applyApproach(double approach)
{
  clearPressure();
  const double first = firstTouch(patches_);
  SolveStatus status = SolveStatus::converged;
  for (int step = 1; step <= options_.load_steps && status == SolveStatus::converged; ++step)
  {
    approach_ = first + (approach - first) * step / options_.load_steps;
    status = settle();
  }
  return status;
}

SolveStatus Seidel::Sweeps::solvePrinted()
{
  const double first = firstTouch(patches_);
  if (!isLoadControlled())
  {
    return problem_->value > first ? applyApproach(problem_->value) : SolveStatus::no_contact;
  }
  double depth = approachForLoad(*problem_, patches_, gap_) - first;
  double exponent = 1.5, last_depth = 0, last_load = 0;  // load ~ depth^exponent: 3/2 for Hertz
  for (int step = 0; step < most_secant_steps; ++step)
  {
    const SolveStatus status = applyApproach(first + depth);
    const double load = loadOf(patches_, p_);
    if (status != SolveStatus::converged || !(load > 0))
    {
      return status == SolveStatus::converged ? SolveStatus::stalled : status;
    }
    if (std::abs(load / problem_->value - 1) <= options_.load_error)
    {
      return SolveStatus::converged;
    }
    if (last_load > 0 && last_load != load)
    {
      exponent = std::clamp(std::log(load / last_load) / std::log(depth / last_depth), 0.5, 5.0);
    }
    last_depth = depth;
    last_load = load;
    depth *= std::pow(problem_->value / load, 1 / exponent);
  }
  return SolveStatus::stalled;
}

/// Scales pressure and displacement to the load and computes the approach from the loaded cells.
bool Seidel::Sweeps::holdLoad()
{
  const double load = loadOf(patches_, p_);
  double sum = 0, weights = 0;
  for (const PatchLayout& patch : patches_)
  {
    double *p = p_.data() + patch.begin, *u = u_.data() + patch.begin;
    laneKernels().scale(patch.size, problem_->value / load, p);
    laneKernels().scale(patch.size, problem_->value / load, u);
    const CellSum cells = laneKernels().advance(patch.size, 0, p, u, gap_.data() + patch.begin, p, u);
    sum += patch.force * patch.weight * cells.sum;
    weights += patch.force * patch.weight * patch.weight * cells.count;
  }
  approach_ = sum / weights;
  return load > 0;
}

SolveStatus Seidel::Sweeps::solveRepaired(const NormalSolution* earlier)
{
  Start start = earlier ? warmStart(*problem_, patches_, *earlier, p_, u_) : Start::none;
  if (start == Start::none)
  {
    start = coldStart(*problem_, patches_, gap_, p_);
  }
  if (start == Start::none)
  {
    return SolveStatus::no_contact;
  }
  fillDisplacement();
  while (true)
  {
    if (isLoadControlled() && !holdLoad())
    {
      return SolveStatus::stalled;
    }
    updateResidual();
    if (residual_ <= options_.residual)
    {
      return SolveStatus::converged;
    }
    if (sweeps_ >= options_.max_sweeps)
    {
      return SolveStatus::iteration_limit;
    }
    sweep();
  }
}

void Seidel::Sweeps::updateResidual()
{
  double worst = 0, depth = 0;
  for (const PatchLayout& patch : patches_)
  {
    const int at = patch.begin;
    const Violation violation = laneKernels().residual(patch.size, patch.weight * approach_, p_.data() + at,
                                                       u_.data() + at, gap_.data() + at, r_.data() + at);
    worst = std::max({worst, violation.inside, violation.outside});
    depth = std::max(depth, patch.weight * approach_ - patch.least_gap);
  }
  residual_ = worst / depth;
}

/// Checks for stripes: the iteration may converge to stripes without any sweep of negative energy.
void Seidel::Sweeps::checkForStripes()
{
  for (const PatchLayout& patch : patches_)
  {
    indefinite_ = indefinite_ || stripeEnergy(patch.grid, p_.data() + patch.begin) < 0;
  }
}

void Seidel::Sweeps::finish(SolveStatus status, NormalSolution& solution)
{
  if (isPrinted() && status == SolveStatus::converged)
  {
    checkForStripes();
  }
  if (status != SolveStatus::no_contact)
  {
    updateResidual();
  }
  solution.status = indefinite_ ? SolveStatus::indefinite : status;
  solution.iterations = sweeps_;
  solution.approach = approach_;
  solution.residual = status == SolveStatus::no_contact ? 0 : residual_;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    PatchPressure& patch = solution.patches[k];
    patch.grid = patches_[k].grid;
    fromField(patches_[k], patches_[k].stiffness, p_, patch.pressure);
    fromField(patches_[k], 1, u_, patch.displacement);
    measures_.measure(problem_->patches[k], problem_->modulus, patch);
  }
}

Seidel::Seidel(const SeidelOptions& options)
{
  checkShare("residual", options.residual);
  checkShare("change", options.change);
  checkShare("load_error", options.load_error);
  checkCount("load_steps", options.load_steps);
  checkCount("max_sweeps", options.max_sweeps);
  sweeps_ = std::make_unique<Sweeps>(options);
}
Seidel::~Seidel() = default;
Seidel::Seidel(Seidel&&) noexcept = default;
Seidel& Seidel::operator=(Seidel&&) noexcept = default;

const char* Seidel::name() const
{
  return sweeps_->isPrinted() ? "seidel_printed" : "seidel";
}

void Seidel::estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                            std::vector<ErrorEstimate>& errors) const
{
  estimateGridErrors(problem, solution, errors);
  for (std::size_t k = 0; sweeps_->isPrinted() && k < errors.size(); ++k)
  {
    ErrorEstimate& error = errors[k];
    if (error.largest() > 0)
    {
      const ErrorEstimate force = pointForceErrors(problem, solution, k);
      error = {error.max_pressure + force.max_pressure, error.area + force.area, error.approach + force.approach};
    }
  }
}

void Seidel::solve(const NormalProblem& problem, bool warm, NormalSolution& solution)
{
  solution.patches.resize(problem.patches.size());
  if (!isValid(problem))
  {
    solution.status = SolveStatus::invalid_problem;
    solution.iterations = 0;
    solution.residual = 1;
    return;
  }
  sweeps_->begin(problem);
  const SolveStatus status =
      sweeps_->isPrinted() ? sweeps_->solvePrinted() : sweeps_->solveRepaired(warm ? &solution : nullptr);
  sweeps_->finish(status, solution);
}
}  // namespace wheel_rail_contact::core
