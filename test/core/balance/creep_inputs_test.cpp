// SPDX-License-Identifier: BSD-3-Clause
// What creep forces require of a result: sizes, places, curvatures, stiffness and forces of each contact.
#include <Eigen/Geometry>

#include "../../last_where.h"
#include "core/track/placement.h"
#include "round_bodies.h"
#include "same_bits.h"

using namespace wheel_rail_contact::core;

namespace
{
const PatchResult& firstOf(const WheelsetResult& result, Side side)
{
  return *patchesOf(result, side).at(0);
}

WheelsetContact roundContact(double slope)
{
  ContactModelConfig scene = round_bodies::scene(slope);
  scene.contact.tolerance = 1e-3;
  return WheelsetContact(scene);
}

// The semi-axes inherit half of the relative error of the area, 5e-4 at this tolerance, and that of their ratio: the
// ends of the lines of cells are located to 2 % of a cell, with 48 cells.
TEST(CreepInputsTest, SemiAxesAndStiffnessOfAHertzContactAreThoseOfHertz)
{
  for (const double slope : {0.0, 0.05, 0.1})
  {
    WheelsetContact contact = roundContact(slope);
    const WheelsetResult& result = okResult(contact, stateAt(0, 1e5));
    const HertzContact hertz = round_bodies::exactContact(contact.config(), slope, 0, 1e5);
    const PatchResult& patch = firstOf(result, Side::left);
    EXPECT_NEAR(patch.semi_axis_along, hertz.semi_axis_x, 2e-3 * hertz.semi_axis_x);
    EXPECT_NEAR(patch.semi_axis_across, hertz.semi_axis_y, 2e-3 * hertz.semi_axis_y);
    EXPECT_NEAR(patch.normal_stiffness, 1.5 * hertz.force / hertz.approach, 2e-3 * 1.5 * hertz.force / hertz.approach);
  }
}

TEST(CreepInputsTest, CurvaturesRadiusAndPlacesOfAConeFollowFromItsGeometry)
{
  const double slope = 0.1, y = 2e-3, angle = std::atan(slope);
  WheelsetContact contact = roundContact(slope);
  const ContactModelConfig& scene = contact.config();
  const WheelsetResult& result = okResult(contact, stateAt(y, 1e5));
  const PatchResult& patch = firstOf(result, Side::left);
  // The crown touches where its tangent is that of the cone, which the roll turns.
  const double tilt = angle + result.roll;
  EXPECT_NEAR(patch.contact_angle, tilt, 1e-4);
  EXPECT_NEAR(patch.rail_s, -round_bodies::crown_radius * tilt, 2e-5);
  const double outward =
      0.5 * scene.track.gauge + round_bodies::half_head - round_bodies::crown_radius * std::sin(tilt) - y;
  // Along the axle from its centre, to the point of the crown that lies about r below.
  const double along = outward * std::cos(result.roll) - (result.z) * std::sin(result.roll) - scene.wheelset.halfBase();
  EXPECT_NEAR(patch.wheel_s, along * std::hypot(1, slope), 5e-5);
  EXPECT_NEAR(patch.rolling_radius, scene.wheelset.rolling_radius.left - slope * along, 1e-5);
  EXPECT_NEAR(patch.curvature_across, 1 / round_bodies::crown_radius, 1e-6);
  EXPECT_NEAR(patch.curvature_along, std::cos(angle) / patch.rolling_radius, 1e-9);
  EXPECT_EQ(patch.wheel_angle, 0);
}

// On a yawed axle, the normal of the wheel has no component along the track at the angle whose sine is tan(yaw)
// tan(contact angle), ahead of the axle if the flange is turned towards the rail. The contact angle is that of the
// resultant; the angle at the centre of pressure differs by up to the turn of the surface over the patch.
TEST(CreepInputsTest, AYawedFlangeTouchesAheadOfTheAxle)
{
  WheelsetContact contact(manchesterScene());
  const double yaw = 10e-3;
  const WheelsetResult& result = okResult(contact, stateAt(7e-3, 5e4, yaw));
  const PatchResult& patch = firstOf(result, Side::left);
  ASSERT_GT(patch.contact_angle, 1);
  EXPECT_NEAR(patch.wheel_angle, std::tan(yaw) * std::tan(patch.contact_angle), 0.03 * patch.wheel_angle);
  const double ahead = patch.pose.x + (patch.pose.y - result.y) * std::tan(yaw);  // of the axle
  EXPECT_NEAR(ahead, patch.rolling_radius * std::sin(patch.wheel_angle), 1e-4);
}

// Two contacts of a yawed wheel are at different places along the track, also if they share a grid. The radius at each
// is the distance from the axle, less the overlap of the undeformed bodies.
TEST(CreepInputsTest, RollingRadiiOfAYawedWheelBelongToThePlacesOfItsContacts)
{
  WheelsetContact contact(manchesterScene());
  bool two_on_a_wheel = false;
  for (int i = 0; i <= 60; ++i)
  {
    const WheelsetResult& result = okResult(contact, stateAt(4e-3 + 5e-5 * i, 5e4, 40e-3));
    two_on_a_wheel = two_on_a_wheel || result.patches.size() > 2;
    const Eigen::Vector3d axle = (Eigen::AngleAxisd(result.yaw, Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(result.roll, Eigen::Vector3d::UnitX())) *
                                 Eigen::Vector3d::UnitY();
    for (const PatchResult& patch : result.patches)
    {
      const Eigen::Vector3d place(patch.pose.x, patch.pose.y - result.y, patch.pose.z - result.z);
      const double distance = place.cross(axle).norm();
      EXPECT_NEAR(patch.rolling_radius, distance, patch.approach / std::cos(patch.contact_angle) + 2e-5);
    }
  }
  EXPECT_TRUE(two_on_a_wheel);
}

// Contact of two areas on one wheel: each is a contact of its own, and their forces add up to those of the wheel. Rails
// are prisms: no force along them.
TEST(CreepInputsTest, ForcesOfAllContactsAddUpToTheWrenchOnTheAxle)
{
  WheelsetContact contact(manchesterScene());
  bool two_on_a_wheel = false;
  for (const double y : {-5e-3, 0.0, 2e-3, 5.2e-3, 7e-3})
  {
    const WheelsetResult& result = okResult(contact, stateAt(y, 5e4, 4e-3));
    two_on_a_wheel = two_on_a_wheel || result.patches.size() > 2;
    double lateral = 0, vertical = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const PatchResult& patch : result.patches)
    {
      EXPECT_NEAR(std::atan2(patch.lateral_force, patch.vertical_force), patch.contact_angle, 1e-12);
      const Eigen::Vector3d force(0, -sideSign(patch.side) * patch.lateral_force, patch.vertical_force);
      lateral += force.y();
      vertical += force.z();
      moment += Eigen::Vector3d(patch.pose.x, patch.pose.y - result.y, patch.pose.z - result.z).cross(force);
    }
    EXPECT_NEAR(result.wheel.left.vertical + result.wheel.right.vertical, vertical, 1e-6);
    EXPECT_NEAR(result.wheel.left.vertical, result.rail.left.vertical_force, 1e-6 * 5e4);
    EXPECT_NEAR(result.wheel.right.lateral, result.rail.right.lateral_force, 1e-6 * 5e4);
    EXPECT_EQ(result.rail_wrench.force.x(), 0);
    EXPECT_NEAR(result.rail_wrench.force.y(), lateral, 1e-6);
    EXPECT_NEAR(result.rail_wrench.force.z(), vertical, 1e-6);
    // The moment about x is that of the pressure in each cell. The patches replace it by resultants at their centres:
    // on a curved surface these pass the true line of action by up to the width times the turn of the surface, 20 um.
    EXPECT_NEAR(result.rail_wrench.moment.x(), moment.x(), 2e-5 * 2e5);
    EXPECT_NEAR(result.rail_wrench.moment.y(), moment.y(), 1e-6);
    EXPECT_NEAR(result.rail_wrench.moment.z(), moment.z(), 1e-6);
  }
  EXPECT_TRUE(two_on_a_wheel);
}

// The stiffness is that of a contact alone. A rail that moves along the normal changes its force by as much, if it has
// no neighbour on the same wheel. The contact at 6.41 mm is not oval: the ellipse alone is 8 % too soft.
TEST(CreepInputsTest, NormalStiffnessIsTheChangeOfTheForcePerApproach)
{
  ContactModelConfig scene = fineScene(2e-3);
  scene.rail_profile = std::make_shared<Profile>(rail60E1());
  WheelsetContact loaded(scene);
  scene.wheelset.solve_height_and_roll = false;
  WheelsetContact held(scene);
  EXPECT_TRUE(std::isnan(firstOf(loaded.evaluate(stateAt(6.26e-3, 1.3e5, -0.019)), Side::left).normal_stiffness));
  for (const double y : {0.0, 3e-3, 6e-3, 6.41e-3, 7e-3})
  {
    const WheelsetResult under_load = okResult(loaded, stateAt(y, y == 6.41e-3 ? 69e3 : 5e4));
    const PatchResult& patch = firstOf(under_load, Side::left);
    WheelsetState state = heldAt(y, under_load.z, under_load.roll);
    const auto force = [&](double approach)
    {
      state.rail_displacement.left = {-approach * std::sin(patch.contact_angle),
                                      approach * std::cos(patch.contact_angle), 0};
      return firstOf(held.evaluate(state), Side::left).normal_force;
    };
    const double step = 2e-6;
    const double slope = (force(step) - force(-step)) / (2 * step);
    EXPECT_NEAR(patch.normal_stiffness, slope, 0.02 * slope) << "y = " << y;
  }
}

TEST(CreepInputsTest, TheAngleIsNegativeWhereTheWheelPressesTheRailInward)
{
  // A cone that falls to the field side.
  WheelsetContact contact(round_bodies::scene(-0.05));
  const WheelsetResult& result = okResult(contact, stateAt(0, 5e4));
  for (const PatchResult& patch : result.patches)
  {
    EXPECT_NEAR(patch.contact_angle, std::atan(-0.05), 1e-4);
    EXPECT_NEAR(patch.lateral_force, -0.05 * 5e4, 10);
  }
}

constexpr double light_load = 1e3;  ///< of each wheel [N]

/// Distance of the contact from the axle, for a wheel with one contact [m].
double rollingRadius(const WheelsetResult& result, Side side)
{
  EXPECT_EQ(patchesOf(result, side).size(), 1U);
  const PatchPose& pose = firstOf(result, side).pose;
  return std::sin(result.roll) * (pose.y - result.y) - std::cos(result.roll) * (pose.z - result.z);
}

/// Radius of the left wheel less that of the right one, at `y` [m].
double radiusDifference(WheelsetContact& contact, double y)
{
  contact.reset();
  const WheelsetResult& result = okResult(contact, stateAt(y, light_load));
  return rollingRadius(result, Side::left) - rollingRadius(result, Side::right);
}

/// A rigid cone on the arc of a rail head, side axes.
struct Cone
{
  double slope, radius;  ///< of the cone [-], and at the running circle [m]
  double crown_y;        ///< of the rail [m]

  struct Touch
  {
    double height, rolling_radius;  ///< of the axle, and distance of the contact from it [m]
  };

  /// Touch at `y` of the wheelset, and at a roll that lifts this wheel. The line of the cone is the tangent of the arc.
  Touch at(double y, double roll, const WheelsetConfig& wheelset) const
  {
    using round_bodies::crown_radius;
    const double angle = std::atan(slope) + roll, cosine = std::cos(roll), sine = std::sin(roll);
    const double across = crown_y - crown_radius * std::sin(angle) - y, rail = crown_radius * (std::cos(angle) - 1);
    // The distance below the axle is radius - slope * (distance along the axle - halfBase()).
    const double below =
        (radius + slope * wheelset.halfBase() - across * (sine + slope * cosine)) / (cosine - slope * sine);
    return {rail + below, across * sine + below * cosine};
  }
};

/// Difference of the rolling radii of two rigid cones. The roll at which both touch is found by halving.
double exactDifference(const Cone& left, const Cone& right, double y, const WheelsetConfig& wheelset)
{
  // A larger roll lifts the left wheel: to touch, the axle is then lower on the left.
  const auto left_is_higher = [&](double roll)
  { return left.at(y, roll, wheelset).height > right.at(-y, -roll, wheelset).height; };
  const double roll = lastWhere(left_is_higher, -0.01, 0.01);
  return left.at(y, roll, wheelset).rolling_radius - right.at(-y, -roll, wheelset).rolling_radius;
}

// Tolerance: the approach of 3 um under 1 kN differs between the sides by less than 1 %. The centre of pressure is
// found to a thousandth of the patch of 2 mm, on a slope of at most 1:10.
TEST(RollingRadius, OfConesDiffersAsThatOfRigidCones)
{
  struct Pair
  {
    double left_slope, right_slope, left_radius, right_radius;
  };
  const Pair pairs[] = {{1.0 / 40, 1.0 / 40, 0.460, 0.460},
                        {1.0 / 40, 1.0 / 40, 0.459, 0.460},
                        {1.0 / 20, 1.0 / 40, 0.460, 0.460},
                        {0.1, 0.01, 0.4595, 0.4605}};
  for (const Pair& pair : pairs)
  {
    ContactModelConfig scene = round_bodies::scene(0);
    scene.wheel_profile = {std::make_shared<Profile>(round_bodies::coneWheel(pair.left_slope)),
                           std::make_shared<Profile>(round_bodies::coneWheel(pair.right_slope))};
    scene.wheelset.rolling_radius = {pair.left_radius, pair.right_radius};
    const double crown_y = 0.5 * scene.track.gauge + round_bodies::half_head;
    const Cone left{pair.left_slope, pair.left_radius, crown_y}, right{pair.right_slope, pair.right_radius, crown_y};
    WheelsetContact contact(scene);
    for (const double y : {-5e-3, -1e-3, 0.0, 2e-3, 4e-3})
    {
      SCOPED_TRACE("slopes " + std::to_string(pair.left_slope) + " and " + std::to_string(pair.right_slope) + ", y " +
                   std::to_string(y));
      EXPECT_NEAR(radiusDifference(contact, y), exactDifference(left, right, y, scene.wheelset), 0.2e-6);
    }
  }
}

// Figures of EN 15302 (Annex E) for profile B, here where both wheels roll on its cone of 1:40: cases E2 (diameters 920
// mm) and E6 (920 mm on the right, 918 mm on the left). y and the difference are positive to the right.
//
// The tables neglect the roll of the wheelset. The roll, difference / 1500 mm, moves each contact along its wheel by
// the roll times the sum of rolling radius and crown radius, 460 mm and 300 mm: this adds 2 * (760 / 1500) / 40 = 2.5 %
// to the difference. Tolerance: the figures are rounded to 0.001 mm; the second order of the roll is below 0.1 um.
TEST(RollingRadius, OfTheConeOfEN15302DiffersAsInItsTablesAndByTheRoll)
{
  struct Figure
  {
    double left_radius, y, difference;  ///< [m]
  };
  const Figure figures[] = {{0.460, 0, 0},           {0.460, 1e-3, 0.050e-3},   {0.460, 2e-3, 0.100e-3},
                            {0.460, -2e-3, -0.1e-3}, {0.459, -2e-3, 0.900e-3},  {0.459, -1e-3, 0.950e-3},
                            {0.459, 0, 1.000e-3},    {0.459, 0.5e-3, 1.025e-3}, {0.459, 2e-3, 1.100e-3}};
  constexpr double slope = 1.0 / 40;
  for (const Figure& figure : figures)
  {
    ContactModelConfig scene;
    scene.wheel_profile = std::make_shared<Profile>(round_bodies::coneWheel(slope));
    scene.rail_profile = std::make_shared<Profile>(rail60E1());
    scene.track.rail_inclination = std::atan(1.0 / 20);
    scene.track.gauge = 1.43516;
    scene.wheelset.rolling_radius = {figure.left_radius, 0.460};
    WheelsetContact contact(scene);
    const double by_roll = 2 * slope * (0.460 + 0.300) / 1.500;
    EXPECT_NEAR(-radiusDifference(contact, -figure.y), figure.difference * (1 + by_roll), 0.6e-6)
        << "y " << figure.y << ", left radius " << figure.left_radius;
  }
}
}  // namespace
