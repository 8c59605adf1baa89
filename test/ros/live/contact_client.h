// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <wheel_rail_contact/WheelsetContact.h>

namespace wheel_rail_contact
{
/// Client of a running contact node or nodelet, as in a program of a user.
class ContactClient
{
 public:
  /// Waits until it is connected to the node.
  /// @param inputs namespace of wheelset/pose and wheelset/load
  /// @param node full name of the node; empty: do not subscribe to its results
  /// @throw std::runtime_error if there is no connection within a minute.
  explicit ContactClient(const std::string& inputs = "/", const std::string& node = "/contact_node");

  /// A stamp later than all previous ones, for all clients of this program.
  static ros::Time nextStamp();
  /// Pose of a wheelset at y [m] in the track frame, with z, yaw and roll 0.
  static geometry_msgs::PoseStamped pose(double y, const ros::Time& stamp);
  /// Load with a vertical force [N] only.
  static geometry_msgs::WrenchStamped load(double fz, const ros::Time& stamp);

  void send(const geometry_msgs::PoseStamped& pose) { pose_publisher_.publish(pose); }
  void send(const geometry_msgs::WrenchStamped& load) { load_publisher_.publish(load); }
  /// Sends a pair and waits for the next result. @return it, or nothing after a timeout.
  std::optional<WheelsetContact> request(const geometry_msgs::PoseStamped& pose,
                                         const geometry_msgs::WrenchStamped& load);
  /// Same for a valid pair: the wheelset at y [m], with 100 kN on each wheel.
  std::optional<WheelsetContact> request(double y);

  /// Waits until at least `count` results have been received in total. @return false after a timeout.
  bool waitForResults(std::size_t count);
  /// All results received so far.
  const std::vector<WheelsetContact>& results() const { return results_; }

 private:
  std::vector<WheelsetContact> results_;
  ros::NodeHandle nh_;
  ros::Publisher pose_publisher_, load_publisher_;
  ros::Subscriber subscriber_;
};

/// Report of a node on /diagnostics.
struct Report
{
  int level = -1;                             ///< of DiagnosticStatus; -1: no report
  std::string message;                        ///< summary
  std::map<std::string, std::string> values;  ///< by key
};
/// Waits for the next report of a node on a task; empty after a timeout.
Report nextReport(const std::string& node, const std::string& task = "wheel-rail contact");
/// Value of a key of a report; 0 if the report does not have it.
std::uint64_t number(const Report& report, const std::string& key);

/// Process id of a node.
/// @throw std::runtime_error if there is no such node.
int processOf(const std::string& node);

/// Handles callbacks until `done` or the timeout [s], which is generous because nodes with sanitizers are slow.
/// @return done()
template <typename Condition>
bool spinUntil(const Condition& done, double seconds = 60)
{
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!done() && ros::ok() && ros::WallTime::now() < end)
  {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.005));
  }
  return done();
}
}  // namespace wheel_rail_contact
