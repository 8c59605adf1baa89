// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/creep.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/creep/creep_strips.h"
#include "core/creep/exact_rolling.h"
#include "core/creep/simplified_theory.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest coefficient of friction [-].
constexpr double largest_friction = 2;

/// Without friction.
class NoCreep : public CreepSolver
{
  CreepStatus fill(const CreepProblem& /*problem*/, bool /*warm*/, CreepSolution& /*solution*/) override
  {
    return CreepStatus::no_slip;
  }
};

bool isValid(const FrictionLaw& law)
{
  return law.coefficient >= 0 && law.coefficient <= largest_friction && law.slip_share >= 0 && law.slip_share <= 1 &&
         law.slip_decay >= 0 && std::isfinite(law.slip_decay);
}

bool isFinite(const Creepage& creepage)
{
  return std::isfinite(creepage.x) && std::isfinite(creepage.y) && std::isfinite(creepage.spin);
}

bool isValid(const CreepProblem& problem)
{
  return isFinite(problem.creepage) && std::all_of(problem.columns.begin(), problem.columns.end(), isFinite) &&
         std::isfinite(problem.speed) && problem.elasticity.modulus > 0 && std::isfinite(problem.elasticity.modulus) &&
         problem.elasticity.poisson >= 0 && problem.elasticity.poisson <= 0.5 && problem.normal_force >= 0 &&
         std::isfinite(problem.normal_force) && isValid(problem.friction);
}

/// Sets force, mean friction and power, from those of the columns.
void sumColumns(const CreepProblem& problem, CreepSolution& solution)
{
  solution.force = {};
  double limit = 0, work = 0;
  for (int j = 0; j < problem.grid.ny; ++j)
  {
    const CreepForce& force = solution.columns[static_cast<std::size_t>(j)];
    solution.force.x += force.x;
    solution.force.y += force.y;
    solution.force.moment += force.moment - problem.grid.y(j) * force.x;
    limit += solution.limits[static_cast<std::size_t>(j)];
    work += workOf(force, creepageOf(problem, j));
  }
  solution.friction = limit / problem.normal_force;
  solution.power = std::abs(problem.speed) * work;
}
}  // namespace

const char* toString(CreepMethod method)
{
  constexpr std::array names{"none", "linear", "fastsim", "exact"};
  return names[static_cast<std::size_t>(method)];
}

CreepMethod creepMethodNamed(std::string_view name)
{
  for (const CreepMethod method : all_creep_methods)
  {
    if (name == toString(method))
    {
      return method;
    }
  }
  throw std::invalid_argument("creep method = '" + std::string(name) + "': unknown");
}

const char* toString(CreepStatus status)
{
  switch (status)
  {
    case CreepStatus::converged:
      return "converged";
    case CreepStatus::no_slip:
      return "no creep force: no method, normal force, friction or speed";
    case CreepStatus::iteration_limit:
      return "iteration limit reached";
    case CreepStatus::invalid_problem:
      return "invalid problem: a number is not finite or out of range, or the pressure does not fit its grid";
  }
  return "unknown";
}

ShearElasticity shearElasticity(const Material& first, const Material& second)
{
  validate(first, "first material");
  validate(second, "second material");
  const auto compliance = [](const Material& m) { return (1 + m.poisson) / m.young; };  // 1 / (2 G)
  const double one = compliance(first), other = compliance(second);
  ShearElasticity pair;
  pair.modulus = 1 / (one + other);
  pair.poisson = (one * first.poisson + other * second.poisson) / (one + other);
  require(pair.poisson >= 0, "poisson of the pair", pair.poisson, "must be at least 0");
  return pair;
}

double FrictionLaw::at(double slip_velocity) const
{
  return coefficient * ((1 - slip_share) * std::exp(-slip_decay * slip_velocity) + slip_share);
}

void validate(const FrictionLaw& law, const std::string& group)
{
  require(law.coefficient >= 0 && law.coefficient <= largest_friction, group + "friction", law.coefficient,
          "must be from 0 to 2");
  require(law.slip_share >= 0 && law.slip_share <= 1, group + "slip_share", law.slip_share, "must be from 0 to 1");
  require(law.slip_decay >= 0 && std::isfinite(law.slip_decay), group + "slip_decay", law.slip_decay,
          "must be finite and at least 0");
}

void validate(const CreepConfig& creep)
{
  const auto numbers = [](const FrictionLaw& law) { return std::tie(law.coefficient, law.slip_share, law.slip_decay); };
  const bool are_same = numbers(creep.friction.left) == numbers(creep.friction.right);
  validate(creep.friction.left, are_same ? "creep/" : "creep/left/");
  validate(creep.friction.right, "creep/right/");
}

void CreepSolver::solveAgain(const CreepProblem& problem, CreepSolution& solution)
{
  is_again_ = is_filled_;
  solve(problem, true, solution);
  is_again_ = false;
}

void CreepSolver::solve(const CreepProblem& problem, bool warm, CreepSolution& solution)
{
  is_filled_ = false;
  solution.force = {};
  solution.adhesion_share = solution.power = solution.error_estimate = 0;
  solution.iterations = 0;
  solution.columns.clear();
  solution.limits.clear();
  solution.friction = problem.friction.at(slipVelocity(problem.speed, problem.creepage));
  solution.status = CreepStatus::invalid_problem;
  if (!isValid(problem))
  {
    return;
  }
  if (problem.speed == 0 || !(solution.friction * problem.normal_force > 0))
  {
    solution.status = CreepStatus::no_slip;
    solution.traction_x.resize(0, 0);
    solution.traction_y.resize(0, 0);
    return;
  }
  solution.status = fill(problem, warm, solution);
  is_filled_ = solution.status != CreepStatus::invalid_problem;
  const CreepForce& force = solution.force;
  if (!solution.columns.empty())
  {
    sumColumns(problem, solution);
  }
  else
  {
    solution.power = std::abs(problem.speed) * workOf(force, problem.creepage);
  }
  solution.adhesion_share = std::hypot(force.x, force.y) / (solution.friction * problem.normal_force);
}

std::unique_ptr<CreepSolver> makeCreepSolver(CreepMethod method)
{
  switch (method)
  {
    case CreepMethod::linear:
      return std::make_unique<LinearLaw>();
    case CreepMethod::fastsim:
      return std::make_unique<Fastsim>();
    case CreepMethod::exact:
      return std::make_unique<ExactRolling>();
    case CreepMethod::none:
      break;
  }
  return std::make_unique<NoCreep>();
}
}  // namespace wheel_rail_contact::core
