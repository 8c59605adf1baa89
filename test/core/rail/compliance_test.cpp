// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/rail_compliance.h"

#include "../../manchester_scene.h"
#include "../../refusal.h"
#include "../../seeded.h"
#include "core/rail/neighbours.h"

using namespace wheel_rail_contact::core;

namespace
{
/// Force of a wheel on an upright rail at the height of the reference point, `y` [m] outward from the axis of the rail.
RailForce wheelForce(double lateral, double vertical, double y)
{
  return {lateral, vertical, vertical * y};
}

void expectRejected(const ComplianceTable& table, const std::string& entry)
{
  EXPECT_TRUE(contains(refusalOf([&] { table.validate(); }), entry));
}

// Finite elements of 60E1 on pads of 40/100 kN/mm (quadratic solids, converged to 0.5 %): 30 kN outward alone displace
// the head by 1.82 mm and turn it by 9.0 mrad. With 75 kN down at 20 mm towards the track centre: 1.36 mm and 5.1 mrad.
// Tolerance: the entries of the table have three digits (0.1 % to 0.2 %), the table is within 1.5 % of the finite
// elements, and their results are given with two or three digits.
TEST(ComplianceTest, SoftPadsGiveTheDeflectionOfFiniteElements)
{
  const RailDeflection alone = deflection(softPads(), wheelForce(30e3, 0, 0));
  EXPECT_NEAR(alone.lateral, 1.82e-3, 0.015 * 1.82e-3);
  EXPECT_NEAR(alone.roll, 9.0e-3, 0.015 * 9.0e-3);
  EXPECT_EQ(alone.vertical, 0);

  const RailDeflection with_load = deflection(softPads(), wheelForce(30e3, 75e3, -0.020));
  EXPECT_NEAR(with_load.lateral, 1.36e-3, 0.015 * 1.36e-3);
  EXPECT_NEAR(with_load.roll, 5.1e-3, 0.015 * 5.1e-3);
  EXPECT_NEAR(with_load.vertical, -5.6e-9 * 75e3, 1e-18);  // rounding
}

// By hand: 30 kN displace the head by 60.5 um/kN and turn it by 303 urad/kN. The moment M = -75 kN * 20 mm displaces it
// back by 303 um/(kN m) and turns it back by 2630 urad/(kN m).
TEST(ComplianceTest, DeflectionIsTableTimesForcesOutwardByALateralAndDownByAVerticalOne)
{
  const RailDeflection moved = deflection(softPads(), wheelForce(30e3, 75e3, -0.020));
  EXPECT_NEAR(moved.lateral, 1.815e-3 - 0.4545e-3, 1e-15);
  EXPECT_NEAR(moved.roll, 9.09e-3 - 3.945e-3, 1e-15);
  const RailDeflection loaded = deflection(softPads(), {1e4, 1e5, 0});
  EXPECT_GT(loaded.lateral, 0);
  EXPECT_GT(loaded.roll, 0);
  EXPECT_LT(loaded.vertical, 0);
}

// Maxwell-Betti: the work of the first force on the deflection by the second one equals that of the second force on the
// deflection by the first one. This also holds in the track axes of an inclined rail.
TEST(ComplianceTest, WorkIsReciprocal)
{
  Seeded random(20111U);
  const auto work = [](const RailForce& force, const RailDeflection& moved)
  { return force.lateral * moved.lateral - force.vertical * moved.vertical + force.moment * moved.roll; };
  for (int i = 0; i < 100; ++i)
  {
    const double inclination = 0.1 * random.unit();
    const RailForce first{3e4 * random.unit(), 1e5 * random.unit(), 2e3 * random.unit()};
    const RailForce second{3e4 * random.unit(), 1e5 * random.unit(), 2e3 * random.unit()};
    const double there = work(first, deflectionInTrack(softPads(), second, inclination));
    const double back = work(second, deflectionInTrack(softPads(), first, inclination));
    EXPECT_NEAR(there, back, 1e-11);  // works up to 100 N m, rounding
    EXPECT_GE(work(first, deflectionInTrack(softPads(), first, inclination)), 0);
  }
}

TEST(ComplianceTest, TrackAxesAreThoseOfAnUprightRail)
{
  const RailForce force{2e4, 8e4, -500};
  const RailDeflection own = deflection(softPads(), force);
  const RailDeflection track = deflectionInTrack(softPads(), force, 0);
  EXPECT_EQ(own.lateral, track.lateral);
  EXPECT_EQ(own.vertical, track.vertical);
  EXPECT_EQ(own.roll, track.roll);
}

// A downward force along the axis of an inclined rail has an outward component. It displaces the rail along its axis
// only.
TEST(ComplianceTest, ForceAlongTheAxisOfAnInclinedRailOnlyCompressesIt)
{
  const double inclination = 0.025;
  const double load = 1e5;
  const RailForce along_axis{load * std::sin(inclination), load * std::cos(inclination), 0};
  const RailDeflection moved = deflectionInTrack(softPads(), along_axis, inclination);
  const double compression = softPads().vertical_vertical * load;
  EXPECT_NEAR(moved.lateral, compression * std::sin(inclination), 1e-17);  // rounding of 0.5 mm
  EXPECT_NEAR(moved.vertical, -compression * std::cos(inclination), 1e-17);
  EXPECT_NEAR(moved.roll, 0, 1e-17);
}

// Normal to its axis, an inclined rail has the compliance of the upright one, turned by the inclination.
TEST(ComplianceTest, ForceNormalToTheAxisOfAnInclinedRailMovesItNormalToTheAxis)
{
  const double inclination = 0.025;
  const RailForce square{1e4 * std::cos(inclination), -1e4 * std::sin(inclination), 0};
  const RailDeflection moved = deflectionInTrack(softPads(), square, inclination);
  const double shift = softPads().lateral_lateral * 1e4;
  EXPECT_NEAR(moved.lateral, shift * std::cos(inclination), 1e-17);
  EXPECT_NEAR(moved.vertical, shift * std::sin(inclination), 1e-17);
  EXPECT_NEAR(moved.roll, softPads().lateral_roll * 1e4, 1e-17);
}

TEST(ComplianceTest, ZeroTableIsARigidRail)
{
  const ComplianceTable rigid;
  EXPECT_NO_THROW(rigid.validate());
  const RailDeflection moved = deflectionInTrack(rigid, {1e5, 1e5, 1e3}, 0.025);
  EXPECT_EQ(moved.lateral, 0);
  EXPECT_EQ(moved.vertical, 0);
  EXPECT_EQ(moved.roll, 0);
}

TEST(ComplianceTest, InvalidTablesAreRejectedWithTheNameOfTheEntry)
{
  EXPECT_NO_THROW(softPads().validate());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, -1e-9})
  {
    ComplianceTable table = softPads();
    table.lateral_lateral = bad;
    expectRejected(table, "lateral_lateral");
    table = softPads();
    table.roll_roll = bad;
    expectRejected(table, "roll_roll");
    table = softPads();
    table.vertical_vertical = bad;
    expectRejected(table, "vertical_vertical");
  }
  ComplianceTable table = softPads();
  table.lateral_roll = nan;
  expectRejected(table, "lateral_roll");
  table.lateral_roll = 1.001 * std::sqrt(table.lateral_lateral * table.roll_roll);
  expectRejected(table, "lateral_roll");
}

/// Influence of a rail that rises at the greater distance from its load.
const std::vector<RailInfluence> two_places{{1.8, {4e-8, 2e-7, 1.6e-6, 8e-10}}, {2.5, {2e-8, 1e-7, 1.0e-6, -4e-10}}};

std::string errorText(const std::vector<RailInfluence>& listed, double distance)
{
  return refusalOf([&] { influenceAt(listed, distance); });
}

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
}  // namespace
