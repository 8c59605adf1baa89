// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/rail_support.h"
#include "core/track/placement.h"
#include "same_bits.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Moment of the forces on a rail about its reference point, acting at the centre of the pressure; side axes, one patch
/// [N m].
double momentOf(const WheelsetResult& result, Side side, const PlacedRail& bent)
{
  const RailResult& rail = result.rail[side];
  const PlanePoint reference = bent.referencePoint();
  const double sign = sideSign(side);
  double moment = 0;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      moment +=
          rail.lateral_force * (patch.pose.z - reference.z) + rail.vertical_force * (sign * patch.pose.y - reference.y);
    }
  }
  return moment;
}

class RailBendingTest : public testing::Test
{
 protected:
  void useTable(RailBendingConfig::LateralForce source)
  {
    bend(scene_, softPads());
    scene_.rail_bending.lateral_force = source;
  }

  /// Displaces the rails of the scene by `offset` as other wheelsets do. Expects the results of a straight track with
  /// each rail displaced outward by `outward`.
  void expectWiderGauge(double offset)
  {
    ContactModelConfig wider = scene_;
    wider.rail_bending = {};
    wider.track.gauge += 2 * outward;
    WheelsetContact moved(scene_);
    WheelsetContact wide(wider);
    for (const double y : {0.0, 2e-3, -4e-3})
    {
      WheelsetState state = stateAt(y, 1e5);
      state.rail_displacement.left.lateral = state.rail_displacement.right.lateral = offset;
      moved.reset();
      wide.reset();
      const WheelsetResult& a = okResult(moved, state);
      const WheelsetResult& b = okResult(wide, stateAt(y, 1e5));
      EXPECT_NEAR(a.z, b.z, 3e-4 * 1e-4);
      for (const Side side : {Side::left, Side::right})
      {
        EXPECT_NEAR(wheelTotal(a, side).max_pressure / wheelTotal(b, side).max_pressure, 1, 3e-4);
        EXPECT_EQ(a.rail[side].deflection.lateral, outward);
      }
    }
  }

  static constexpr double outward = 0.5e-3;  ///< [m]
  ContactModelConfig scene_ = manchesterScene();
};

// Two descriptions of the same track: the arithmetic is the same up to the rounding of the rail positions. The stopping
// criteria of the solution may turn this into steps of the residual (3e-4) at most.
TEST_F(RailBendingTest, BothRailsOutwardIsAWiderGauge)
{
  scene_.rail_bending.model = RailBendingConfig::Model::prescribed;
  scene_.rail_bending.prescribed.lateral = outward;
  expectWiderGauge(0);
  // Displacement by other wheelsets, on rails without an own deflection.
  scene_.rail_bending.prescribed.lateral = 0;
  scene_.rail_bending.model = RailBendingConfig::Model::compliance;
  expectWiderGauge(outward);
}

// Small displacements add up, whether the own deflection is solved with the contact or mixed. Each rail has its own
// offset. Tolerance: mixed deflections and forces agree with the table to 1e-6 of the deflection.
TEST_F(RailBendingTest, DisplacementByOtherWheelsetsAddsToTheOwnDeflection)
{
  for (const auto source : {RailBendingConfig::LateralForce::contact, RailBendingConfig::LateralForce::constant})
  {
    useTable(source);
    scene_.rail_bending.lateral_force_value = 5e3;
    WheelsetContact contact(scene_);
    WheelsetState state = stateAt(2e-3, 1e5);
    state.rail_displacement = {RailDeflection{4e-4, -1e-4, 2e-3}, RailDeflection{-3e-4, 2e-4, 1e-3}};
    const WheelsetResult& result = okResult(contact, state);
    for (const Side side : sides)
    {
      const RailResult& rail = result.rail[side];
      const RailDeflection own = deflectionInTrack(softPads(), {rail.lateral_force, rail.vertical_force, rail.moment},
                                                   scene_.track.rail_inclination.left);
      EXPECT_NEAR(rail.deflection.lateral - own.lateral, state.rail_displacement[side].lateral, 2e-9);
      EXPECT_NEAR(rail.deflection.vertical - own.vertical, state.rail_displacement[side].vertical, 2e-9);
      EXPECT_NEAR(rail.deflection.roll - own.roll, state.rail_displacement[side].roll, 2e-8);
    }
  }
}

// Deflection, forces and moment of one result agree with the table to 1e-6 of the displacement, with the moment of the
// result and with the moment calculated from its roll. The latter is compared with the moment of the forces at the
// centre of the pressure on the rail. The line of the resultant passes it at most (3 mm)² / (2 * 80 mm) = 60 um away:
// less than 1 N m with 10 kN outward.
TEST_F(RailBendingTest, DeflectionIsTheTableTimesTheForces)
{
  useTable(RailBendingConfig::LateralForce::contact);
  WheelsetContact contact(scene_);
  const PlacedRail straight = restingRail(scene_, Side::left);
  const ComplianceTable table = softPads();
  const double cosine = std::cos(scene_.track.rail_inclination.left);
  const double sine = std::sin(scene_.track.rail_inclination.left);
  for (const double y : {0.0, 2e-3, 4e-3})
  {
    const WheelsetResult& result = okResult(contact, stateAt(y, 1e5));
    for (const Side side : {Side::left, Side::right})
    {
      const RailResult& rail = result.rail[side];
      const RailDeflection& moved = rail.deflection;
      const double square_force = cosine * rail.lateral_force - sine * rail.vertical_force;
      const double axial_force = sine * rail.lateral_force + cosine * rail.vertical_force;
      const double square = cosine * moved.lateral + sine * moved.vertical;
      const double axial = cosine * moved.vertical - sine * moved.lateral;
      const double moment = (moved.roll - table.lateral_roll * square_force) / table.roll_roll;
      const double size = std::hypot(std::hypot(moved.lateral, moved.vertical), 0.1 * moved.roll);
      EXPECT_NEAR(axial, -table.vertical_vertical * axial_force, 2e-6 * size) << "y " << y;
      EXPECT_NEAR(square, table.lateral_lateral * square_force + table.lateral_roll * moment, 2e-6 * size) << "y " << y;
      EXPECT_NEAR(moment, momentOf(result, side, straight.deflected(moved)), 1) << "y " << y;
      const RailDeflection due = deflectionInTrack(table, {rail.lateral_force, rail.vertical_force, rail.moment},
                                                   scene_.track.rail_inclination.left);
      EXPECT_NEAR(moved.lateral, due.lateral, 2e-6 * size) << "y " << y;
      EXPECT_NEAR(moved.vertical, due.vertical, 2e-6 * size) << "y " << y;
      EXPECT_NEAR(0.1 * moved.roll, 0.1 * due.roll, 2e-6 * size) << "y " << y;
    }
  }
}

TEST_F(RailBendingTest, GivenLateralForcesBendTheirRails)
{
  useTable(RailBendingConfig::LateralForce::topic);
  WheelsetContact contact(scene_);
  WheelsetState state = stateAt(0, 1e5);
  state.rail_lateral_force = {2e4, -5e3};
  const WheelsetResult& result = okResult(contact, state);
  EXPECT_EQ(result.rail.left.lateral_force, 2e4);
  EXPECT_EQ(result.rail.right.lateral_force, -5e3);
  EXPECT_GT(result.rail.left.deflection.lateral, result.rail.right.deflection.lateral + 1e-3);
}

TEST_F(RailBendingTest, ConstantLateralForceBendsBothRailsAlike)
{
  useTable(RailBendingConfig::LateralForce::constant);
  scene_.rail_bending.lateral_force_value = 1e4;
  WheelsetContact contact(scene_);
  const WheelsetResult& result = okResult(contact, stateAt(0, 1e5));
  EXPECT_EQ(result.rail.left.lateral_force, 1e4);
  EXPECT_EQ(result.rail.right.lateral_force, 1e4);
  EXPECT_NEAR(result.rail.left.deflection.lateral, result.rail.right.deflection.lateral, 2e-6 * 1e-3);
}

TEST_F(RailBendingTest, RigidTableIsNoBending)
{
  WheelsetContact straight(scene_);
  scene_.rail_bending.model = RailBendingConfig::Model::compliance;
  WheelsetContact rigid(scene_);
  const WheelsetResult& a = straight.evaluate(stateAt(2e-3, 1e5));
  const WheelsetResult& b = okResult(rigid, stateAt(2e-3, 1e5));
  EXPECT_EQ(b.rail.left.deflection.lateral, 0);
  EXPECT_NEAR(a.z, b.z, 2 * scene_.contact.tolerance * 1e-4);  // grids and residuals may differ
}

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

// Both rails to the left is the wheelset to the right; raised rails raise the wheelset.
TEST(RailDisplacement, DisplacedRailsAreADisplacedWheelset)
{
  const std::pair<double, double> displacements[] = {{0.7e-3, 0}, {0, 2e-3}};
  for (const auto& [left, up] : displacements)
  {
    for (const Model model : models)
    {
      for (WheelsetState state : states)
      {
        SCOPED_TRACE("model " + std::to_string(static_cast<int>(model)) + ", y " + std::to_string(state.y));
        WheelsetContact moved(sceneOf(model)), resting(sceneOf(model));
        WheelsetState shifted = state;
        shifted.y -= left;
        state.rail_displacement = {RailDeflection{left, up, 0}, RailDeflection{-left, up, 0}};
        expectDisplaced(moved.evaluate(state), resting.evaluate(shifted), left, up);
      }
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
    const WheelsetResult& result = okResult(contact, state);
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
      WheelsetState state = heldAt(1e-3, 0.4594);
      WheelsetContact resting(scene), displaced(scene);
      const WheelsetResult& before = okResult(resting, state);
      state.rail_displacement[side] = {4e-4, 1e-4, 2e-3};
      const WheelsetResult& after = okResult(displaced, state);
      const Side other = otherSide(side);
      EXPECT_EQ(wheelTotal(after, other).max_pressure, wheelTotal(before, other).max_pressure);
      EXPECT_NE(wheelTotal(after, side).max_pressure, wheelTotal(before, side).max_pressure);
    }
  }
}
}  // namespace
