// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/neighbour_forces.h"

#include "../usual_headers.h"
#include "message_bytes.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double compliance = 1e-8;  ///< lateral, of an upright rail [m/N]

NodeConfig configWith(std::size_t neighbours)
{
  NodeConfig config;
  config.model.track.rail_inclination = 0;
  core::ComplianceTable influence;
  influence.lateral_lateral = compliance;
  config.neighbours.assign(neighbours, {"topic", 2.5, influence});
  return config;
}

/// A result with a stamp [s] and lateral forces on both rails [N].
ResultHead resultAt(double time, double left, double right = 0)
{
  ResultHead result;
  result.stamp = ros::Time(time);
  result.left_rail.lateral_force = left;
  result.right_rail.lateral_force = right;
  return result;
}

/// Lateral force of the neighbours [N] that is used for the left rail at a stamp [s].
double forceAt(const NeighbourForces& forces, double time)
{
  return forces.effectAt(ros::Time(time)).deflection.left.lateral / compliance;
}
}  // namespace

// The message gives a number of patches that no memory can hold.
TEST(NeighbourForces, ResultIsReadWithoutItsPatches)
{
  WheelsetContact message;
  message.header.stamp = ros::Time(10);
  message.header.frame_id = "track";
  message.status = WheelsetContact::LIFT_OFF;
  message.status_text = "the left wheel carries no load";
  message.left_rail.lateral_force = 1e3;
  message.right_rail.moment = 2e3;
  std::vector<std::uint8_t> bytes = bytesOf(message);
  const std::size_t patches = bytes.size() - bytesOf(message.derivatives).size() - sizeof(message.solve_time) -
                              sizeof(message.implausible_force) - sizeof(std::uint32_t);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(patches), sizeof(std::uint32_t), 0xff);

  ResultHead result;
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(in, result);
  EXPECT_EQ(result.stamp, message.header.stamp);
  EXPECT_EQ(result.status, message.status);
  EXPECT_EQ(bytesOf(result.left_rail), bytesOf(message.left_rail));
  EXPECT_EQ(bytesOf(result.right_rail), bytesOf(message.right_rail));
}

TEST(NeighbourForces, EffectIsCompleteIfTheForcesOfAllNeighboursAreKnown)
{
  EXPECT_TRUE(NeighbourForces(configWith(0)).effectAt(ros::Time(10)).complete);
  NeighbourForces forces(configWith(2));
  forces.add(0, resultAt(10.0, 1e3));
  EXPECT_FALSE(forces.effectAt(ros::Time(10.2)).complete) << "no result of the second neighbour";
  forces.add(1, resultAt(10.1, 0));
  EXPECT_FALSE(forces.effectAt(ros::Time(10.1)).complete);
  EXPECT_TRUE(forces.effectAt(ros::Time(10.2)).complete) << "a force of zero is a known force";
  EXPECT_FALSE(forces.effectAt(ros::Time(11.05)).complete) << "the result of the first neighbour is too old";
}

TEST(NeighbourForces, NewestResultBeforeTheStampIsUsed)
{
  NeighbourForces forces(configWith(1));
  EXPECT_EQ(forceAt(forces, 10.0), 0) << "no result yet";
  forces.add(0, resultAt(10.00, 1e3));
  forces.add(0, resultAt(10.25, 2e3));
  forces.add(0, resultAt(10.50, 3e3));
  EXPECT_EQ(forceAt(forces, 10.00), 0) << "a result with the same stamp must not be used";
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.25), 1e3);
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.375), 2e3);
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.50), 2e3);
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.75), 3e3);
}

TEST(NeighbourForces, ResultOlderThanASecondIsNotUsed)
{
  NeighbourForces forces(configWith(1));
  forces.add(0, resultAt(10, 1e3));
  EXPECT_DOUBLE_EQ(forceAt(forces, 11), 1e3);
  EXPECT_EQ(forceAt(forces, 11.001), 0);
  // The difference to the largest stamp of a ros::Time does not fit in a ros::Duration.
  constexpr double largest_stamp = 4294967295.0;
  EXPECT_EQ(forceAt(forces, largest_stamp), 0);
  EXPECT_FALSE(forces.effectAt(ros::Time(largest_stamp)).complete);
  EXPECT_TRUE(forces.reachBackFrom(ros::Time(largest_stamp)));
}

TEST(NeighbourForces, UnusableResultGivesNoForce)
{
  NeighbourForces forces(configWith(1));
  forces.add(0, resultAt(10.0, 1e3));
  ResultHead unusable = resultAt(10.1, 2e3);
  unusable.status = WheelsetContact::NOT_CONVERGED;
  forces.add(0, unusable);
  EXPECT_EQ(forceAt(forces, 10.2), 0);
  EXPECT_FALSE(forces.effectAt(ros::Time(10.2)).complete);
  ResultHead lifted = resultAt(10.2, 3e3);
  lifted.status = WheelsetContact::LIFT_OFF;
  forces.add(0, lifted);
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.3), 3e3);
  forces.add(0, resultAt(10.3, std::nan("")));
  EXPECT_EQ(forceAt(forces, 10.4), 0);
  EXPECT_FALSE(forces.effectAt(ros::Time(10.4)).complete);
}

TEST(NeighbourForces, ResultsOfThePreviousLoopAreDiscarded)
{
  NeighbourForces forces(configWith(1));
  forces.add(0, resultAt(10.0, 1e3));
  forces.add(0, resultAt(10.4, 2e3));
  forces.add(0, resultAt(10.2, 3e3));
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.2), 1e3);
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.5), 3e3);
}

TEST(NeighbourForces, EffectsOfNeighboursAddUpOnEachRail)
{
  NeighbourForces forces(configWith(2));
  forces.add(0, resultAt(10.0, 1e3, 5e3));
  forces.add(1, resultAt(10.1, 2e3, -2e3));
  const auto moved = forces.effectAt(ros::Time(10.2)).deflection;
  EXPECT_DOUBLE_EQ(moved.left.lateral, compliance * 3e3);
  EXPECT_DOUBLE_EQ(moved.right.lateral, compliance * 3e3);
  EXPECT_EQ(forceAt(forces, 10.1), compliance * 1e3 / compliance)
      << "the result of the second neighbour has the same stamp";
}

TEST(NeighbourForces, OnlyTheNewestResultsAreStored)
{
  NeighbourForces forces(configWith(1));
  for (std::size_t i = 0; i <= NeighbourForces::capacity; ++i)
  {
    forces.add(0, resultAt(10 + 1e-4 * static_cast<double>(i), 1e3));
  }
  EXPECT_EQ(forceAt(forces, 10.00005), 0);
  EXPECT_DOUBLE_EQ(forceAt(forces, 10.00015), 1e3);
}

// On a rail inclined by 0.1 rad, a vertical force Q has the component -0.1 Q across the rail.
TEST(NeighbourForces, EachRailHasItsOwnInfluenceAndInclination)
{
  NodeConfig config = configWith(1);
  config.neighbours[0].influence.right.lateral_lateral = 3 * compliance;
  config.model.track.rail_inclination = {0.1, 0};
  NeighbourForces forces(config);
  ResultHead result = resultAt(10, 0, 1e3);
  result.left_rail.vertical_force = 1e4;
  forces.add(0, result);
  const auto moved = forces.effectAt(ros::Time(10.1)).deflection;
  EXPECT_DOUBLE_EQ(moved.left.lateral, -compliance * 1e4 * std::sin(0.1) * std::cos(0.1));
  EXPECT_DOUBLE_EQ(moved.right.lateral, 3 * compliance * 1e3);
}
