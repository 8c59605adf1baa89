// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/creep_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "examples/simulate_wheelset/wheelset_dynamics.h"
#include "wheel_rail_contact/core/creep.h"

using namespace simulate_wheelset;

namespace
{
const ContactEllipse ellipse = {0.006, 0.005, 100e3};
const CreepParameters parameters;

TEST(CreepForce, SmallCreepageFollowsTheLinearTheory)
{
  const CreepLaw law(parameters);
  const auto c = wheel_rail_contact::core::kalkerCoefficients(1.2, parameters.poisson);
  const double product = ellipse.along * ellipse.across, cube = std::pow(product, 1.5);
  const double g = parameters.shear_modulus, small = 1e-9;
  // The saturation changes the force by a third of its ratio to the limit, here 1e-5.
  EXPECT_NEAR(law.force(ellipse, {small, 0, 0}).along / (-g * product * c.c11 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, small, 0}).across / (-g * product * c.c22 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, small, 0}).moment / (g * cube * c.c23 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, 0, small}).across / (-g * cube * c.c23 * small), 1, 1e-5);
  EXPECT_NEAR(law.force(ellipse, {0, 0, small}).moment / (-g * product * product * c.c33 * small), 1, 1e-5);
}

TEST(CreepForce, GrowsMonotonicallyToTheFrictionLimit)
{
  const CreepLaw law(parameters);
  const double limit = parameters.friction * ellipse.normal_force;
  double last = 0;
  for (int i = 1; i <= 200; ++i)
  {
    const CreepForce force = law.force(ellipse, {5e-5 * i, 2e-5 * i, 0});
    const double resultant = std::hypot(force.along, force.across);
    EXPECT_LE(resultant, limit * (1 + 1e-12));
    EXPECT_GE(resultant, last * (1 - 1e-12));
    last = resultant;
  }
  EXPECT_NEAR(last, limit, 1e-9 * limit);
}

TEST(CreepForce, FrictionNeverDrives)
{
  const unsigned seed = 20;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const CreepLaw law(parameters);
  for (int i = 0; i < 1000; ++i)
  {
    const Creepage creepage = {0.01 * unit(random), 0.01 * unit(random), unit(random)};
    const ContactEllipse shape = {0.006 * (1.1 + unit(random)), 0.005 * (1.1 + unit(random)), 100e3};
    const CreepForce force = law.force(shape, creepage);
    const double power = force.along * creepage.along + force.across * creepage.across + force.moment * creepage.spin;
    EXPECT_LE(power, 0) << "seed " << seed << ", case " << i;
  }
}

TEST(CreepForce, NoCreepageHasNoForce)
{
  const CreepForce force = CreepLaw(parameters).force(ellipse, {});
  EXPECT_EQ(force.along, 0);
  EXPECT_EQ(force.across, 0);
  EXPECT_EQ(force.moment, 0);
}

constexpr double radius = 0.46, half_base = 0.75, cone = 0.05, speed = 10;

/// Conical wheels on thin rails at half_base. With yaw the contacts lie where the normal passes through the axle.
ContactReply coneContact(double y, double yaw = 0)
{
  ContactReply contact;
  contact.is_usable = true;
  for (const double side : {1.0, -1.0})
  {
    ContactPoint point;
    point.is_left = side > 0;
    point.rolling_radius = radius + side * cone * y;
    const double lever = side * half_base - y;
    point.position = {yaw * (side * cone * point.rolling_radius - lever), lever, -point.rolling_radius};
    point.angle = side * std::atan(cone);
    point.normal_force = 100e3;
    point.semi_axis_along = 0.006;
    point.semi_axis_across = 0.005;
    contact.points.push_back(point);
  }
  return contact;
}

Motion rolling(double y)
{
  Motion motion;
  motion.y = y;
  motion.spin = speed / radius;
  return motion;
}

TEST(Creepage, CentredWheelsRollWithSpinOnly)
{
  const ContactReply contact = coneContact(0);
  for (const ContactPoint& point : contact.points)
  {
    const Creepage creepage = creepageAt(point, rolling(0), {}, 0, speed);
    EXPECT_NEAR(creepage.along, 0, 1e-12);
    EXPECT_NEAR(creepage.across, 0, 1e-12);
    EXPECT_NEAR(creepage.spin, -std::sin(point.angle) / radius, 1e-12);
  }
}

TEST(Creepage, DisplacedConeRollsFreelyInAKinematicCurve)
{
  // Klingel: the yaw rate -V cone y / (b r) equalises the speeds of both wheels.
  const double y = 0.003;
  Motion motion = rolling(y);
  motion.yaw_rate = -speed * cone * y / (half_base * radius);
  for (const ContactPoint& point : coneContact(y).points)
  {
    const double along = creepageAt(point, motion, {}, 0, speed).along;
    EXPECT_NEAR(along, 0, 0.005 * cone * y / radius);  // y changes the lever by up to 0.4 % of the base
  }
}

TEST(Creepage, LateralCreepageIsThatOfRateAndYaw)
{
  Motion motion = rolling(0);
  motion.y_rate = 0.02;
  motion.yaw = 0.005;
  const ContactReply contact = coneContact(0, motion.yaw);
  const FollowingRates rates = followingRates(contact, motion);
  for (const ContactPoint& point : contact.points)
  {
    // The roll rate adds its velocity at the rail; the cosine of the contact angle differs from 1 by 0.1 %.
    const double expected = (motion.y_rate + rates.roll * radius) / speed - motion.yaw;
    EXPECT_NEAR(creepageAt(point, motion, rates, 0, speed).across, expected, 0.01 * std::abs(expected));
  }
}

TEST(FollowingRates, NoContactMovesAlongItsNormal)
{
  const ContactReply contact = coneContact(0.002);
  Motion motion = rolling(0.002);
  motion.y_rate = 0.05;
  const FollowingRates rates = followingRates(contact, motion);
  EXPECT_NE(rates.roll, 0);
  for (const ContactPoint& point : contact.points)
  {
    const double y_rate = motion.y_rate - rates.roll * point.position.z();
    const double z_rate = rates.z + rates.roll * point.position.y();
    EXPECT_NEAR(z_rate * std::cos(point.angle) - y_rate * std::sin(point.angle), 0, 1e-12);
  }
}

TEST(RailForces, CarryTheLoadAndGuideToTheCentre)
{
  const CreepLaw law((CreepParameters()));
  const RailForces centred = railForces(coneContact(0), rolling(0), speed, law);
  EXPECT_NEAR(centred.normal_force.z(), 200e3 * std::cos(std::atan(cone)), 1e-6);
  EXPECT_NEAR(centred.force().y(), 0, 1e-6);
  EXPECT_NEAR(centred.moment().z(), 0, 1e-6);
  // Displaced to the left, the left wheel is driven forward: the wheelset turns to the right.
  const RailForces displaced = railForces(coneContact(0.003), rolling(0.003), speed, law);
  EXPECT_GT(displaced.creep[0].along, 0);
  EXPECT_LT(displaced.creep[1].along, 0);
  EXPECT_LT(displaced.moment().z(), 0);
}

TEST(RailForces, FrictionPowerIsThatOfDragAndMotion)
{
  // Without acceleration, all work of the rails on the wheelset becomes heat in the contacts.
  const CreepLaw law((CreepParameters()));
  Motion motion = rolling(0.003);
  motion.y_rate = 0.03;
  motion.yaw = 0.001;
  motion.yaw_rate = 0.02;
  const ContactReply contact = coneContact(0.003);
  const FollowingRates rates = followingRates(contact, motion);
  const RailForces forces = railForces(contact, motion, speed, law);
  const double work = forces.creep_force.x() * speed + forces.creep_force.y() * motion.y_rate +
                      forces.creep_force.z() * rates.z + forces.creep_moment.x() * rates.roll +
                      forces.creep_moment.z() * motion.yaw_rate + forces.spin_moment * motion.spin;
  EXPECT_GT(forces.friction_power, 0);
  EXPECT_NEAR(-work / forces.friction_power, 1, 1e-9);
}

}  // namespace
