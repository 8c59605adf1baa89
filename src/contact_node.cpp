// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <exception>
#include <iostream>

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
    std::cerr << "contact_node: " << error.what() << '\n';  // the ROS log is gone with the last node handle
    return 1;
  }
}
