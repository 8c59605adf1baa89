// SPDX-License-Identifier: BSD-3-Clause
#include "../allocation_counter.h"
#include "creep_scene.h"

#ifdef __GLIBC__
namespace wheel_rail_contact::core
{
namespace
{
TEST(CreepHotPath, AllocatesNothingForKnownShapes)
{
  for (const CreepMethod method : creeping_methods)
  {
    const auto solver = makeCreepSolver(method);
    CreepSolution solution;
    CreepProblem first = CreepScene().problem({5e-4, 3e-4, 0.2});
    CreepProblem second = CreepScene{0.004, 0.009}.problem({1e-3, -3e-4, -0.1});
    solver->solve(first, false, solution);
    solver->solve(second, false, solution);
    const auto solve_again = [&]
    {
      solver->solve(first, true, solution);
      solver->solve(second, true, solution);
      solver->solve(second, false, solution);
      solver->solveAgain(second, solution);
    };
    EXPECT_EQ(allocationsOf(solve_again), 0) << toString(method);
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
#endif
