// SPDX-License-Identifier: BSD-3-Clause
// Equilibrium of a wheel and its bending rail.
#include "core/balance/wheel_equilibrium.h"

#include <Eigen/LU>

#include "../normal/problems.h"
#include "core/balance/rail_support.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr GridSize grid_size{32, 96};
constexpr double strict = 1e-5;

/// Left wheel on a bending rail.
class WheelEquilibriumTest : public testing::Test
{
 protected:
  /// Coordinates of the deflection of the rail, and the forces on it.
  static Eigen::Vector3d coordinates(const WheelEquilibrium& wheel) { return toCoordinates(wheel.rail().deflection); }
  static Eigen::Vector3d forces(const RailResult& rail)
  {
    return {rail.lateral_force, -rail.vertical_force, rail.moment};
  }

  Eigen::Matrix3d compliance() const
  {
    return supportCompliance(config_.rail_bending.table.left, config_.track.rail_inclination.left);
  }

  /// Potential energy of contact, rail and load with the rail at `rail`, with the height in equilibrium [J].
  double potential(const Eigen::Vector3d& rail, WheelsetPose pose)
  {
    WheelContact contact(config_, Side::left, restingRail(config_, Side::left), solver_);
    contact.setGrid(0, grid_size);
    contact.setRail(restingRail(config_, Side::left).deflected(toDeflection(rail)));
    for (int i = 0; i < 10; ++i)
    {
      EXPECT_EQ(contact.solveLoad(pose, wheel_load), WheelStatus::solved);
      pose.z = contact.height();
    }
    return contact.solved().energy() + wheel_load * contact.height() + 0.5 * rail.dot(compliance().inverse() * rail);
  }

  ContactModelConfig config_ = onPads(softPads());
  ConjugateGradients solver_ = problems::solverTo(1e-6);
};

// The forces of the contact are those that deflect the rail. Outward on the tread, at the gauge corner and on the
// flange.
TEST_F(WheelEquilibriumTest, ForcesOfTheContactDeflectTheRail)
{
  for (const ComplianceTable& table : {softPads(), verySoftPads()})
  {
    config_ = onPads(table);
    for (const double y : {0.0, 3e-3, 6e-3, 7e-3})
    {
      WheelEquilibrium wheel(config_, Side::left, solver_, strict);
      wheel.contact().setGrid(0, grid_size);
      ASSERT_EQ(wheel.solveUnderLoad({y, 0.46, 0, 0}, wheel_load), WheelStatus::solved) << "y " << y;
      const Eigen::Vector3d due = compliance().inverse() * coordinates(wheel);
      const Eigen::Vector3d found = wheel.contact().solved().forces().tail<3>();
      EXPECT_NEAR(found[0], due[0], 1e-3 * wheel_load) << "y " << y;
      EXPECT_NEAR(found[1], -wheel_load, 1e-6 * wheel_load) << "y " << y;
      EXPECT_NEAR(due[1], -wheel_load, 1e-3 * wheel_load) << "y " << y;
      EXPECT_NEAR(found[2], due[2], 1e-3 * wheel_load * 0.1) << "y " << y;
      EXPECT_LT((forces(wheel.rail()) - due).norm(), 1e-6 * wheel_load) << "y " << y;
    }
  }
}

// In equilibrium the potential energy is least: a rail displaced by 0.1 mm either way stores more.
TEST_F(WheelEquilibriumTest, EquilibriumIsTheLeastPotentialEnergy)
{
  for (const double y : {0.0, 3e-3, 6e-3, 7e-3})
  {
    const WheelsetPose pose{y, 0.46, 0, 0};
    WheelEquilibrium wheel(config_, Side::left, solver_, strict);
    wheel.contact().setGrid(0, grid_size);
    ASSERT_EQ(wheel.solveUnderLoad(pose, wheel_load), WheelStatus::solved) << "y " << y;
    const Eigen::Vector3d rail = coordinates(wheel);
    const double least = potential(rail, pose);
    for (const double lateral : {-1e-4, 1e-4})
    {
      EXPECT_GT(potential(rail + Eigen::Vector3d(lateral, 0, 0), pose), least) << "y " << y << " by " << lateral;
    }
  }
}

// The slope takes into account that the rail follows. Central differences of 0.1 mrad.
TEST_F(WheelEquilibriumTest, HeightPerRollIsTheSlopeOfTheHeight)
{
  for (const double y : {0.0, 3e-3})
  {
    WheelEquilibrium wheel(config_, Side::left, solver_, strict);
    wheel.contact().setGrid(0, grid_size);
    const auto heightAt = [&](double roll)
    {
      EXPECT_EQ(wheel.solveUnderLoad({y, 0.46, 0, roll}, wheel_load), WheelStatus::solved) << "y " << y;
      return wheel.height();
    };
    const double slope = (heightAt(1e-4) - heightAt(-1e-4)) / 2e-4;
    heightAt(0);
    wheel.respond();
    EXPECT_NEAR(wheel.rate(WheelEquilibrium::height_rate, WheelEquilibrium::by_roll) / slope, 1, 0.01) << "y " << y;
  }
}

TEST_F(WheelEquilibriumTest, AWheelWithoutLoadTouchesAnUndeflectedRail)
{
  WheelEquilibrium wheel(config_, Side::left, solver_, strict);
  wheel.contact().setGrid(0, grid_size);
  ASSERT_EQ(wheel.solveUnderLoad({0, 0.46, 0, 0}, wheel_load), WheelStatus::solved);
  ASSERT_EQ(wheel.solveUnderLoad({0, 0.46, 0, 0}, 0), WheelStatus::no_contact);
  EXPECT_FALSE(wheel.loaded());
  EXPECT_TRUE(coordinates(wheel).isZero(0));
  EXPECT_TRUE(forces(wheel.rail()).isZero(0));
}

// A rail that does not bend stays where it was placed.
TEST_F(WheelEquilibriumTest, ARigidRailIsNotDeflected)
{
  config_ = manchesterScene();
  WheelEquilibrium wheel(config_, Side::left, solver_, strict);
  wheel.contact().setGrid(0, grid_size);
  ASSERT_EQ(wheel.solveUnderLoad({3e-3, 0.46, 0, 0}, wheel_load), WheelStatus::solved);
  EXPECT_TRUE(coordinates(wheel).isZero(0));
  EXPECT_NEAR(wheel.rail().vertical_force / wheel_load, 1, 1e-6);
  EXPECT_GT(wheel.rail().lateral_force, 0);
}

// At the coarsest tolerance, down to 150 kN on the left wheel and back. Forces up and down differ by less than 1 %.
TEST(GivenHeight, ForcesRiseAsTheWheelsetIsLowered)
{
  constexpr std::size_t steps = 100;
  for (const ComplianceTable& table : {ComplianceTable{}, softPads(), verySoftPads()})
  {
    ContactModelConfig config = onPads(table);
    config.contact.tolerance = 0.1;
    WheelsetContact loaded(config);
    config.wheelset.solve_height_and_roll = false;
    for (const double y : {0.0, 5e-3, 6.5e-3, 7.2e-3})
    {
      WheelsetContact held(config);
      WheelsetState state = stateAt(y, 0);
      const double highest = loaded.evaluate(stateAt(y, 1e3)).z, depth = highest - loaded.evaluate(stateAt(y, 1.5e5)).z;
      state.roll = loaded.evaluate(stateAt(y, 1.5e5)).roll;
      std::array<double, 2 * steps + 1> forces{};
      for (std::size_t i = 0; i < forces.size(); ++i)
      {
        state.z = highest - depth * static_cast<double>(std::min(i, 2 * steps - i)) / steps;
        forces[i] = held.evaluate(state).wheel.left.vertical;
      }
      EXPECT_GT(forces[steps], 1.4e5);
      for (std::size_t i = 0; i < steps; ++i)
      {
        const double down = forces[i], up = forces[2 * steps - i];
        EXPECT_LE(down, forces[i + 1]) << "y " << y << ", step " << i;
        EXPECT_LE(up, forces[2 * steps - i - 1]) << "y " << y << ", step " << i;
        EXPECT_NEAR(down, up, 0.01 * up) << "y " << y << ", step " << i;
      }
    }
  }
}

// Stiffness of a result, against differences of its forces.

/// Forces of the rail on the wheel, along y and z of the track frame [N].
Eigen::Vector2d forcesOn(const RailResult& rail, Side side)
{
  return {(side == Side::left ? -1 : 1) * rail.lateral_force, rail.vertical_force};
}

/// The scene with height and roll given, on a grid of one size.
ContactModelConfig givenScene()
{
  ContactModelConfig config = manchesterScene();
  config.wheelset.solve_height_and_roll = false;
  config.contact = {NormalMethod::conjugate_gradient, 1e-4, 32, 96};
  return config;
}

// Tread, gauge corner and flange, with yaw, where the steps do not change the cells. A step of 1 um moves single ones
// into the contact.
TEST(Stiffness, IsTheDerivativeOfTheForces)
{
  constexpr double step = 1e-6;
  WheelsetContact balanced(manchesterScene()), given(givenScene());
  for (const double y : {1.1e-3, 5.5e-3, 7e-3})
  {
    const WheelsetResult& at = balanced.evaluate(stateAt(y, 1e5, 2e-3));
    ASSERT_TRUE(isUsable(at.status));
    WheelsetState state = heldAt(y, at.z, at.roll);
    state.yaw = 2e-3;
    ASSERT_TRUE(isUsable(given.evaluate(state).status));
    const Sides<Eigen::Matrix3d> stiffness{given.stiffness(Side::left), given.stiffness(Side::right)};
    for (const int coordinate : {0, 1})
    {
      Sides<Eigen::Vector2d> change{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
      for (const int direction : {1, -1})
      {
        WheelsetState moved = state;
        (coordinate == 0 ? moved.y : moved.z) += direction * step;
        const WheelsetResult& result = given.evaluate(moved);
        for (const Side side : {Side::left, Side::right})
        {
          change[side] -= direction * forcesOn(result.rail[side], side) / (2 * step);
        }
      }
      for (const Side side : sides)
      {
        EXPECT_LT((stiffness[side].topRows<2>().col(coordinate) - change[side]).norm(), 0.03 * change[side].norm())
            << "y " << y << ", wheel " << nameOf(side) << ", coordinate " << coordinate << ": "
            << stiffness[side].col(coordinate).transpose() << " against " << change[side].transpose();
      }
    }
  }
}

TEST(Stiffness, IsSymmetricAndMirrored)
{
  WheelsetContact contact(manchesterScene());
  ASSERT_TRUE(isUsable(contact.evaluate(stateAt(5e-3, 1e5)).status));
  const Eigen::Matrix3d left = contact.stiffness(Side::left);
  EXPECT_TRUE(left.isApprox(left.transpose()));
  contact.reset();
  ASSERT_TRUE(isUsable(contact.evaluate(stateAt(-5e-3, 1e5)).status));
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, -1);
  EXPECT_TRUE(left.isApprox(mirror * contact.stiffness(Side::right) * mirror, 1e-9));
}

TEST(Stiffness, IsZeroWithoutLoad)
{
  WheelsetContact contact(manchesterScene());
  EXPECT_TRUE(contact.stiffness(Side::left).isZero(0));
  ASSERT_EQ(contact.evaluate(stateAt(0, 5e4, 0, 1e6)).status, ContactStatus::lift_off);
  EXPECT_TRUE(contact.stiffness(Side::left).isZero(0));
  EXPECT_FALSE(contact.stiffness(Side::right).isZero(0));
}
}  // namespace
