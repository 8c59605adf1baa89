// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/contact_input.h"

#include <Eigen/Geometry>

#include "config/text.h"
#include "core/constants.h"
#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double quaternion_tolerance = 1e-3;
constexpr double largest_tf_error = 1e-4;  ///< estimated error of the interpolation without a warning [m]

[[noreturn]] void refuse(const std::string& reason)
{
  throw UnusableInput(WheelsetContact::INVALID_INPUT, reason);
}

void refuseIf(bool fault, const std::string& reason)
{
  if (fault)
  {
    refuse(reason);
  }
}

void requireFinite(std::initializer_list<double> values, const std::string& name)
{
  refuseIf(!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }),
           name + " is not finite");
}

template <typename Vector>
void requireFinite(const Vector& v, const std::string& name)
{
  requireFinite({v.x, v.y, v.z}, name);
}

void requireFinite(const geometry_msgs::Wrench& wrench, const std::string& name)
{
  requireFinite(wrench.force, name + ": force");
  requireFinite(wrench.torque, name + ": torque");
}

Eigen::Isometry3d toIsometry(const geometry_msgs::Pose& pose)
{
  requireFinite(pose.position, "pose: position");
  const auto& o = pose.orientation;
  const Eigen::Quaterniond q(o.w, o.x, o.y, o.z);
  const double norm = q.norm();
  refuseIf(!(std::abs(norm - 1) <= quaternion_tolerance),
           "pose: the length of the quaternion is " + std::to_string(norm) + ", but must be 1 within 0.001");
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * q.normalized();
}

Eigen::Isometry3d toIsometry(const geometry_msgs::Transform& transform)
{
  const auto& t = transform.translation;
  const auto& r = transform.rotation;
  return Eigen::Translation3d(t.x, t.y, t.z) * Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized();
}

/// A text from outside, cut to a length that is suitable for a reason.
std::string shown(const std::string& text)
{
  constexpr std::size_t room = 200;
  return text.size() <= room ? text : text.substr(0, room) + "...";
}

/// Transform from the frame of a pose to the track frame, or to the fixed one.
Eigen::Isometry3d toTrack(const std_msgs::Header& pose, const std::string& track_frame,
                          const tf2::BufferCore& transforms)
{
  const std::string& frame = pose.frame_id;
  if (frame == track_frame)
  {
    return Eigen::Isometry3d::Identity();
  }
  if (!isFrameName(frame))
  {
    throw UnusableInput(WheelsetContact::NO_TRANSFORM,
                        "pose: frame_id '" + shown(frame) + "' is not a valid tf frame name");
  }
  try
  {
    return toIsometry(transforms.lookupTransform(track_frame, frame, pose.stamp).transform);
  }
  catch (const std::exception& error)  // of tf2, and of ros::Time for a stamp at the end of its range
  {
    throw UnusableInput(WheelsetContact::NO_TRANSFORM,
                        "pose: no transform from frame '" + shown(frame) + "' to '" + track_frame + "' at the stamp " +
                            std::to_string(pose.stamp.toSec()) + ": " + shown(error.what()));
  }
}

/// Refuses axes in the track frame whose y axis is not along the axle, to the left. Their angles would have no meaning.
void requireAxle(const Eigen::Matrix3d& axes, const core::WheelsetPose& pose)
{
  Eigen::Index nearest = 1;
  axes.row(1).cwiseAbs().maxCoeff(&nearest);
  if (nearest == 1 && axes(1, 1) >= 0)
  {
    return;
  }
  const double roll = pose.roll / core::degree, yaw = pose.yaw / core::degree;
  refuse(nearest == 2   ? formatted("pose: its y axis is not along the axle (roll %.4g deg), but its z axis", roll)
         : nearest == 0 ? formatted("pose: its y axis is not along the axle (yaw %.4g deg), but its x axis", yaw)
                        : formatted("pose: its y axis points to the right (yaw %.4g deg): the vehicle is turned round, "
                                    "or y and z are those of railways. Turn the pose by 180 deg about z; its left "
                                    "wheel is then that on the left rail of track/frame",
                                    yaw));
}

void setLoad(const geometry_msgs::WrenchStamped& load, const std::string& track_frame, core::WheelsetState& state)
{
  const std::string& frame = load.header.frame_id;
  refuseIf(!frame.empty() && frame != track_frame,
           "load: frame_id is '" + shown(frame) + "', but must be '" + track_frame + "' or empty (track axes)");
  requireFinite(load.wrench, "load");
  state.force_z = load.wrench.force.z;
  state.torque_x = load.wrench.torque.x;
}

std::string railName(core::Side side)
{
  return std::string(nameOf(side)) + " rail";
}

void setRailForces(const ContactInput& input, core::WheelsetState& state)
{
  for (const core::Side side : core::sides)
  {
    if (const auto& force = input.rail_force[side])
    {
      requireFinite(force->wrench, railName(side) + " force");
      state.rail_lateral_force[side] = force->wrench.force.y;
    }
  }
}

void setRail(const RailDisplacement& rail, core::Side side, core::WheelsetState& state)
{
  requireFinite({rail.lateral, rail.vertical, rail.roll}, railName(side) + " displacement");
  requireFinite({rail.lateral_velocity, rail.vertical_velocity, rail.roll_rate}, railName(side) + " velocity");
  state.rail_displacement[side] = {rail.lateral, rail.vertical, rail.roll};
  state.rail_velocity[side] = {rail.lateral_velocity, rail.vertical_velocity, rail.roll_rate};
}

/// @param to_track rotation from the frame of the pose to the track frame
void setMotion(const geometry_msgs::TwistStamped& message, const std::string& pose_frame,
               const std::string& track_frame, const Eigen::Matrix3d& to_track, core::WheelsetState& state)
{
  const std::string& frame = message.header.frame_id;
  refuseIf(frame != track_frame && frame != pose_frame,
           "twist: frame_id is '" + shown(frame) + "', but must be '" + track_frame + "' (track/frame)" +
               (pose_frame == track_frame ? "" : " or '" + shown(pose_frame) + "', the frame of the pose"));
  const auto &linear = message.twist.linear, &angular = message.twist.angular;
  requireFinite(linear, "twist: linear");
  requireFinite(angular, "twist: angular");
  Eigen::Vector3d velocity(linear.x, linear.y, linear.z), rotation(angular.x, angular.y, angular.z);
  state.motion_over_ground = frame != track_frame;
  if (state.motion_over_ground)
  {
    velocity = to_track * velocity;
    rotation = to_track * rotation;
  }
  core::WheelsetMotion& motion = state.motion;
  motion.speed = velocity.x();
  motion.lateral_velocity = velocity.y();
  motion.vertical_velocity = velocity.z();
  motion.roll_rate = rotation.x();
  motion.rotation = rotation.y();
  motion.yaw_rate = rotation.z();
}
}  // namespace

bool isFrameName(const std::string& name)
{
  return !name.empty() && name[0] != '/';
}

core::WheelsetState toState(const ContactInput& input, const std::string& track_frame,
                            const tf2::BufferCore& transforms, const std::string& fixed_frame,
                            const core::TrackPath* path)
{
  refuseIf(!input.fault.empty(), input.fault);
  core::WheelsetState state;
  const Eigen::Isometry3d own = toIsometry(input.pose->pose);
  const bool is_fixed = path != nullptr && input.pose->header.frame_id != track_frame;
  Eigen::Isometry3d to_track = toTrack(input.pose->header, is_fixed ? fixed_frame : track_frame, transforms);
  const double place = is_fixed ? path->placeOf(to_track * own.translation()) : 0;
  if (is_fixed)
  {
    to_track = path->frameAt(place).inverse() * to_track;
  }
  const Eigen::Isometry3d pose = to_track * own;
  const core::WheelsetPose wheelset = toWheelsetPose(pose);
  requireAxle(pose.linear(), wheelset);
  state.x = state.distance = place + pose.translation().x();
  state.y = wheelset.y;
  state.z = wheelset.z;
  state.yaw = wheelset.yaw;
  state.roll = wheelset.roll;
  state.pitch = pitchOf(pose, wheelset);
  if (input.load)
  {
    setLoad(*input.load, track_frame, state);
  }
  setRailForces(input, state);
  if (input.rail_displacement)
  {
    setRail(input.rail_displacement->left, core::Side::left, state);
    setRail(input.rail_displacement->right, core::Side::right, state);
  }
  if (input.distance && !is_fixed)
  {
    state.distance = input.distance->point.x;
    requireFinite({state.distance}, "distance: point.x");
  }
  if (input.twist)
  {
    setMotion(*input.twist, input.pose->header.frame_id, track_frame, to_track.linear(), state);
  }
  return state;
}

bool InputPreparation::isReady(const ContactInput& input) const
{
  const std_msgs::Header& header = input.pose->header;
  try
  {
    return header.frame_id == track_frame_ || header.frame_id == tfFrame() || !isFrameName(header.frame_id) ||
           transforms_.canTransform(tfFrame(), header.frame_id, header.stamp);
  }
  catch (const std::exception&)
  {
    return true;  // toState() gives the reason
  }
}

PreparedInput InputPreparation::prepare(const ContactInput& input)
{
  PreparedInput prepared;
  prepared.stamp = input.pose->header.stamp;
  prepared.resets = reset_rule_.resets(prepared.stamp);
  try
  {
    prepared.state = toState(input, track_frame_, transforms_, fixed_frame_, path_.get());
    const std::string& frame = input.pose->header.frame_id;
    const double error = frame == track_frame_ ? 0
                                               : transforms_.interpolationError(tfFrame(), frame, prepared.stamp,
                                                                                input.pose->pose.position);
    if (error > largest_tf_error)
    {
      prepared.reason =
          formatted("tf is slower than the poses: its interpolation is estimated to be %.2g mm off", 1e3 * error);
    }
  }
  catch (const UnusableInput& error)
  {
    prepared.status = error.status();
    prepared.reason = error.what();
  }
  const NeighbourEffect effect = neighbours_.effectAt(prepared.stamp);
  for (const core::Side side : core::sides)
  {
    prepared.state.rail_displacement[side] += effect.deflection[side];
  }
  prepared.lacks_neighbour = !effect.complete;
  return prepared;
}
}  // namespace wheel_rail_contact
