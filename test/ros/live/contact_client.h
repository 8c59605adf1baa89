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
/// Talks to a running contact node or nodelet as a user's program would.
class ContactClient
{
 public:
  /// @param inputs namespace of wheelset/pose and wheelset/load
  /// @param node full name of the node; empty: nobody listens to answers
  explicit ContactClient(const std::string& inputs = "/", const std::string& node = "/contact_node");

  /// A stamp later than all before, in all clients of this program.
  static ros::Time nextStamp();
  static geometry_msgs::PoseStamped pose(double y, const ros::Time& stamp);
  static geometry_msgs::WrenchStamped load(double fz, const ros::Time& stamp);

  void send(const geometry_msgs::PoseStamped& pose) { pose_publisher_.publish(pose); }
  void send(const geometry_msgs::WrenchStamped& load) { load_publisher_.publish(load); }
  /// Sends a pair. @return its answer, or nothing if none came in time.
  std::optional<WheelsetContact> ask(const geometry_msgs::PoseStamped& pose, const geometry_msgs::WrenchStamped& load);
  /// Sends a good pair with the wheelset at y and 100 kN on each wheel.
  std::optional<WheelsetContact> ask(double y);

  /// Waits until there are at least `count` answers in all. @return false if they did not come in time.
  bool waitForResults(std::size_t count);
  const std::vector<WheelsetContact>& results() const { return results_; }

 private:
  std::vector<WheelsetContact> results_;
  ros::NodeHandle nh_;
  ros::Publisher pose_publisher_, load_publisher_;
  ros::Subscriber subscriber_;
};

/// The next report of a node on /diagnostics: its level and its values by key; empty if none came.
struct Report
{
  int level = -1;
  std::string message;
  std::map<std::string, std::string> values;
};
Report nextReport(const std::string& node);

/// Process id of a node.
int processOf(const std::string& node);

/// Handles callbacks until `done` or the time is up: a node with sanitizers takes its time. @return done()
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
