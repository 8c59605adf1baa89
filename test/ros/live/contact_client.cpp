// SPDX-License-Identifier: BSD-3-Clause
#include "contact_client.h"

#include <ros/network.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <stdexcept>

namespace wheel_rail_contact
{
namespace
{
constexpr std::uint32_t queue_size = 0;  // unlimited: the client loses no message
}  // namespace

ContactClient::ContactClient(const std::string& inputs, const std::string& node) : nh_(inputs)
{
  pose_publisher_ = nh_.advertise<geometry_msgs::PoseStamped>("wheelset/pose", queue_size);
  load_publisher_ = nh_.advertise<geometry_msgs::WrenchStamped>("wheelset/load", queue_size);
  const auto connected = [this]
  { return pose_publisher_.getNumSubscribers() > 0 && load_publisher_.getNumSubscribers() > 0; };
  bool ready = spinUntil(connected);
  if (!node.empty())
  {
    subscriber_ = nh_.subscribe<WheelsetContact>(
        node + "/contact", queue_size, [this](const WheelsetContact::ConstPtr& m) { results_.push_back(*m); },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
    ready = ready && spinUntil([this] { return subscriber_.getNumPublishers() > 0; });
  }
  if (!ready)
  {
    throw std::runtime_error("no connection to " + inputs + " and " + node);
  }
  // The node is notified of its new subscriber slightly later than the subscriber is of the node.
  spinUntil([] { return false; }, 0.1);
}

ros::Time ContactClient::nextStamp()
{
  static ros::Time stamp(1000, 0);
  stamp += ros::Duration(0.02);
  return stamp;
}

geometry_msgs::PoseStamped ContactClient::pose(double y, const ros::Time& stamp)
{
  geometry_msgs::PoseStamped message;
  message.header.frame_id = "track";
  message.header.stamp = stamp;
  message.pose.position.y = y;
  message.pose.orientation.w = 1;
  return message;
}

geometry_msgs::WrenchStamped ContactClient::load(double fz, const ros::Time& stamp)
{
  geometry_msgs::WrenchStamped message;
  message.header.frame_id = "track";
  message.header.stamp = stamp;
  message.wrench.force.z = fz;
  return message;
}

std::optional<WheelsetContact> ContactClient::request(const geometry_msgs::PoseStamped& pose,
                                                      const geometry_msgs::WrenchStamped& load)
{
  const std::size_t before = results_.size();
  send(pose);
  send(load);
  return waitForResults(before + 1) ? std::make_optional(results_.back()) : std::nullopt;
}

std::optional<WheelsetContact> ContactClient::request(double y)
{
  const ros::Time stamp = nextStamp();
  return request(pose(y, stamp), load(-200e3, stamp));
}

bool ContactClient::waitForResults(std::size_t count)
{
  return spinUntil([this, count] { return results_.size() >= count; });
}

Report nextReport(const std::string& node, const std::string& task)
{
  Report report;
  ros::NodeHandle nh;
  const auto receive = [&](const diagnostic_msgs::DiagnosticArray::ConstPtr& message)
  {
    for (const auto& status : message->status)
    {
      if ("/" + status.name == node + ": " + task)
      {
        report = {status.level, status.message, {}};
        for (const auto& value : status.values)
        {
          report.values[value.key] = value.value;
        }
      }
    }
  };
  const auto subscriber = nh.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", queue_size, receive);
  spinUntil([&report] { return report.level >= 0; });
  return report;
}

std::uint64_t number(const Report& report, const std::string& key)
{
  const auto value = report.values.find(key);
  return value == report.values.end() ? 0 : std::stoull(value->second);
}

int processOf(const std::string& node)
{
  XmlRpc::XmlRpcValue request, response, uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, uri, false) || !ros::network::splitURI(uri, host, port))
  {
    throw std::runtime_error("no node " + node);
  }
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port));
  client.execute("getPid", request[0], response);
  return response[2];
}
}  // namespace wheel_rail_contact
