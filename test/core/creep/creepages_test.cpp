// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "../../usual_headers.h"
#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double radius = 0.46, half_base = 0.75, angle = 0.05, running_speed = 20;

WheelsetMotion pureRolling()
{
  WheelsetMotion motion;
  motion.speed = running_speed;
  motion.rotation = running_speed / radius;
  return motion;
}

/// Contact of a conical wheel with half the cone angle `angle` on a thin rail at half_base, the axle at y without yaw.
ContactPlace conicalContact(double side, double y = 0)
{
  ContactPlace place;
  place.position = {0, side * half_base - y, -(radius + side * std::tan(angle) * y)};
  place.angle = side * angle;
  return place;
}

TEST(Creepages, CentredWheelsRollWithSpinOnly)
{
  for (const double side : {1.0, -1.0})
  {
    const Creepage creep = creepages(pureRolling(), conicalContact(side));
    EXPECT_NEAR(creep.x, 0, 1e-15);
    EXPECT_NEAR(creep.y, 0, 1e-15);
    // The rotation omega about y has the part -omega sin(angle) along the normal.
    EXPECT_NEAR(creep.spin, -side * std::sin(angle) / radius, 1e-15);
  }
}

TEST(Creepages, DisplacedConeRollsFreelyInKlingelsCurve)
{
  // The yaw rate -V tan(angle) y / (b r) makes up for the difference of the radii.
  const double y = 0.003;
  WheelsetMotion motion = pureRolling();
  for (const double side : {1.0, -1.0})
  {
    // Without yaw rate, the circumference is faster by the larger radius.
    EXPECT_NEAR(creepages(motion, conicalContact(side, y)).x, -side * std::tan(angle) * y / radius, 1e-15);
  }
  motion.yaw_rate = -running_speed * std::tan(angle) * y / (half_base * radius);
  for (const double side : {1.0, -1.0})
  {
    // y changes the lever by y / b.
    const double rest = std::tan(angle) * y / radius * y / half_base;
    EXPECT_NEAR(creepages(motion, conicalContact(side, y)).x, -rest, 1e-12);
  }
}

TEST(Creepages, LateralCreepageIsTheAngleBetweenWheelAndItsWay)
{
  WheelsetMotion motion = pureRolling();
  motion.yaw = 0.005;
  motion.lateral_velocity = 0.02;
  const double rolling_speed = motion.rotation * radius * std::sin(motion.yaw);
  // On its way up the wheel's cone, the lateral velocity is longer by 1 / cos(angle).
  const double expected = (motion.lateral_velocity - rolling_speed) / running_speed / std::cos(angle);
  for (const double side : {1.0, -1.0})
  {
    ContactPlace place = conicalContact(side);
    // The normal of the contact passes through the axle, and has no part along x.
    place.position.x() = -std::tan(motion.yaw) * (place.position.y() + std::tan(place.angle) * place.position.z());
    followRails(place, place, motion);
    EXPECT_NEAR(creepages(motion, place).y, expected, 1e-12);
  }
}

TEST(Creepages, WheelThatFollowsAnInclinedRailHasNone)
{
  // Yaw and way of the wheelset are those of the rail, also on the flange: it rolls straight on in turned axes.
  const double slope = 0.004;
  WheelsetMotion motion = pureRolling();
  motion.yaw = std::atan(slope);
  motion.lateral_velocity = running_speed * slope;
  motion.rotation *= std::hypot(1, slope);
  for (const double flange : {0.05, 1.2})
  {
    ContactPlace place = conicalContact(1);
    place.angle = flange;
    place.slope_y = slope;
    place.position = Eigen::AngleAxisd(motion.yaw, Eigen::Vector3d::UnitZ()) * place.position;
    followRails(place, place, motion);
    const Creepage creep = creepages(motion, place);
    EXPECT_NEAR(creep.x, 0, 1e-12) << flange;
    EXPECT_NEAR(creep.y, 0, 1e-12) << flange;
  }
}

TEST(Creepages, RailVelocitySubtracts)
{
  WheelsetMotion motion = pureRolling();
  ContactPlace place = conicalContact(1);
  place.rail_velocity_y = 0.01;
  followRails(place, place, motion);
  EXPECT_NEAR(creepages(motion, place).y, -0.01 / running_speed / std::cos(angle), 1e-15);
  motion.lateral_velocity = 0.01;
  followRails(place, place, motion);
  EXPECT_NEAR(creepages(motion, place).y, 0, 1e-15);
}

TEST(Creepages, ReversedVehicleHasReversedVelocities)
{
  WheelsetMotion motion = pureRolling();
  motion.lateral_velocity = 0.02;
  motion.yaw_rate = 0.1;
  motion.rotation *= 1.001;
  const ContactPlace place = conicalContact(1, 0.002);
  const Creepage forward = creepages(motion, place);
  for (double* velocity : {&motion.speed, &motion.lateral_velocity, &motion.yaw_rate, &motion.rotation})
  {
    *velocity = -*velocity;
  }
  const Creepage backward = creepages(motion, place);
  EXPECT_EQ(backward.x, -forward.x);
  EXPECT_EQ(backward.y, -forward.y);
  EXPECT_EQ(backward.spin, -forward.spin);
}

TEST(FollowRails, ConeOnTwoRailsRollsAboutTheAxisOfItsNormals)
{
  // A lateral displacement raises the left wheel and lowers the right one, by tan(angle) each.
  WheelsetMotion motion = pureRolling();
  motion.lateral_velocity = 0.05;
  const ContactPlace left = conicalContact(1), right = conicalContact(-1);
  followRails(left, right, motion);
  EXPECT_NEAR(motion.roll_rate, std::tan(angle) * 0.05 / (half_base - std::tan(angle) * radius), 1e-15);
  // The roll adds its lateral velocity at the rail.
  const double expected = (0.05 + motion.roll_rate * radius) / running_speed / std::cos(angle);
  EXPECT_NEAR(creepages(motion, left).y, expected, 1e-15);
}

TEST(Creepages, AreThoseOfTheReferenceCode)
{
  // A left wheel by CONTACT: S1002 on UIC60, r0 = 0.46 m, 20 m/s, height and roll held. The place of the contact
  // follows from its x creepage, which is therefore not compared.
  WheelsetMotion motion = pureRolling();
  motion.yaw = 0.004;
  motion.roll = 1.716539e-4;
  motion.rotation = 43.5;
  motion.lateral_velocity = -0.02;
  motion.yaw_rate = 0.02;
  ContactPlace place;
  place.angle = 0.09207;
  place.position = {0, 0.7475, -0.46075};
  // The normal of the contact passes through the axle, and has no part along x.
  place.position.x() = -motion.yaw * (place.position.y() + std::tan(place.angle) * place.position.z());
  const Creepage creep = creepages(motion, place);
  EXPECT_NEAR(creep.y, -5.020627e-03, 1e-5);
  // The code takes the angle of a contact plane, which differs from that at the centre of the contact by 0.06 mrad.
  EXPECT_NEAR(creep.spin, -1.984684e-01, 2e-4);
}
}  // namespace
}  // namespace wheel_rail_contact::core
