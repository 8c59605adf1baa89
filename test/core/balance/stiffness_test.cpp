// SPDX-License-Identifier: BSD-3-Clause
// Stiffness of a result, against differences of its forces.
#include <gtest/gtest.h>

#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Forces of the rail on the wheel, along y and z of the track frame [N].
Eigen::Vector2d forcesOn(const RailResult& rail, Side side)
{
  return {(side == Side::left ? -1 : 1) * rail.lateral_force, rail.vertical_force};
}

/// The scene with height and roll given, on a grid that does not change.
ContactModelConfig givenScene()
{
  ContactModelConfig config = manchesterScene();
  config.wheelset.solve_height_and_roll = false;
  config.contact.method = NormalMethod::conjugate_gradient;
  config.contact.cells_along = 32;
  config.contact.cells_across = 96;
  config.contact.tolerance = 1e-4;
  return config;
}

// Tread, gauge corner and flange, with yaw. A step of 1 um moves single cells into the contact.
TEST(Stiffness, IsTheDerivativeOfTheForces)
{
  constexpr double step = 1e-6;
  WheelsetContact balanced(manchesterScene()), given(givenScene());
  for (const double y : {1e-3, 5.5e-3, 7e-3})
  {
    const WheelsetResult& at = balanced.evaluate(stateAt(y, 1e5, 2e-3));
    ASSERT_TRUE(isUsable(at.status));
    WheelsetState state = stateAt(y, 1e5, 2e-3);
    state.z = at.z;
    state.roll = at.roll;
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
  WheelsetState state = stateAt(0, 5e4);
  state.torque_x = 1e6;
  ASSERT_EQ(contact.evaluate(state).status, ContactStatus::lift_off);
  EXPECT_TRUE(contact.stiffness(Side::left).isZero(0));
  EXPECT_FALSE(contact.stiffness(Side::right).isZero(0));
}
}  // namespace
}  // namespace wheel_rail_contact::core
