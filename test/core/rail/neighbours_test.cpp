// SPDX-License-Identifier: BSD-3-Clause
#include "core/rail/neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

using namespace wheel_rail_contact::core;

namespace
{
/// Influence of a rail that rises at the greater distance from its load.
const std::vector<RailInfluence> two_places{{1.8, {4e-8, 2e-7, 1.6e-6, 8e-10}}, {2.5, {2e-8, 1e-7, 1.0e-6, -4e-10}}};

std::string errorText(const std::vector<RailInfluence>& listed, double distance)
{
  try
  {
    influenceAt(listed, distance);
    return "accepted";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}
}  // namespace

TEST(NeighboursTest, ListedDistanceHasTheListedInfluence)
{
  for (const RailInfluence& listed : two_places)
  {
    const ComplianceTable found = influenceAt(two_places, listed.distance);
    EXPECT_EQ(found.lateral_lateral, listed.influence.lateral_lateral);
    EXPECT_EQ(found.lateral_roll, listed.influence.lateral_roll);
    EXPECT_EQ(found.roll_roll, listed.influence.roll_roll);
    EXPECT_EQ(found.vertical_vertical, listed.influence.vertical_vertical);
  }
}

// 1.975 m is a quarter of the way from 1.8 m to 2.5 m. Tolerance: rounding.
TEST(NeighboursTest, InfluenceIsLinearBetweenListedDistances)
{
  const ComplianceTable found = influenceAt(two_places, 1.975);
  EXPECT_NEAR(found.lateral_lateral, 3.5e-8, 1e-21);
  EXPECT_NEAR(found.lateral_roll, 1.75e-7, 1e-20);
  EXPECT_NEAR(found.roll_roll, 1.45e-6, 1e-19);
  EXPECT_NEAR(found.vertical_vertical, 5e-10, 1e-22);
}

TEST(NeighboursTest, DistanceOutsideTheListedRangeIsRejectedWithTheRange)
{
  for (const double distance : {1.7, 2.6, std::nan("")})
  {
    EXPECT_NE(errorText(two_places, distance).find("1.8 m to 2.5 m"), std::string::npos) << distance;
  }
  EXPECT_NE(errorText(two_places, 3.25).find("3.25 m"), std::string::npos);
  EXPECT_NE(errorText({}, 1.8).find("the table has none"), std::string::npos);
}

// By hand, for an upright rail: lateral displacement 20 um/kN and 100 um/(kN m), roll 100 urad/kN and 1000 urad/(kN m).
TEST(NeighboursTest, DeflectionIsInfluenceTimesForceOfTheNeighbour)
{
  const RailDeflection moved = neighbourDeflection({{two_places[1].influence, {20e3, 100e3, -1e3}}}, 0);
  EXPECT_NEAR(moved.lateral, 400e-6 - 100e-6, 1e-18);
  EXPECT_NEAR(moved.vertical, 40e-6, 1e-19);  // up
  EXPECT_NEAR(moved.roll, 2000e-6 - 1000e-6, 1e-18);
}

// Two neighbours on an inclined rail cause the sum of the deflections by each one alone. Without neighbours there is no
// deflection.
TEST(NeighboursTest, DeflectionsByNeighboursAdd)
{
  const double inclination = 0.025;
  const NeighbourForce a{two_places[0].influence, {10e3, 80e3, -2e3}};
  const NeighbourForce b{two_places[1].influence, {-5e3, 120e3, 1e3}};
  const RailDeflection both = neighbourDeflection({a, b}, inclination);
  const RailDeflection only_a = deflectionInTrack(a.influence, a.force, inclination);
  const RailDeflection only_b = deflectionInTrack(b.influence, b.force, inclination);
  EXPECT_EQ(both.lateral, only_a.lateral + only_b.lateral);
  EXPECT_EQ(both.vertical, only_a.vertical + only_b.vertical);
  EXPECT_EQ(both.roll, only_a.roll + only_b.roll);
  const RailDeflection none = neighbourDeflection({}, inclination);
  EXPECT_EQ(none.lateral, 0);
  EXPECT_EQ(none.vertical, 0);
  EXPECT_EQ(none.roll, 0);
}
