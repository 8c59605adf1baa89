// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/plain_messages.h"

#include "../usual_headers.h"
#include "core/wheel_wrench.h"
#include "result_scene.h"
#include "ros/evaluation/conversions.h"

using namespace wheel_rail_contact;

namespace
{
/// A yawed, rolling wheelset; its right wheel has two patches, on tread and gauge corner.
class PlainMessages : public testing::Test
{
 protected:
  PlainMessages()
  {
    config.model.creep.method = core::CreepMethod::linear;
    PreparedInput input;
    input.stamp = ros::Time(10);
    input.state.x = input.state.distance = 3;
    input.state.y = -4.6e-3;
    input.state.yaw = 5e-3;
    input.state.pitch = 0.3;
    input.state.force_z = -200e3;
    input.state.motion.speed = 20;
    output = ContactEvaluator(config).evaluate(input);
  }

  std::vector<std::string> frames() const
  {
    std::vector<std::string> names;
    for (const auto& transform : framesOf(output, config, "axle").transforms)
    {
      EXPECT_EQ(transform.header.frame_id, "track");
      EXPECT_EQ(transform.header.stamp, output.header.stamp);
      names.push_back(transform.child_frame_id);
    }
    return names;
  }

  NodeConfig config = exampleConfig();
  ContactOutput output;
};

Eigen::Vector3d vectorOf(const geometry_msgs::Vector3& v)
{
  return {v.x, v.y, v.z};
}
}  // namespace

// The core adds up the moment about x column by column, where the normals differ: a few newton metres of 1e5.
TEST_F(PlainMessages, WrenchesOfBothWheelsAtTheirFramesAreTogetherThatOfTheRails)
{
  ASSERT_EQ(output.status, WheelsetContact::OK) << output.reason;
  ASSERT_EQ(output.result->patches.size(), 3U);
  config.publish_wrenches = true;
  const auto transforms = framesOf(output, config, "axle").transforms;
  EXPECT_EQ(frames(), (std::vector<std::string>{"axle/left_contact", "axle/right_contact"}));
  const Eigen::Vector3d axle(output.x(), output.pose().y, output.pose().z);
  core::Wrench sum;
  for (const core::Side side : core::sides)
  {
    const auto& frame = transforms[side == core::Side::left ? 0 : 1].transform;
    const auto message = wrenchMessage(output, side, "axle");
    EXPECT_EQ(message.header.frame_id, contactFrame("axle", side));
    EXPECT_EQ(message.header.stamp, output.header.stamp);
    EXPECT_EQ(frame.rotation.w, 1) << "the axes of the track";
    const Eigen::Vector3d force = vectorOf(message.wrench.force);
    EXPECT_NEAR(force.z(), output.result->wheel[side].vertical, 1e-6);
    sum += {force, (vectorOf(frame.translation) - axle).cross(force) + vectorOf(message.wrench.torque)};
  }
  const core::Wrench& rails = output.result->rail_wrench;
  EXPECT_LT((sum.force - rails.force).norm(), 1e-6);
  EXPECT_LT((sum.moment - rails.moment).norm(), 10) << sum.moment.transpose() << " and " << rails.moment.transpose();
  const core::WheelWrench left = core::wheelWrench(*output.result, core::Side::left);
  const core::PatchResult& patch = output.result->patches.front();
  const Eigen::Vector3d spin = patch.creep.force.moment * patch.pose.rotation().toRotationMatrix().col(2);
  EXPECT_LT((left.wrench.moment - spin).norm(), 1e-6) << "one patch: its spin moment alone";
}

TEST_F(PlainMessages, FrameOfTheWheelsetHasTheSolvedPoseAndTheGivenPitch)
{
  config.publish_tf = true;
  EXPECT_EQ(frames(), std::vector<std::string>{"axle"});
  const auto frame = framesOf(output, config, "axle").transforms.at(0).transform;
  EXPECT_EQ(frame.translation.x, 3);
  EXPECT_EQ(frame.translation.y, -4.6e-3);
  EXPECT_EQ(frame.translation.z, output.result->z);
  const auto& q = frame.rotation;
  const Eigen::Isometry3d pose(Eigen::Quaterniond(q.w, q.x, q.y, q.z));
  const core::WheelsetPose found = toWheelsetPose(pose);
  EXPECT_NEAR(found.roll, output.result->roll, 1e-12);
  EXPECT_NEAR(found.yaw, 5e-3, 1e-12);
  EXPECT_NEAR(pitchOf(pose, found), 0.3, 1e-12);
  output.rejected = true;
  EXPECT_TRUE(frames().empty()) << "no pose";
}

TEST_F(PlainMessages, ByDefaultThereIsNoFrameAndItsNameIsThatOfTheTopics)
{
  EXPECT_TRUE(frames().empty());
  EXPECT_EQ(wheelsetFrame(config, "/"), "wheelset");
  EXPECT_EQ(wheelsetFrame(config, "/train/front"), "train/front");
  config.wheelset_frame = "axle";
  EXPECT_EQ(wheelsetFrame(config, "/front"), "axle");
}

TEST_F(PlainMessages, WheelWithoutLoadHasNoForceAndItsFrameIsThatOfTheAxle)
{
  core::WheelsetResult lifted = *output.result;
  lifted.patches.resize(1);
  const core::WheelWrench right = core::wheelWrench(lifted, core::Side::right);
  EXPECT_EQ(right.centre, Eigen::Vector3d::Zero());
  EXPECT_EQ(right.wrench.force, Eigen::Vector3d::Zero());
}
