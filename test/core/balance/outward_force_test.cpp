// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// The left wheel pressed down at given roll: work of its vertical force from above the first touch, and the forces at
/// the end.
struct Penetration
{
  double work = 0;      ///< [N m]
  double vertical = 0;  ///< [N]
  double outward = 0;   ///< [N]
  bool evaluated = true;
};

Penetration pressDown(WheelsetContact& contact, double y, double roll, double z)
{
  constexpr int steps = 160;
  constexpr double height = 1.2e-3;
  contact.reset();
  Penetration penetration;
  WheelsetState state;
  state.y = y;
  state.roll = roll;
  for (int i = 0; i <= steps; ++i)
  {
    state.z = z + height * (steps - i) / steps;
    const WheelsetResult& result = contact.evaluate(state);
    penetration.evaluated = penetration.evaluated && isUsable(result.status);
    const double before = penetration.vertical;
    penetration.vertical = result.rail[0].vertical_force;
    penetration.outward = result.rail[0].lateral_force;
    penetration.work += 0.5 * (before + penetration.vertical) * height / steps;
  }
  return penetration;
}
}  // namespace

// Elastic bodies without friction store the work done on them. So the outward force on a rail is the change of the
// vertical force's work with the wheelset's lateral place, whatever plane the contact was solved in. States of the
// Manchester benchmark at 100 kN (tread, flange's root, flank).
// Tolerance: pressing down in 160 steps sums the work of a force ~ descent^1.5 to 1e-4; a lateral difference of 20 um
// each way changes the work by 2 % to 20 %, of which the solution's own error (0.3 % on this grid) is up to 0.5 % on
// the derivative. Measured: 0.2 %, 0.3 %, 0.1 %, 0.1 %.
TEST(OutwardForceTest, OutwardForceIsTheChangeOfTheVerticalForcesWork)
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
    const Penetration here = pressDown(contact, at.y, at.roll, at.z);
    const Penetration outer = pressDown(contact, at.y + step, at.roll, at.z);
    const Penetration inner = pressDown(contact, at.y - step, at.roll, at.z);
    ASSERT_TRUE(here.evaluated && outer.evaluated && inner.evaluated) << "at y " << at.y;
    const double change = (outer.work - inner.work) / (2 * step);
    EXPECT_NEAR(here.outward, change, 0.005 * change) << "at y " << at.y;
  }
}
