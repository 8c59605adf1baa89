// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/vehicle_server.h"

#include <ros/param.h>

#include <chrono>
#include <set>

#include "core/text/words.h"
#include "ros/parameters/vehicle_parameters.h"

namespace wheel_rail_contact
{
constexpr std::chrono::milliseconds end_poll(20);  ///< between two questions whether ROS has shut down

VehicleServer::VehicleServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
{
  const std::string& full_name = private_nh.getNamespace();
  const std::string own_name = full_name.substr(full_name.rfind('/'));
  XmlRpc::XmlRpcValue values;
  ros::param::get(full_name, values);
  const auto parameters = wheelsetParameters(values, full_name + "/",
                                             [&](const std::string& wheelset)
                                             { return nh.resolveName(wheelset + own_name + "/contact", false); });
  for (const WheelsetParameters& wheelset : parameters)
  {
    const ros::NodeHandle own(nh, wheelset.name), own_private(own, own_name.substr(1));
    ros::param::set(own_private.getNamespace(), wheelset.values);
    wheelsets_[wheelset.name] = std::make_unique<ContactServer>(own, own_private);
  }
  if (parameters.empty())
  {
    wheelsets_[""] = std::make_unique<ContactServer>(nh, private_nh);
    return;
  }
  ros::NodeHandle of_all(private_nh);
  of_all.setCallbackQueue(&queue_);
  service_ = of_all.advertiseService("evaluate_all", &VehicleServer::evaluateAll, this);
  spinner_ = std::make_unique<ros::AsyncSpinner>(1, &queue_);
  spinner_->start();
}

VehicleServer::~VehicleServer()
{
  service_.shutdown();
  spinner_.reset();  // after the current request, which needs the wheelsets
}

bool VehicleServer::evaluateAll(EvaluateWheelsets::Request& request, EvaluateWheelsets::Response& response)
{
  std::vector<std::future<WheelsetContact>> results;
  for (const WheelsetInput& input : request.inputs)
  {
    const auto wheelset = wheelsets_.find(input.wheelset);
    results.push_back(wheelset == wheelsets_.end() ? std::async(std::launch::deferred, [&] { return unknown(input); })
                                                   : wheelset->second->services().evaluate(input));
  }
  for (std::future<WheelsetContact>& result : results)
  {
    while (result.wait_for(end_poll) == std::future_status::timeout)
    {
      if (!ros::ok())
      {
        return false;  // the threads of the services have ended
      }
    }
    response.contacts.push_back(result.get());
  }
  return true;
}

WheelsetContact VehicleServer::unknown(const WheelsetInput& input) const
{
  std::set<std::string> names;
  for (const auto& wheelset : wheelsets_)
  {
    names.insert(wheelset.first);
  }
  WheelsetContact result;
  result.header.stamp = input.pose.header.stamp;
  result.status = WheelsetContact::INVALID_INPUT;
  result.status_text = "no wheelset '" + input.wheelset + "'; the names in wheelsets are " + core::joined(names, ", ");
  return result;
}
}  // namespace wheel_rail_contact
