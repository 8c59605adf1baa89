// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "ros/node/vehicle_server.h"

namespace wheel_rail_contact
{
class ContactNodelet : public nodelet::Nodelet
{
 private:
  void onInit() override { server_ = std::make_unique<VehicleServer>(getNodeHandle(), getPrivateNodeHandle()); }

  std::unique_ptr<VehicleServer> server_;
};
}  // namespace wheel_rail_contact

PLUGINLIB_EXPORT_CLASS(wheel_rail_contact::ContactNodelet, nodelet::Nodelet)
