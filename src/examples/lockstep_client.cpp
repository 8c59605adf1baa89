// SPDX-License-Identifier: BSD-3-Clause
// A C++ client of the contact node in lockstep: sends a state, and waits for its result (doc/co_simulation.md).
// The node runs with config/simulate_contact.yaml, or any other parameters for a load.
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <wheel_rail_contact/WheelsetContact.h>

#include <cstdio>
#include <cstdlib>

namespace
{
using wheel_rail_contact::WheelsetContact;

constexpr double speed = 20;        ///< along the track [m/s]; used with creep/method
constexpr double force_z = -200e3;  ///< of vehicle and weight on the axle centre, up positive [N]

class LockstepClient
{
 public:
  LockstepClient()
  {
    nh_.setCallbackQueue(&queue_);  // results are received in evaluate() only
    pose_ = nh_.advertise<geometry_msgs::PoseStamped>("wheelset/pose", 1);
    twist_ = nh_.advertise<geometry_msgs::TwistStamped>("wheelset/twist", 1);
    load_ = nh_.advertise<geometry_msgs::WrenchStamped>("wheelset/load", 1);
    // Without tcpNoDelay() a result may wait for up to 40 ms in the socket.
    result_ = nh_.subscribe<WheelsetContact>(
        "contact_node/contact", 1, [this](const WheelsetContact::ConstPtr& result) { latest_ = result; },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }

  /// Sends a lateral displacement y [m], and waits for at most `wait` [s]. @return null without a result
  WheelsetContact::ConstPtr evaluate(const ros::Time& time, double y, double wait)
  {
    geometry_msgs::PoseStamped pose;
    geometry_msgs::TwistStamped twist;
    geometry_msgs::WrenchStamped load;
    pose.header.stamp = time;
    pose.header.frame_id = "track";
    twist.header = load.header = pose.header;
    pose.pose.position.y = y;
    pose.pose.orientation.w = 1;
    twist.twist.linear.x = speed;
    load.wrench.force.z = force_z;
    pose_.publish(pose);
    twist_.publish(twist);
    load_.publish(load);
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(wait);
    while (ros::ok() && ros::WallTime::now() < end && !(latest_ && latest_->header.stamp == time))
    {
      queue_.callAvailable(ros::WallDuration(0.01));
    }
    return latest_ && latest_->header.stamp == time ? latest_ : nullptr;
  }

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  ros::Publisher pose_, twist_, load_;
  ros::Subscriber result_;
  WheelsetContact::ConstPtr latest_;
};
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "lockstep_client");
  LockstepClient client;
  ros::Time time(1000);  // simulated; it need not follow a clock, but must not be 0
  std::fprintf(stderr, "waiting for contact_node, for a minute\n");
  int attempts = 600;
  while (ros::ok() && --attempts > 0 && !client.evaluate(time, 0, 0.1))
  {
    time += ros::Duration(1);  // messages are lost until all connections exist: again
  }
  std::puts("y [m], Q left, Q right, Y left, Y right [N], rail_wrench: force x, y [N], moment z [N m]");
  for (const double y : {0.0, 0.001, 0.002, 0.003, 0.004})
  {
    time += ros::Duration(0.001);
    const auto result = client.evaluate(time, y, 10);
    if (!result || result->status > WheelsetContact::LIFT_OFF)  // OK and LIFT_OFF are usable
    {
      std::fprintf(stderr, "y = %g m: %s\n", y, result ? result->status_text.c_str() : "no result");
      return EXIT_FAILURE;
    }
    const auto &left = result->left_wheel, &right = result->right_wheel;
    const geometry_msgs::Wrench& rails = result->rail_wrench;
    std::printf("%g %.1f %.1f %.1f %.1f %.1f %.1f %.1f\n", y, left.vertical_force, right.vertical_force,
                left.lateral_force, right.lateral_force, rails.force.x, rails.force.y, rails.torque.z);
  }
  return EXIT_SUCCESS;
}
