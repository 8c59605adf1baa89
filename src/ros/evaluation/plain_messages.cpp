// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/plain_messages.h"

#include "core/wheel_wrench.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
void addFrame(const ros::Time& stamp, const std::string& parent, const std::string& child,
              const Eigen::Isometry3d& frame, tf2_msgs::TFMessage& message)
{
  geometry_msgs::TransformStamped& transform = message.transforms.emplace_back();
  transform.header.stamp = stamp;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation = vectorMessage(frame.translation());
  transform.transform.rotation = toMessage(Eigen::Quaterniond(frame.linear()));
}
}  // namespace

std::string wheelsetFrame(const NodeConfig& config, const std::string& topics)
{
  const std::size_t name = topics.find_first_not_of('/');
  return !config.wheelset_frame.empty() ? config.wheelset_frame
         : name == std::string::npos    ? "wheelset"
                                        : topics.substr(name);
}

std::string contactFrame(const std::string& wheelset_frame, core::Side side)
{
  return wheelset_frame + "/" + nameOf(side) + "_contact";
}

tf2_msgs::TFMessage framesOf(const ContactOutput& output, const NodeConfig& config, const std::string& wheelset_frame)
{
  tf2_msgs::TFMessage message;
  const ros::Time& stamp = output.header.stamp;
  const core::WheelsetPose pose = output.pose();
  const Eigen::Translation3d axle(output.x(), pose.y, pose.z);
  if (config.path && !output.rejected && config.model.track.line->contains(output.state.distance))
  {
    addFrame(stamp, config.fixed_frame, config.track_frame,
             config.path->frameAt(output.state.distance) * Eigen::Translation3d(-output.x(), 0, 0), message);
  }
  if (config.publish_tf && hasPose(output))
  {
    using Turn = Eigen::AngleAxisd;
    using Eigen::Vector3d;
    addFrame(stamp, config.track_frame, wheelset_frame,
             axle * Turn(pose.yaw, Vector3d::UnitZ()) * Turn(pose.roll, Vector3d::UnitX()) *
                 Turn(output.state.pitch, Vector3d::UnitY()),
             message);
  }
  if (config.publish_wrenches && output.result)
  {
    for (const core::Side side : core::sides)
    {
      addFrame(
          stamp, config.track_frame, contactFrame(wheelset_frame, side),
          axle * Eigen::Translation3d(core::wheelWrench(*output.result, side).centre) * Eigen::Isometry3d::Identity(),
          message);
    }
  }
  return message;
}

geometry_msgs::WrenchStamped wrenchMessage(const ContactOutput& output, core::Side side,
                                           const std::string& wheelset_frame)
{
  const core::Wrench wrench = core::wheelWrench(*output.result, side).wrench;
  geometry_msgs::WrenchStamped message;
  message.header.stamp = output.header.stamp;
  message.header.frame_id = contactFrame(wheelset_frame, side);
  message.wrench.force = vectorMessage(wrench.force);
  message.wrench.torque = vectorMessage(wrench.moment);
  return message;
}
}  // namespace wheel_rail_contact
