// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <exception>

#include "wheel_rail_contact/ros/contact_server.h"

int main(int argc, char** argv)
{
  try
  {
    ros::init(argc, argv, "contact_node");
    const wheel_rail_contact::ContactServer server{ros::NodeHandle(), ros::NodeHandle("~")};
    ros::spin();
    return 0;
  }
  catch (const std::exception& error)
  {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
