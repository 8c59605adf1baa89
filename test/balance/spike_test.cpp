// SPDX-License-Identifier: BSD-3-Clause
// A pressure on fewer than three cells shows no edges to lay a grid by: another grid is tried, and in the end the wheel
// is refused by that name.
#include <gtest/gtest.h>

#include "wheel_rail_contact/balance/wheel_contact.h"
#include "wheel_rail_contact/normal/conjugate_gradients.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact
{
namespace
{
/// Conjugate gradients of whose first answers only the highest cells are left, one on a grid of halves.
class SpikySolver : public NormalSolver
{
 public:
  explicit SpikySolver(int spikes) : spikes_(spikes) {}
  const char* name() const override { return "conjugate_gradient"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override
  {
    solver_.solve(problem, warm, solution);
    if (++solutions_ > spikes_)
    {
      return;
    }
    for (PatchPressure& patch : solution.patches)
    {
      patch.pressure = (patch.pressure < patch.pressure.maxCoeff()).select(0.0, patch.pressure);
    }
  }
  int solutions() const { return solutions_; }

 private:
  ConjugateGradients solver_;
  int spikes_;
  int solutions_ = 0;
};

/// The left wheel, centred.
class Spike : public ::testing::Test
{
 protected:
  WheelStatus solve(SpikySolver& solver)
  {
    WheelContact wheel(scene_, solver);
    wheel.setRail(PlacedRail(scene_.rail_profile, scene_.track));
    return wheel.solveLoad(wheel.touch(WheelsetPose()), 1e5, {16, 32});
  }
  const ContactModelConfig scene_ = manchesterScene();
};
}  // namespace

TEST_F(Spike, OnceIsMendedByAnotherGrid)
{
  SpikySolver sound(0), spiky(1);
  EXPECT_EQ(solve(sound), WheelStatus::solved);
  EXPECT_EQ(solve(spiky), WheelStatus::solved);
  EXPECT_GT(spiky.solutions(), sound.solutions());
}

TEST_F(Spike, OnEveryGridIsRefusedByName)
{
  SpikySolver spiky(1000);
  EXPECT_EQ(solve(spiky), WheelStatus::spike);
  EXPECT_LT(spiky.solutions(), 100);
}
}  // namespace wheel_rail_contact
