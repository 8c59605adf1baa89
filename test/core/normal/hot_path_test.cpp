// SPDX-License-Identifier: BSD-3-Clause
#include "../allocation_counter.h"
#include "core/normal/operator/operator_cache.h"
#include "core/normal/solvers/hertz_solver.h"
#include "core/normal/solvers/kik_piotrowski.h"
#include "problems.h"

#ifdef __GLIBC__
namespace wheel_rail_contact::core
{
namespace
{
using problems::hertzCase;

/// Problems of one scene that differ in load, position and cell size.
std::vector<NormalProblem> messages()
{
  std::vector<NormalProblem> all;
  for (int k = 0; k < 6; ++k)
  {
    NormalProblem problem = hertzCase(2, 16, 32, true, 1.1, 0.2 * k).problem;
    problem.patches[0].grid.dx = 2 * problem.patches[0].grid.dy;
    problem.patches.push_back(hertzCase(4, 12, 20, false, 1.2).problem.patches[0]);
    problem.patches[1].grid.dx = 4 * problem.patches[1].grid.dy;
    problem.patches[1].weight = 0.5;
    problem.control = k < 4 ? NormalProblem::Control::load : NormalProblem::Control::approach;
    problem.value = k < 4 ? 1e4 + 1e4 * k : 5e-5;
    all.push_back(std::move(problem));
  }
  return all;
}

template <typename Solver>
long allocationsAfterTheFirst(Solver& solver, const std::vector<NormalProblem>& problems)
{
  NormalSolution solution;
  solver.solve(problems[0], false, solution);
  return allocationsOf(
      [&]
      {
        for (const NormalProblem& problem : problems)
        {
          for (const bool warm : {false, true})
          {
            solver.solve(problem, warm, solution);
            EXPECT_TRUE(isUsable(solution.status));
          }
        }
      });
}

TEST(HotPath, ConjugateGradientsAllocateNothingAfterTheFirstSolve)
{
  ConjugateGradients solver;
  solver.prepare(16, 32);
  solver.prepare(12, 20);
  EXPECT_EQ(allocationsAfterTheFirst(solver, messages()), 0);
}

TEST(HotPath, ConjugateGradientsComputeNoCoefficientOnPatchesOfOtherShapes)
{
  // Curvatures across from a third to eight times those along; whole grids, as with yaw.
  std::vector<NormalProblem> problems;
  for (int k = -12; k <= 24; k += 4)
  {
    NormalProblem problem = hertzCase(std::exp2(k / 8.0), 12, 20, false, 1.2).problem;
    Grid& grid = problem.patches[0].grid;
    grid.dx = cell_aspect::aspect(cell_aspect::nearestIndex(grid.dx / grid.dy)) * grid.dy;
    problems.push_back(std::move(problem));
  }
  ConjugateGradients solver;
  solver.prepare(12, 20);
  EXPECT_EQ(allocationsAfterTheFirst(solver, problems), 0);
}

TEST(HotPath, OtherMethodsAllocateNothingAfterTheFirstSolve)
{
  Seidel repaired;
  EXPECT_EQ(allocationsAfterTheFirst(repaired, messages()), 0);
  HertzSolver hertz;
  EXPECT_EQ(allocationsAfterTheFirst(hertz, messages()), 0);
  KikPiotrowski kik_piotrowski;
  EXPECT_EQ(allocationsAfterTheFirst(kik_piotrowski, messages()), 0);
}

TEST(HotPath, ErrorEstimatesAllocateNothing)
{
  ConjugateGradients grid;
  HertzSolver hertz;
  KikPiotrowski kik_piotrowski;
  const NormalProblem problem = messages()[0];
  for (NormalSolver* solver : {static_cast<NormalSolver*>(&grid), static_cast<NormalSolver*>(&hertz),
                               static_cast<NormalSolver*>(&kik_piotrowski)})
  {
    const NormalSolution solution = problems::solved(*solver, problem);
    std::vector<ErrorEstimate> errors(2);
    EXPECT_EQ(allocationsOf([&] { solver->estimateErrors(problem, solution, errors); }), 0) << solver->name();
    EXPECT_GT(errors[0].largest(), 0);
    EXPECT_GT(errors[1].largest(), 0);
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
#endif
