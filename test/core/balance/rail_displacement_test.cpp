// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
using Model = RailBendingConfig::Model;

ContactModelConfig sceneOf(Model model)
{
  ContactModelConfig scene = manchesterScene();
  scene.rail_bending.model = model;
  scene.rail_bending.prescribed = {3e-4, -1e-4, 2e-3};
  scene.rail_bending.table = softPads();
  return scene;
}

constexpr Model models[] = {Model::none, Model::prescribed, Model::compliance};

/// Lateral positions, loads and yaw for which the contact does not jump within 1 um.
const WheelsetState states[] = {stateAt(0, 1e5), stateAt(2e-3, 4e4), stateAt(-4e-3, 1e5, 3e-3)};

/// Expects the result `moved` to be `result` with everything displaced by `y` and `z` [m].
///
/// Two descriptions of the same bodies: the arithmetic is the same up to the rounding of the positions. The stopping
/// criteria of the solution may turn this into steps of the residual (3e-4) at most. The height then changes by 3e-4 of
/// the approach of 0.1 mm, or of the deflection of soft rails of 0.6 mm.
void expectDisplaced(const WheelsetResult& moved, const WheelsetResult& result, double y, double z)
{
  constexpr double step = 3e-4;
  ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
  ASSERT_EQ(moved.status, ContactStatus::ok) << moved.reason;
  const double tolerance = step * (1e-4 + std::abs(result.rail.left.deflection.vertical));
  EXPECT_NEAR(moved.z - z, result.z, tolerance);
  EXPECT_NEAR(moved.roll, result.roll, tolerance / 0.75);
  ASSERT_EQ(moved.patches.size(), result.patches.size());
  for (std::size_t k = 0; k < result.patches.size(); ++k)
  {
    const PatchResult &a = moved.patches[k], &b = result.patches[k];
    EXPECT_EQ(a.side, b.side);
    EXPECT_NEAR(a.pose.y - y, b.pose.y, 1e-5) << "a hundredth of the width of the patch";
    EXPECT_NEAR(a.pose.z - z, b.pose.z, 1e-6) << "the same at a contact angle of up to 0.1";
    EXPECT_NEAR(a.normal_force / b.normal_force, 1, step);
    EXPECT_NEAR(a.max_pressure / b.max_pressure, 1, step);
    EXPECT_NEAR(a.area / b.area, 1, step);
  }
}
}  // namespace

TEST(RailDisplacement, BothRailsToTheLeftIsTheWheelsetToTheRight)
{
  constexpr double left = 0.7e-3;
  for (const Model model : models)
  {
    for (WheelsetState state : states)
    {
      SCOPED_TRACE("model " + std::to_string(static_cast<int>(model)) + ", y " + std::to_string(state.y));
      WheelsetContact moved(sceneOf(model)), resting(sceneOf(model));
      WheelsetState shifted = state;
      shifted.y -= left;
      state.rail_displacement = {RailDeflection{left, 0, 0}, RailDeflection{-left, 0, 0}};
      expectDisplaced(moved.evaluate(state), resting.evaluate(shifted), left, 0);
    }
  }
}

TEST(RailDisplacement, RaisedRailsRaiseTheWheelset)
{
  constexpr double up = 2e-3;
  for (const Model model : models)
  {
    for (WheelsetState state : states)
    {
      SCOPED_TRACE("model " + std::to_string(static_cast<int>(model)) + ", y " + std::to_string(state.y));
      WheelsetContact moved(sceneOf(model)), resting(sceneOf(model));
      const WheelsetResult& result = resting.evaluate(state);
      state.rail_displacement = {RailDeflection{0, up, 0}, RailDeflection{0, up, 0}};
      expectDisplaced(moved.evaluate(state), result, 0, up);
    }
  }
}

// The wheelset rolls by the height over the distance of the contacts. The roll moves the treads by 460 mm times the
// roll over the rails, on slopes of at most 1:20, up on one side and down on the other: by at most 2 * 460 mm / 20 over
// 1500 mm, 3 % of the roll.
TEST(RailDisplacement, ARaisedLeftRailRollsTheWheelsetToTheRight)
{
  constexpr double up = 1e-3;
  for (const Model model : models)
  {
    WheelsetContact contact(sceneOf(model));
    WheelsetState state = stateAt(0, 1e5);
    state.rail_displacement.left.vertical = up;
    const WheelsetResult& result = contact.evaluate(state);
    ASSERT_EQ(result.status, ContactStatus::ok) << result.reason;
    EXPECT_NEAR(result.roll, up / 1.5, 0.03 * up / 1.5);
  }
}

// The same numbers are added, in another order. Every bit is the same.
TEST(RailDisplacement, AddsToThePrescribedDeflection)
{
  const RailDeflection given = sceneOf(Model::prescribed).rail_bending.prescribed;
  const RailDeflection added{-5e-4, 2e-4, -1e-3};
  ContactModelConfig sum = sceneOf(Model::prescribed), only_added = sum;
  sum.rail_bending.prescribed += added;
  only_added.rail_bending.prescribed = added;
  for (const WheelsetState& state : states)
  {
    WheelsetState displaced = state;
    displaced.rail_displacement = {added, added};
    WheelsetContact both(sceneOf(Model::prescribed)), of_sum(sum);
    expectSameBits(both.evaluate(displaced), of_sum.evaluate(state));
    EXPECT_EQ(both.evaluate(displaced).rail.right.deflection.lateral, given.lateral + added.lateral);

    WheelsetContact rigid(sceneOf(Model::none)), prescribed(only_added);
    expectSameBits(rigid.evaluate(displaced), prescribed.evaluate(state));
  }
}

// A displacement of one rail leaves the bits of the other wheel, if height and roll of the axle are given.
TEST(RailDisplacement, OfOneRailDoesNotAffectTheOther)
{
  for (const Model model : models)
  {
    for (const Side side : sides)
    {
      ContactModelConfig scene = sceneOf(model);
      scene.wheelset.solve_height_and_roll = false;
      WheelsetState state = stateAt(1e-3, 0);
      state.z = 0.4594;
      WheelsetContact resting(scene), displaced(scene);
      const WheelsetResult& before = resting.evaluate(state);
      state.rail_displacement[side] = {4e-4, 1e-4, 2e-3};
      const WheelsetResult& after = displaced.evaluate(state);
      ASSERT_EQ(before.status, ContactStatus::ok) << before.reason;
      ASSERT_EQ(after.status, ContactStatus::ok) << after.reason;
      const Side other = side == Side::left ? Side::right : Side::left;
      EXPECT_EQ(wheelTotal(after, other).max_pressure, wheelTotal(before, other).max_pressure);
      EXPECT_NE(wheelTotal(after, side).max_pressure, wheelTotal(before, side).max_pressure);
    }
  }
}
