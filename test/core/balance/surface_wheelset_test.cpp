// SPDX-License-Identifier: BSD-3-Clause
// Height and roll of a wheelset on the surfaces of rigid rails.
#include "core/balance/surface_wheelset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/normal/solvers/conjugate_gradients.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double nominal_z = 0.46;  ///< [m]

class SurfaceWheelsetTest : public testing::Test
{
 protected:
  static ContactModelConfig fineScene()
  {
    ContactModelConfig config = manchesterScene();
    config.contact.tolerance = 0.003;
    return config;
  }

  ContactModelConfig config_ = fineScene();
  ConjugateGradients solver_{ConjugateGradientsOptions()};
  SurfaceWheelset wheelset_{config_, solver_, SurfaceContactOptions()};
};
}  // namespace

// The planar patches jump at the gauge corner and at the flange. Here, each state has a result from a cold start.
TEST_F(SurfaceWheelsetTest, EveryStateOfASweepHasAResult)
{
  int most = 0;
  for (const double load : {2e4, 1e5})
  {
    for (const double yaw : {0.0, 0.01})
    {
      for (int k = -45; k <= 45; ++k)
      {
        const WheelsetState state = stateAt(k * 2e-4, load, yaw);
        ASSERT_EQ(wheelset_.solve(state, nominal_z, 0), SolveStatus::converged) << "y " << state.y << " load " << load;
        most = std::max(most, wheelset_.solutions());
        for (const Side side : {Side::left, Side::right})
        {
          EXPECT_NEAR(wheelset_.wheel(side).verticalForce() / load, 1, 1e-6) << "y " << state.y;
        }
      }
    }
  }
  EXPECT_LE(most, 20);  // 16 were measured
}

// Height: 0.003 of an approach of 80 um, the tolerance of the planar result. Roll: the same on half the track width.
TEST_F(SurfaceWheelsetTest, AgreesWithPlanarPatchesOnTheTread)
{
  WheelsetContact planar(config_);
  for (const double yaw : {0.0, 0.01})
  {
    for (int k = -8; k <= 8; ++k)
    {
      const WheelsetState state = stateAt(k * 5e-4, 1e5, yaw);
      const WheelsetResult& expected = planar.evaluate(state);
      ASSERT_EQ(wheelset_.solve(state, nominal_z, 0), SolveStatus::converged);
      EXPECT_NEAR(wheelset_.z(), expected.z, 2.5e-7) << "y " << state.y << " yaw " << yaw;
      EXPECT_NEAR(wheelset_.roll(), expected.roll, 3.3e-7) << "y " << state.y << " yaw " << yaw;
    }
  }
}

TEST_F(SurfaceWheelsetTest, MirroredStatesHaveMirroredResults)
{
  for (const double y : {1e-3, 4.5e-3, 6.3e-3, 7e-3})
  {
    WheelsetState state = stateAt(y, 8e4, 0.005);
    state.torque_x = 1e4;
    ASSERT_EQ(wheelset_.solve(state, nominal_z, 0), SolveStatus::converged);
    const double z = wheelset_.z(), roll = wheelset_.roll();
    state.y = -state.y;
    state.yaw = -state.yaw;
    state.torque_x = -state.torque_x;
    ASSERT_EQ(wheelset_.solve(state, nominal_z, 0), SolveStatus::converged);
    EXPECT_EQ(wheelset_.z(), z);
    EXPECT_EQ(wheelset_.roll(), -roll);
  }
}

// On rigid rails with this rolling radius the balance is unique: the start is only a start. Before the last step, the
// difference of the heights is at most 1 % of the overlap (1 to 2 um); the step removes nearly all of it.
TEST_F(SurfaceWheelsetTest, StartDoesNotChangeTheResult)
{
  for (const double y : {0.0, -4.3e-3, -6.3e-3, -7e-3})
  {
    const WheelsetState state = stateAt(y, 1e5);
    ASSERT_EQ(wheelset_.solve(state, nominal_z, 0), SolveStatus::converged);
    const double z = wheelset_.z(), roll = wheelset_.roll();
    for (const double start : {-5e-3, 5e-3})
    {
      ASSERT_EQ(wheelset_.solve(state, nominal_z + 1e-3, start), SolveStatus::converged) << "y " << y;
      EXPECT_NEAR(wheelset_.z(), z, 4e-7) << "y " << y;
      EXPECT_NEAR(wheelset_.roll(), roll, 1e-6) << "y " << y;
    }
  }
}
// A positive moment about x unloads the left wheel.
TEST_F(SurfaceWheelsetTest, MomentMovesLoadToTheRightWheel)
{
  WheelsetState state = stateAt(1e-3, 8e4);
  state.torque_x = 3e4;
  ASSERT_EQ(wheelset_.solve(state, nominal_z, 0), SolveStatus::converged);
  const double transfer = 0.5 * state.torque_x / config_.wheelset.halfBase();
  EXPECT_NEAR(wheelset_.wheel(Side::left).verticalForce() / (8e4 - transfer), 1, 1e-6);
  EXPECT_NEAR(wheelset_.wheel(Side::right).verticalForce() / (8e4 + transfer), 1, 1e-6);
}

TEST_F(SurfaceWheelsetTest, StatesWithoutTwoLoadedWheelsAreRefused)
{
  EXPECT_EQ(wheelset_.solve(stateAt(0.5, 1e5), nominal_z, 0), SolveStatus::invalid_problem);
  WheelsetState unloaded = stateAt(0, 1e5);
  unloaded.torque_x = 5e5;
  EXPECT_EQ(wheelset_.solve(unloaded, nominal_z, 0), SolveStatus::invalid_problem);
  EXPECT_EQ(wheelset_.solve(stateAt(0, 1e5), nominal_z, 0), SolveStatus::converged);
}

// Starts far from the balance, with the wheels 5 mm too deep and tilted.
TEST_F(SurfaceWheelsetTest, AFarStartHasAResult)
{
  for (const double roll : {-0.02, 0.0, 0.02})
  {
    for (const double y : {-9e-3, 0.0, 6.3e-3})
    {
      const SolveStatus status = wheelset_.solve(stateAt(y, 1e5), nominal_z - 5e-3, roll);
      EXPECT_EQ(status, SolveStatus::converged) << "y " << y << " roll " << roll << ": " << toString(status);
    }
  }
}
}  // namespace wheel_rail_contact::core
