// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// The left wheel moved down at a given roll: work of its vertical force from above the first touch, and the forces at
/// the end.
struct Loading
{
  double work = 0;      ///< [N m]
  double vertical = 0;  ///< [N]
  double outward = 0;   ///< [N]
  bool solved = true;
};

Loading pressDown(WheelsetContact& contact, double y, double roll, double z)
{
  constexpr int steps = 160;
  constexpr double height = 1.2e-3;
  contact.reset();
  Loading loading;
  WheelsetState state;
  state.y = y;
  state.roll = roll;
  for (int i = 0; i <= steps; ++i)
  {
    state.z = z + height * (steps - i) / steps;
    const WheelsetResult& result = contact.evaluate(state);
    loading.solved = loading.solved && isUsable(result.status);
    const double before = loading.vertical;
    loading.vertical = result.rail.left.vertical_force;
    loading.outward = result.rail.left.lateral_force;
    loading.work += 0.5 * (before + loading.vertical) * height / steps;
  }
  return loading;
}
}  // namespace

// Frictionless elastic bodies store the work done on them. The outward force on a rail is therefore the derivative of
// the work of the vertical force with respect to the lateral position of the wheelset. It does not depend on the grids
// on which the contact is solved. The states are those of the Manchester benchmark at 100 kN (tread, flange root,
// flange face).
//
// Tolerance: 160 vertical steps integrate the work of a force ~ penetration^1.5 to 1e-4. A lateral difference of 20 um
// each way changes the work by 2 % to 20 %. The error of the solution (0.3 % on this grid) therefore causes an error of
// up to 0.5 % of the derivative. Measured: 0.2 %, 0.3 %, 0.1 %, 0.1 %.
TEST(OutwardForceTest, OutwardForceIsTheDerivativeOfTheWorkOfTheVerticalForce)
{
  ContactModelConfig scene = manchesterScene();
  scene.wheelset.solve_height_and_roll = false;
  scene.contact.method = NormalMethod::conjugate_gradient;
  scene.contact.cells_along = 32;
  scene.contact.cells_across = 64;
  WheelsetContact contact(scene);
  struct State
  {
    double y, roll, z;
  };
  for (const State& at : {State{0.003, 0.0001720117, 0.4598028}, State{0.007, 0.005795621, 0.4640389},
                          State{0.008, 0.008369437, 0.4659933}, State{0.010, 0.01119864, 0.4681301}})
  {
    constexpr double step = 2e-5;
    const Loading here = pressDown(contact, at.y, at.roll, at.z);
    const Loading outer = pressDown(contact, at.y + step, at.roll, at.z);
    const Loading inner = pressDown(contact, at.y - step, at.roll, at.z);
    ASSERT_TRUE(here.solved && outer.solved && inner.solved) << "at y " << at.y;
    const double change = (outer.work - inner.work) / (2 * step);
    EXPECT_NEAR(here.outward, change, 0.005 * change) << "at y " << at.y;
  }
}
