// SPDX-License-Identifier: BSD-3-Clause
// Balance of forces and moments about the axle centre (WheelsetConfig::Balance::moments).
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
ContactModelConfig momentScene(ContactModelConfig scene = manchesterScene())
{
  scene.wheelset.balance = WheelsetConfig::Balance::moments;
  return scene;
}

/// Open moment about the axle centre [N m].
double openMoment(const WheelsetResult& result, const WheelsetState& state)
{
  return result.rail_wrench.moment.x() + state.torque_x;
}

// A last transfer that opens the gap by less than 4 % of the tolerance is left: 3/2 of it, 30 N of 50 kN, at a distance
// of 1.5 m.
TEST(MomentsTest, ForcesAndMomentsAboutTheAxleCentreAreInBalance)
{
  WheelsetContact contact(momentScene());
  for (const double torque : {0.0, 1e4, -3e4})
  {
    for (const double y : {-5.8e-3, -3e-3, 0.0, 2e-3, 4.5e-3, 5.2e-3, 6.2e-3})
    {
      const WheelsetState state = stateAt(y, 5e4, 0, torque);
      const WheelsetResult& result = okResult(contact, state);
      EXPECT_NEAR(result.rail_wrench.force.z(), 1e5, 1);
      EXPECT_NEAR(openMoment(result, state), 0, 60) << "y = " << y << " m, torque " << torque << " N m";
    }
  }
}

// The lateral normal forces of both wheels are equal only in the middle. Elsewhere their moment transfers load.
TEST(MomentsTest, BothBalancesDifferByTheMomentOfTheLateralForces)
{
  WheelsetContact moments(momentScene()), wheel_loads(manchesterScene());
  const WheelsetState middle = stateAt(0, 5e4), flange_root = stateAt(6.2e-3, 5e4);
  EXPECT_NEAR(moments.evaluate(middle).wheel.left.vertical, 5e4, 50);
  const WheelsetResult simple = wheel_loads.evaluate(flange_root);
  EXPECT_NEAR(simple.wheel.left.vertical, 5e4, 50);
  const double moved = moments.evaluate(flange_root).wheel.left.vertical - simple.wheel.left.vertical;
  // The transfer at the lever arms of equal loads. At the flange root, the arm of the left wheel is shorter by r tan of
  // 36 degrees, and it falls as the load moves there: 30 %.
  const double transfer = -openMoment(simple, flange_root) / (2 * wheel_loads.config().wheelset.halfBase());
  EXPECT_GT(moved, 5e3);
  EXPECT_NEAR(moved, transfer, 0.3 * transfer);
}

// Forces that follow from an energy are reciprocal (Maxwell). The energy is E(y, T) = minimum over z and roll of U + Q
// z - T roll, with the elastic energy U, the load Q and the torque T. Its derivatives are -F by y, with the lateral
// force F of the rails, and -roll by T. Therefore dF/dT = d(roll)/dy. With wheel loads alone this does not hold.
TEST(MomentsTest, LateralForceAndRollAreReciprocal)
{
  ContactModelConfig scene = momentScene();
  scene.contact.tolerance = 1e-3;
  const auto solve = [&](double y, double torque)
  {
    WheelsetContact contact(scene);
    return contact.evaluate(stateAt(y, 5e4, 0, torque));
  };
  const double y = 5.8e-3, dy = 1e-5, dt = 500;
  const auto force = [&](double torque) { return solve(y, torque).rail_wrench.force.y(); };
  const auto force_per_torque = [&] { return (force(dt) - force(-dt)) / (2 * dt); };
  const double roll_per_y = (solve(y + dy, 0).roll - solve(y - dy, 0).roll) / (2 * dy);
  EXPECT_NEAR(force_per_torque(), roll_per_y, 0.02 * std::abs(roll_per_y));
  scene.wheelset.balance = WheelsetConfig::Balance::wheel_loads;
  EXPECT_GT(std::abs(force_per_torque() - roll_per_y), 0.1 * std::abs(roll_per_y));
}

// A flange steeper than its lever arm allows, without friction: the wheelset rolls until the other wheel lifts.
TEST(MomentsTest, ASteepFlangeLiftsTheOtherWheel)
{
  WheelsetContact contact(momentScene());
  const WheelsetResult& result = contact.evaluate(stateAt(7e-3, 5e4));
  EXPECT_EQ(result.status, ContactStatus::lift_off);
  EXPECT_NE(result.reason.find("the right wheel lifts"), std::string::npos) << result.reason;
  EXPECT_NEAR(result.wheel.left.vertical, 1e5, 1);
}

// On rails that bend, a search begun with a lifted wheel takes many steps.
TEST(MomentsTest, AWheelReturnsToItsRail)
{
  WheelsetContact contact(momentScene(onPads(softPads())));
  ASSERT_EQ(contact.evaluate(stateAt(0, 1e5, 0, 2e5)).status, ContactStatus::lift_off);
  EXPECT_NEAR(okResult(contact, stateAt(6.5e-3, 1e5)).rail_wrench.moment.x(), 0, 120);
}

TEST(MomentsTest, MirroredStatesHaveMirroredResults)
{
  WheelsetContact contact(momentScene());
  for (const double torque : {5e3, -31305.96571, 7777.7})
  {
    for (const double y : {-4.941180585e-3, 4e-3, 6.1e-3})
    {
      const WheelsetState state = stateAt(y, 5e4, 2e-3, torque);
      contact.reset();
      const WheelsetResult left = contact.evaluate(state);
      contact.reset();
      const WheelsetResult& right = contact.evaluate(mirrored(state));
      expectMirrorImage(left, right);
      EXPECT_EQ(left.wheel.left.vertical, right.wheel.right.vertical);
      EXPECT_EQ(left.rail_wrench.force.z(), right.rail_wrench.force.z());
      EXPECT_EQ(left.rail_wrench.moment.x(), -right.rail_wrench.moment.x());
    }
  }
}

// Without a load there is nothing to transfer, whatever the torque. The state before has no effect.
TEST(MomentsTest, AWheelsetWithoutLoadCarriesNothing)
{
  WheelsetContact contact(momentScene());
  contact.evaluate(stateAt(7e-3, 5e4));  // lifts a wheel
  for (const double force : {0.0, 1e4, -1e-8})
  {
    const WheelsetResult& result = contact.evaluate(stateAt(0, -0.5 * force, 0, 1e4));
    EXPECT_EQ(result.status, ContactStatus::lift_off) << result.reason;
    EXPECT_EQ(result.reason, "neither wheel carries a load");
    EXPECT_EQ(result.rail_wrench.force.z(), 0);
  }
}

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
  constexpr double steps = 160, height = 1.2e-3;
  contact.reset();
  Loading loading;
  WheelsetState state = heldAt(y, z, roll);
  for (int i = 0; i <= steps; ++i)
  {
    state.z = z + height * (steps - i) / steps;
    const WheelsetResult& result = contact.evaluate(state);
    loading.solved = loading.solved && isUsable(result.status);
    const double before = std::exchange(loading.vertical, result.rail.left.vertical_force);
    loading.outward = result.rail.left.lateral_force;
    loading.work += 0.5 * (before + loading.vertical) * height / steps;
  }
  return loading;
}

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
  scene.contact = {NormalMethod::conjugate_gradient, 0.01, 32, 64};
  WheelsetContact contact(scene);
  for (const WheelsetState& at : {heldAt(0.003, 0.4598028, 0.0001720117), heldAt(0.007, 0.4640389, 0.005795621),
                                  heldAt(0.008, 0.4659933, 0.008369437), heldAt(0.010, 0.4681301, 0.01119864)})
  {
    constexpr double step = 2e-5;
    const auto moved = [&](double by) { return pressDown(contact, at.y + by, at.roll, at.z); };
    const Loading here = moved(0), outer = moved(step), inner = moved(-step);
    ASSERT_TRUE(here.solved && outer.solved && inner.solved) << "at y " << at.y;
    const double change = (outer.work - inner.work) / (2 * step);
    EXPECT_NEAR(here.outward, change, 0.005 * change) << "at y " << at.y;
  }
}
}  // namespace
