// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <future>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>

#include "ros/node/vehicle_server.h"

namespace
{
using wheel_rail_contact::VehicleServer;

constexpr std::chrono::milliseconds end_timeout(500);  ///< for the current evaluation when the node ends

/// Ends the server. If the current evaluation exceeds the timeout, ends the process instead: its result would not be
/// published.
void end(std::unique_ptr<VehicleServer> server)
{
  std::promise<void> ended;
  std::thread guard(
      [&ended]
      {
        if (ended.get_future().wait_for(end_timeout) == std::future_status::timeout)
        {
          std::_Exit(EXIT_SUCCESS);
        }
      });
  server.reset();
  ended.set_value();
  guard.join();
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    ros::init(argc, argv, "contact_node");
    std::signal(SIGTERM, [](int) { ros::requestShutdown(); });  // as roscpp does at SIGINT
    auto server = std::make_unique<VehicleServer>(ros::NodeHandle(), ros::NodeHandle("~"));
    ros::spin();
    end(std::move(server));
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "contact_node: " << error.what() << '\n';  // the ROS log has ended with the last node handle
    return EXIT_FAILURE;
  }
}
