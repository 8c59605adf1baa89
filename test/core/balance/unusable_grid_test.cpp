// SPDX-License-Identifier: BSD-3-Clause
// Pressures from which no grid can be laid: on fewer than three cells, or on all cells. A limited number of other grids
// is tried. Then the wheel has no solution, and its status gives the reason.
#include <gtest/gtest.h>

#include <functional>

#include "core/balance/wheel_contact.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
using Pressure = Eigen::ArrayXXd;

/// Conjugate gradients whose first solutions are made unusable.
class SpoiledSolver : public NormalSolver
{
 public:
  SpoiledSolver(int spoiled, std::function<void(Pressure&)> spoil) : spoiled_(spoiled), spoil_(std::move(spoil)) {}
  const char* name() const override { return "conjugate_gradient"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override
  {
    solver_.solve(problem, warm, solution);
    if (++solutions_ > spoiled_)
    {
      return;
    }
    for (PatchPressure& patch : solution.patches)
    {
      spoil_(patch.pressure);
    }
  }
  int solutions() const { return solutions_; }

 private:
  ConjugateGradients solver_;
  int spoiled_;
  std::function<void(Pressure&)> spoil_;
  int solutions_ = 0;
};

/// Keeps the highest cell only; on a grid of which half is stored, this is two cells.
void sharpen(Pressure& pressure)
{
  pressure = (pressure < pressure.maxCoeff()).select(0.0, pressure);
}

/// Spreads the pressure over the whole grid.
void flatten(Pressure& pressure)
{
  pressure.setConstant(pressure.mean());
}

constexpr int most_grids = 10;  ///< limit of the grids in one call
constexpr int always = 1000;

/// The left wheel of a centred wheelset.
class UnusableGrid : public ::testing::Test
{
 protected:
  WheelStatus solve(SpoiledSolver& solver)
  {
    WheelContact wheel(scene_, solver);
    wheel.setRail(PlacedRail(scene_.rail_profile, scene_.track));
    return wheel.solveLoad(wheel.touch(WheelsetPose()), 1e5, {16, 32});
  }
  const ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

// The first grid is an initial guess and always followed by another.
TEST_F(UnusableGrid, TwoUnusableGridsAreFollowedByUsableOnes)
{
  SpoiledSolver sound(0, sharpen), spike(2, sharpen), cut(2, flatten);
  EXPECT_EQ(solve(sound), WheelStatus::solved);
  EXPECT_EQ(solve(spike), WheelStatus::solved);
  EXPECT_EQ(solve(cut), WheelStatus::solved);
  EXPECT_GT(spike.solutions(), sound.solutions());
  EXPECT_GT(cut.solutions(), sound.solutions());
}

TEST_F(UnusableGrid, PressureOnFewerThanThreeCellsOfEachGridHasItsOwnStatus)
{
  SpoiledSolver spike(always, sharpen);
  EXPECT_EQ(solve(spike), WheelStatus::spike);
  EXPECT_LE(spike.solutions(), most_grids);
}

TEST_F(UnusableGrid, PressureCutOffByEachGridHasItsOwnStatus)
{
  SpoiledSolver cut(always, flatten);
  EXPECT_EQ(solve(cut), WheelStatus::box_not_found);
  EXPECT_LE(cut.solutions(), most_grids);
}
}  // namespace wheel_rail_contact::core
