// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "round_bodies.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double light_load = 1e3;  ///< of each wheel [N]

/// Distance of the contact from the axle, for a wheel with one contact [m].
double rollingRadius(const WheelsetResult& result, Side side)
{
  double radius = 0;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == side)
    {
      EXPECT_EQ(radius, 0) << "a second contact";
      const double y = patch.pose.y - result.y, z = patch.pose.z - result.z;
      radius = std::sin(result.roll) * y - std::cos(result.roll) * z;
    }
  }
  return radius;
}

/// Radius of the left wheel less that of the right one, at `y` [m].
double radiusDifference(WheelsetContact& contact, double y)
{
  contact.reset();
  const WheelsetResult& result = contact.evaluate(stateAt(y, light_load));
  EXPECT_EQ(result.status, ContactStatus::ok) << result.reason;
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
  double low = -0.01, high = 0.01;
  for (int halving = 0; halving < 60; ++halving)
  {
    const double roll = 0.5 * (low + high);
    // A larger roll lifts the left wheel: to touch, the axle is then lower on the left.
    (left.at(y, roll, wheelset).height > right.at(-y, -roll, wheelset).height ? low : high) = roll;
  }
  return left.at(y, low, wheelset).rolling_radius - right.at(-y, -low, wheelset).rolling_radius;
}
}  // namespace

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
