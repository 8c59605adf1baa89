// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/normal_solver.h"

#include <stdexcept>

#include "core/normal/estimate/error_estimate.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/hertz_solver.h"
#include "core/normal/solvers/kik_piotrowski.h"
#include "core/normal/solvers/seidel.h"

namespace wheel_rail_contact::core
{
namespace
{
std::unique_ptr<NormalSolver> makeSeidel(SeidelOptions::Form form)
{
  SeidelOptions options;
  options.form = form;
  return std::make_unique<Seidel>(options);
}
}  // namespace

const char* toString(NormalMethod method)
{
  constexpr std::array names{"auto", "hertz", "kik_piotrowski", "seidel", "seidel_printed", "conjugate_gradient"};
  return names[static_cast<std::size_t>(method)];
}

NormalMethod methodNamed(std::string_view name)
{
  for (const NormalMethod method : all_normal_methods)
  {
    if (name == toString(method))
    {
      return method;
    }
  }
  throw std::invalid_argument("method = '" + std::string(name) + "': unknown");
}

void NormalSolver::solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution)
{
  solve(static_cast<const NormalProblem&>(problem), warm, solution);
}

std::string_view NormalSolver::leftOut(const CurvedProblem& problem) const
{
  return problem.normals.empty() ? (problem.isCoupled() ? "patch coupling" : "")
                                 : (problem.isCoupled() ? "column normals, patch coupling" : "column normals");
}

void NormalSolver::estimateErrors(const NormalProblem& problem, const NormalSolution& solution,
                                  std::vector<ErrorEstimate>& errors) const
{
  estimateGridErrors(problem, solution, errors);
}

std::unique_ptr<NormalSolver> makeNormalSolver(NormalMethod method)
{
  switch (method)
  {
    case NormalMethod::hertz:
      return std::make_unique<HertzSolver>();
    case NormalMethod::kik_piotrowski:
      return std::make_unique<KikPiotrowski>();
    case NormalMethod::seidel:
      return makeSeidel(SeidelOptions::Form::repaired);
    case NormalMethod::seidel_printed:
      return makeSeidel(SeidelOptions::Form::printed);
    case NormalMethod::conjugate_gradient:
      return std::make_unique<ConjugateGradients>(ConjugateGradientsOptions());
    default:
      throw std::invalid_argument("method = auto: requires a WheelsetContact, because a grid is chosen for each wheel");
  }
}
}  // namespace wheel_rail_contact::core
