// SPDX-License-Identifier: BSD-3-Clause
#include <wheel_rail_contact/WheelsetContact.h>
#include <Eigen/Geometry>
#include <boost/make_shared.hpp>

#include "../refusal.h"
#include "ros/evaluation/contact_input.h"
#include "ros/evaluation/conversions.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

geometry_msgs::PoseStamped pose(const Eigen::Quaterniond& q = Eigen::Quaterniond::Identity(),
                                const std::string& frame = "track")
{
  geometry_msgs::PoseStamped message;
  message.header.stamp = ros::Time(10);
  message.header.frame_id = frame;
  message.pose.position.x = 4;
  message.pose.position.y = 0.002;
  message.pose.position.z = 0.46;
  message.pose.orientation.w = q.w();
  message.pose.orientation.x = q.x();
  message.pose.orientation.y = q.y();
  message.pose.orientation.z = q.z();
  return message;
}

geometry_msgs::WrenchStamped wrench(double fy, double fz, double tx)
{
  geometry_msgs::WrenchStamped message;
  message.header.stamp = ros::Time(10);
  message.wrench.force.y = fy;
  message.wrench.force.z = fz;
  message.wrench.torque.x = tx;
  return message;
}

template <typename Message>
boost::shared_ptr<const Message> shared(const Message& message)
{
  return boost::make_shared<const Message>(message);
}

ContactInput input(const geometry_msgs::PoseStamped& p, const geometry_msgs::WrenchStamped& load = wrench(0, -2e5, 3))
{
  ContactInput in;
  in.pose = shared(p);
  in.load = shared(load);
  return in;
}

RailDisplacements displacements()
{
  RailDisplacements message;
  message.left.lateral = 1e-3;
  message.left.vertical = -2e-3;
  message.left.roll = 3e-3;
  message.right.lateral = -4e-3;
  message.right.vertical = 5e-3;
  message.right.roll = -6e-3;
  message.left.lateral_velocity = 0.01;
  message.left.vertical_velocity = -0.02;
  message.left.roll_rate = 0.03;
  message.right.roll_rate = -0.04;
  return message;
}

/// Velocities with different numbers. @param frame frame_id
geometry_msgs::TwistStampedConstPtr twist(const std::string& frame)
{
  geometry_msgs::TwistStamped message;
  message.header.frame_id = frame;
  message.twist.linear.x = 20;
  message.twist.linear.y = 0.02;
  message.twist.linear.z = -0.03;
  message.twist.angular.x = 0.04;
  message.twist.angular.y = 43;
  message.twist.angular.z = -0.05;
  return shared(message);
}

/// Transform of the frame "vehicle" at 10 s: at y = 10 mm, turned by this yaw [rad].
geometry_msgs::TransformStamped vehicle(double yaw)
{
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "track";
  transform.header.stamp = ros::Time(10);
  transform.child_frame_id = "vehicle";
  transform.transform.translation.y = 0.01;
  transform.transform.rotation.z = std::sin(yaw / 2);
  transform.transform.rotation.w = std::cos(yaw / 2);
  return transform;
}

void expectMotion(const core::WheelsetMotion& motion, const Eigen::Vector3d& velocity, const Eigen::Vector3d& rotation)
{
  EXPECT_NEAR(motion.speed, velocity.x(), 1e-12);
  EXPECT_NEAR(motion.lateral_velocity, velocity.y(), 1e-12);
  EXPECT_NEAR(motion.vertical_velocity, velocity.z(), 1e-12);
  EXPECT_NEAR(motion.roll_rate, rotation.x(), 1e-12);
  EXPECT_NEAR(motion.rotation, rotation.y(), 1e-12);
  EXPECT_NEAR(motion.yaw_rate, rotation.z(), 1e-12);
}

core::WheelsetState convert(const ContactInput& in, const tf2::BufferCore& transforms = tf2::BufferCore())
{
  return toState(in, "track", transforms);
}

/// Status and reason with which an input is refused.
using Refusal = std::pair<int, std::string>;

Refusal refusal(const ContactInput& in, const tf2::BufferCore& transforms = tf2::BufferCore())
{
  const auto error = thrownBy<UnusableInput>([&] { convert(in, transforms); });
  return {error.status(), error.what()};
}

Eigen::Quaterniond turned(double yaw, double roll, double spin)
{
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(spin, Eigen::Vector3d::UnitY());
}
}  // namespace

TEST(ContactInput, StateHasTheValuesOfPoseAndLoad)
{
  const core::WheelsetState state = convert(input(pose()));
  EXPECT_EQ((std::array{state.x, state.y, state.z, state.yaw, state.roll, state.force_z, state.torque_x}),
            (std::array{4.0, 0.002, 0.46, 0.0, 0.0, -2e5, 3.0}));
}

TEST(ContactInput, RotationAboutTheAxleIsThePitchAndNearlyUnitLengthHasNoEffect)
{
  for (const double spin : {0.0, 0.3, 1.5707963267948966, 3.0, -2.0})
  {
    const core::WheelsetState state = convert(input(pose(turned(0.02, -0.005, spin))));
    EXPECT_NEAR(state.yaw, 0.02, 1e-12) << spin;
    EXPECT_NEAR(state.roll, -0.005, 1e-12) << spin;
    EXPECT_NEAR(state.pitch, spin, 1e-12);
  }
  Eigen::Quaterniond q = turned(0.02, 0.01, 0);
  q.coeffs() *= 1.0009;
  EXPECT_NEAR(convert(input(pose(q))).yaw, 0.02, 1e-12);
  q.coeffs() *= 1.0002;
  EXPECT_EQ(refusal(input(pose(q))).first, WheelsetContact::INVALID_INPUT);
}

// As the link of a cylinder, whose z axis is along the axle: its yaw would be rounding noise.
TEST(ContactInput, PoseWhoseYAxisIsNotAlongTheAxleToTheLeftIsRefused)
{
  const double half_turn = std::acos(-1.0);
  EXPECT_EQ(
      refusal(input(pose(turned(0, -half_turn / 2, 0)))),
      Refusal(WheelsetContact::INVALID_INPUT, "pose: its y axis is not along the axle (roll -90 deg), but its z axis"));
  EXPECT_EQ(refusal(input(pose(turned(half_turn / 2, 0, 0)))).second,
            "pose: its y axis is not along the axle (yaw 90 deg), but its x axis");
  for (const double spin : {0.0, half_turn})  // turned round; y to the right and z down
  {
    EXPECT_EQ(refusal(input(pose(turned(half_turn - 1e-3, 0, spin))))
                  .second.find("pose: its y axis points to the right (yaw 179.9 deg): the vehicle is turned round, or"),
              0U);
  }
}

TEST(ContactInput, NonFiniteNumbersAndLoadsInAnotherFrameAreRefusedByName)
{
  auto bad = pose();
  bad.pose.position.y = not_a_number;
  EXPECT_EQ(refusal(input(bad)), Refusal(WheelsetContact::INVALID_INPUT, "pose: position is not finite"));
  bad = pose();
  bad.pose.position.x = infinity;
  EXPECT_EQ(refusal(input(bad)).first, WheelsetContact::INVALID_INPUT);
  for (const double w : {0.0, 5e-324, not_a_number, infinity, 1e308})
  {
    bad = pose();
    bad.pose.orientation.w = w;
    EXPECT_EQ(refusal(input(bad)).first, WheelsetContact::INVALID_INPUT) << w;
    EXPECT_TRUE(contains(refusal(input(bad)).second, "quaternion"));
  }
  EXPECT_EQ(refusal(input(pose(), wrench(0, not_a_number, 0))).second, "load: force is not finite");
  EXPECT_EQ(refusal(input(pose(), wrench(0, -1e5, -infinity))).second, "load: torque is not finite");
  auto load = wrench(0, -2e5, 0);
  load.header.frame_id = "track";
  EXPECT_EQ(convert(input(pose(), load)).force_z, -2e5);
  load.header.frame_id = "wheelset";
  EXPECT_EQ(refusal(input(pose(), load)).first, WheelsetContact::INVALID_INPUT);
  EXPECT_TRUE(contains(refusal(input(pose(), load)).second, "'wheelset'"));
}

TEST(ContactInput, PoseIsTransformedToTheTrackFrameIfItsFrameIsKnown)
{
  tf2::BufferCore transforms;
  transforms.setTransform(vehicle(0.01), "test");
  auto message = pose(turned(0, 0, 0), "vehicle");
  const core::WheelsetState state = convert(input(message), transforms);
  EXPECT_NEAR(state.yaw, 0.01, 1e-12);
  EXPECT_NEAR(state.y, 0.01 + 4 * std::sin(0.01) + 0.002 * std::cos(0.01), 1e-12);
  EXPECT_NEAR(state.distance, 4 * std::cos(0.01) - 0.002 * std::sin(0.01), 1e-12);

  message.header.stamp = ros::Time(11);
  const Refusal late = refusal(input(message), transforms);
  EXPECT_EQ(late.first, WheelsetContact::NO_TRANSFORM);
  EXPECT_TRUE(contains(late.second, "'track'"));
  for (const std::string& frame :
       {std::string("nowhere"), std::string(), std::string("/track"), std::string(100000, 'x')})
  {
    EXPECT_EQ(refusal(input(pose(turned(0, 0, 0), frame))).first, WheelsetContact::NO_TRANSFORM) << frame.substr(0, 20);
  }
}

// The track frame moves on an arc, with a transform every 50 ms. tf interpolates on its chords.
TEST(ContactInput, ErrorOfTheInterpolationOnACurveIsEstimated)
{
  constexpr double radius = 300, speed = 80, period = 0.05;
  TransformStore transforms;
  const auto on_arc = [&](double time, double outward)
  {
    const double angle = speed * time / radius;
    return Eigen::Vector2d((radius - outward) * std::sin(angle), radius - (radius - outward) * std::cos(angle));
  };
  const auto pose_at = [&](double time)
  {
    geometry_msgs::PoseStamped message = pose(turned(speed * time / radius, 0, 0), "map");
    message.header.stamp = ros::Time(10 + time);
    message.pose.position.x = on_arc(time, 2e-3).x();
    message.pose.position.y = on_arc(time, 2e-3).y();
    return message;
  };
  NodeConfig config;
  const NeighbourForces neighbours(config);
  InputPreparation preparation(config, transforms, neighbours);
  for (int i = 0; i < 10; ++i)
  {
    const double angle = speed * period * i / radius;
    geometry_msgs::TransformStamped transform = vehicle(angle);
    transform.header.frame_id = "map";
    transform.child_frame_id = "track";
    transform.header.stamp = ros::Time(10 + period * i);
    transform.transform.translation.x = on_arc(period * i, 0).x();
    transform.transform.translation.y = on_arc(period * i, 0).y();
    transforms.add(transform, false);
  }
  for (const double time : {0.26, 0.275, 0.299})
  {
    const PreparedInput prepared = preparation.prepare(input(pose_at(time)));
    const double error = std::abs(prepared.state.y - 2e-3);
    const auto& point = pose_at(time).pose.position;
    // Within 1 %: the arc is not a parabola.
    EXPECT_NEAR(transforms.interpolationError("track", "map", prepared.stamp, point), error, 0.01 * error) << time;
    EXPECT_EQ(prepared.reason.empty(), error < 1e-4) << prepared.reason;
  }
  EXPECT_EQ(preparation.prepare(input(pose_at(0.3))).reason, "") << "at the stamp of a transform";
  EXPECT_EQ(preparation.prepare(input(pose_at(0.275))).reason,
            "tf is slower than the poses: its interpolation is estimated to be 6.7 mm off");
}

TEST(ContactInput, RailForcesAreOutwardOnBothSides)
{
  ContactInput in = input(pose());
  in.rail_force = {shared(wrench(30e3, 0, 0)), shared(wrench(-5e3, 0, 0))};
  const core::WheelsetState state = convert(in);
  EXPECT_EQ(state.rail_lateral_force.left, 30e3);
  EXPECT_EQ(state.rail_lateral_force.right, -5e3);
  in.rail_force.right = shared(wrench(not_a_number, 0, 0));
  EXPECT_EQ(refusal(in).second, "right rail force: force is not finite");
}

TEST(ContactInput, DisplacementsOfTheRailsAreInTheAxesOfTheirSides)
{
  ContactInput in = input(pose());
  EXPECT_EQ(convert(in).rail_displacement.left.lateral, 0);
  auto message = displacements();
  message.header.frame_id = "anywhere";
  in.rail_displacement = shared(message);
  const core::WheelsetState state = convert(in);
  using Values = std::array<double, 3>;
  const auto values = [](const auto& of_rail) { return Values{of_rail.lateral, of_rail.vertical, of_rail.roll}; };
  EXPECT_EQ(values(state.rail_displacement.left), (Values{1e-3, -2e-3, 3e-3}));
  EXPECT_EQ(values(state.rail_displacement.right), (Values{-4e-3, 5e-3, -6e-3}));
  EXPECT_EQ(values(state.rail_velocity.left), (Values{0.01, -0.02, 0.03}));
  EXPECT_EQ(values(state.rail_velocity.right), (Values{0, 0, -0.04}));
}

TEST(ContactInput, NonFiniteDisplacementOrVelocityIsRefusedWithItsRail)
{
  const std::pair<double RailDisplacement::*, std::string> components[] = {
      {&RailDisplacement::lateral, "displacement"},       {&RailDisplacement::vertical, "displacement"},
      {&RailDisplacement::roll, "displacement"},          {&RailDisplacement::lateral_velocity, "velocity"},
      {&RailDisplacement::vertical_velocity, "velocity"}, {&RailDisplacement::roll_rate, "velocity"}};
  for (const auto& [component, name] : components)
  {
    for (const double bad : {not_a_number, infinity, -infinity})
    {
      for (const auto rail : {&RailDisplacements::left, &RailDisplacements::right})
      {
        ContactInput in = input(pose());
        auto message = displacements();
        message.*rail.*component = bad;
        in.rail_displacement = shared(message);
        const std::string side = rail == &RailDisplacements::left ? "left" : "right";
        EXPECT_EQ(refusal(in), Refusal(WheelsetContact::INVALID_INPUT, side + " rail " + name + " is not finite"));
      }
    }
  }
}

TEST(ContactInput, DistanceIsThatOfTheMessageOrElseXInTheTrackFrame)
{
  ContactInput in = input(pose());
  EXPECT_EQ(convert(in).distance, 4);
  geometry_msgs::PointStamped place;
  place.point.x = 1234.5;
  in.distance = shared(place);
  EXPECT_EQ(convert(in).distance, 1234.5);
  EXPECT_EQ(convert(in).x, 4);
  place.point.x = not_a_number;
  in.distance = shared(place);
  EXPECT_EQ(refusal(in), Refusal(WheelsetContact::INVALID_INPUT, "distance: point.x is not finite"));
}

TEST(ContactInput, TwistIsInTheTrackFrameOrTurnedFromThatOfThePose)
{
  tf2::BufferCore transforms;
  const double yaw = 0.01, c = std::cos(yaw), s = std::sin(yaw);
  transforms.setTransform(vehicle(yaw), "test");
  ContactInput in = input(pose());
  in.twist = twist("track");
  expectMotion(convert(in).motion, {20, 0.02, -0.03}, {0.04, 43, -0.05});
  in.pose = shared(pose(turned(0, 0, 0), "vehicle"));
  expectMotion(convert(in, transforms).motion, {20, 0.02, -0.03}, {0.04, 43, -0.05});
  in.twist = twist("vehicle");
  expectMotion(convert(in, transforms).motion, {20 * c - 0.02 * s, 20 * s + 0.02 * c, -0.03},
               {0.04 * c - 43 * s, 0.04 * s + 43 * c, -0.05});
}

TEST(ContactInput, PoseInAFixedFrameIsThatInTheFrameOfItsCrossSection)
{
  const core::TrackDesign design{1 / 300.0, -0.06, 0.01};
  const std::vector<core::LineStation> stations{{0, 0, {}, {}}, {80, 0, {}, design}, {500, 0, {}, design}};
  const core::TrackPath path(std::make_shared<core::TrackLine>("curve", stations));
  const double yaw = 2e-3, place = 321.5;
  const Eigen::Isometry3d frame = path.frameAt(place), at = frame * Eigen::Translation3d(0, 2e-3, 0.46);
  geometry_msgs::PoseStamped message =
      pose(Eigen::Quaterniond(frame.linear() * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), "map");
  message.pose.position.x = at.translation().x();
  message.pose.position.y = at.translation().y();
  message.pose.position.z = at.translation().z();
  ContactInput in = input(message);
  geometry_msgs::TwistStamped velocity = *twist("map");
  velocity.twist.linear = vectorMessage(20 * frame.linear().col(0));
  in.twist = shared(velocity);
  const core::WheelsetState state = toState(in, "track", tf2::BufferCore(), "map", &path);
  EXPECT_EQ(state.distance, state.x);
  const double values[] = {state.x - place, state.y - 2e-3, state.z - 0.46, state.yaw - yaw, state.motion.speed - 20};
  for (const double value : values)
  {
    EXPECT_NEAR(value, 0, 1e-8);
  }
  EXPECT_TRUE(state.motion_over_ground);
}

TEST(ContactInput, TwistInAnotherFrameOrNotFiniteIsRefused)
{
  ContactInput in = input(pose());
  for (const std::string frame : {"", "vehicle"})
  {
    in.twist = twist(frame);
    EXPECT_EQ(refusal(in), Refusal(WheelsetContact::INVALID_INPUT,
                                   "twist: frame_id is '" + frame + "', but must be 'track' (track/frame)"));
  }
  tf2::BufferCore transforms;
  transforms.setTransform(vehicle(0), "test");
  in.pose = shared(pose(turned(0, 0, 0), "vehicle"));
  in.twist = twist("body");
  EXPECT_EQ(refusal(in, transforms).second,
            "twist: frame_id is 'body', but must be 'track' (track/frame) or 'vehicle', the frame of the pose");
  for (const double bad : {not_a_number, infinity})
  {
    geometry_msgs::TwistStamped message = *twist("track");
    message.twist.linear.z = bad;  // NaN would mean in the core that the wheel follows the rail
    in.twist = shared(message);
    EXPECT_EQ(refusal(in, transforms), Refusal(WheelsetContact::INVALID_INPUT, "twist: linear is not finite"));
    message = *twist("track");
    message.twist.angular.x = bad;
    in.twist = shared(message);
    EXPECT_EQ(refusal(in, transforms).second, "twist: angular is not finite");
  }
}
