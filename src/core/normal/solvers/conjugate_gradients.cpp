// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/solvers/conjugate_gradients.h"

#include "core/normal/measures/pressure_measures.h"
#include "core/normal/solvers/contact_iteration.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
void check(const ConjugateGradientsOptions& options)
{
  refuseIf(!(options.residual > 0 && options.residual < 1),
           "residual = " + std::to_string(options.residual) + ": must be in (0, 1)");
  refuseIf(options.max_products <= 0, "max_products = " + std::to_string(options.max_products) + ": must be positive");
}
}  // namespace

struct ConjugateGradients::Impl
{
  explicit Impl(const ConjugateGradientsOptions& options) : iteration(options) {}

  void solve(const NormalProblem& problem, const CurvedProblem* curved, bool warm, NormalSolution& solution);
  void finish(const NormalProblem& problem, SolveStatus status, NormalSolution& solution);

  OperatorCache cache;
  ContactIteration iteration;
  PressureMeasures measures;
};

/// Solves a problem. `curved`: the same problem, or null if it is plane.
void ConjugateGradients::Impl::solve(const NormalProblem& problem, const CurvedProblem* curved, bool warm,
                                     NormalSolution& solution)
{
  solution.patches.resize(problem.patches.size());
  if (!isValid(problem) || (curved && !hasValidSurface(*curved)))
  {
    solution.status = SolveStatus::invalid_problem;
    solution.iterations = 0;
    solution.residual = 1;
    return;
  }
  iteration.begin(problem, curved, cache);
  const bool touching = iteration.start(warm ? &solution : nullptr);
  finish(problem, touching ? iteration.iterate() : SolveStatus::no_contact, solution);
}

void ConjugateGradients::Impl::finish(const NormalProblem& problem, SolveStatus status, NormalSolution& solution)
{
  iteration.end();
  solution.status = status;
  solution.iterations = iteration.products();
  solution.approach = iteration.approach();
  for (std::size_t k = 0; k < solution.patches.size(); ++k)
  {
    const PatchLayout& layout = iteration.patches()[k];
    PatchPressure& patch = solution.patches[k];
    patch.grid = layout.grid;
    fromField(layout, layout.stiffness, iteration.pressure(), patch.pressure);
    fromField(layout, 1, iteration.displacement(), patch.displacement);
    measures.measure(problem.patches[k], problem.modulus, patch);
  }
  solution.residual = status == SolveStatus::no_contact ? 0 : iteration.residual();
}

ConjugateGradients::ConjugateGradients(const ConjugateGradientsOptions& options)
{
  check(options);
  impl_ = std::make_unique<Impl>(options);
}
ConjugateGradients::~ConjugateGradients() = default;
ConjugateGradients::ConjugateGradients(ConjugateGradients&&) noexcept = default;
ConjugateGradients& ConjugateGradients::operator=(ConjugateGradients&&) noexcept = default;

void ConjugateGradients::prepare(int nx, int ny)
{
  impl_->cache.prepare(nx, ny);
}

void ConjugateGradients::solve(const NormalProblem& problem, bool warm, NormalSolution& solution)
{
  impl_->solve(problem, nullptr, warm, solution);
}

void ConjugateGradients::solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution)
{
  impl_->solve(problem, &problem, warm, solution);
}
}  // namespace wheel_rail_contact::core
