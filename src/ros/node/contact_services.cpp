// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/contact_services.h"

#include <algorithm>
#include <boost/make_shared.hpp>
#include <exception>
#include <type_traits>
#include <utility>
#include <vector>

#include "ros/evaluation/conversions.h"

namespace wheel_rail_contact
{
namespace
{
/// The configuration with height and roll solved from the load.
NodeConfig withSolvedHeight(NodeConfig config)
{
  config.model.wheelset.solve_height_and_roll = true;
  return config;
}

/// Input of a request: the messages that the configuration requires (inputTopics()); the others are null.
ContactInput inputOf(const EvaluateWheelset::Request& request, const NodeConfig& config)
{
  ContactInput input;
  const std::vector<InputTopic> topics = inputTopics(config);
  const auto take = [&topics](InputTopic topic, const auto& message, auto& member)
  {
    if (std::find(topics.begin(), topics.end(), topic) != topics.end())
    {
      member = boost::make_shared<std::decay_t<decltype(message)>>(message);
    }
  };
  take(InputTopic::pose, request.pose, input.pose);
  take(InputTopic::load, request.load, input.load);
  take(InputTopic::left_rail_force, request.left_rail_force, input.rail_force.left);
  take(InputTopic::right_rail_force, request.right_rail_force, input.rail_force.right);
  take(InputTopic::rail_displacement, request.rail_displacement, input.rail_displacement);
  take(InputTopic::distance, request.distance, input.distance);
  return input;
}
}  // namespace

ContactServices::ContactServices(const ros::NodeHandle& private_nh, NodeConfig config,
                                 const tf2::BufferCore& transforms, const NeighbourForces& neighbours)
    : config_(std::move(config)),
      static_config_(withSolvedHeight(config_)),
      transforms_(transforms),
      neighbours_(neighbours),
      spinner_(1, &queue_)
{
  ros::NodeHandle own(private_nh);
  own.setCallbackQueue(&queue_);
  evaluate_server_ = own.advertiseService("evaluate", &ContactServices::evaluate, this);
  static_start_server_ = own.advertiseService("static_start", &ContactServices::startStatic, this);
  spinner_.start();
}

ContactServices::~ContactServices()
{
  ended_ = true;
  evaluate_server_.shutdown();
  static_start_server_.shutdown();
  spinner_.stop();
}

ServiceCounts ContactServices::counts() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return counts_;
}

bool ContactServices::evaluate(EvaluateWheelset::Request& request, EvaluateWheelset::Response& response)
{
  try
  {
    if (!evaluate_)
    {
      evaluate_ = std::make_unique<EvaluationChain>(config_, transforms_, neighbours_);
    }
    response.contact = resultOf(request, config_, *evaluate_);
    count(&ServiceCounts::evaluate, response.contact);
  }
  catch (const std::exception& error)
  {
    fail(error);
    return false;
  }
  return true;
}

bool ContactServices::startStatic(EvaluateWheelset::Request& request, EvaluateWheelset::Response& response)
{
  try
  {
    if (!static_start_)
    {
      static_start_ = std::make_unique<EvaluationChain>(static_config_, transforms_, neighbours_);
    }
    static_start_->restart();
    response.contact = resultOf(request, static_config_, *static_start_);
    count(&ServiceCounts::static_start, response.contact);
  }
  catch (const std::exception& error)
  {
    fail(error);
    return false;
  }
  return true;
}

WheelsetContact ContactServices::resultOf(const EvaluateWheelset::Request& request, const NodeConfig& config,
                                          EvaluationChain& chain)
{
  ContactInput input = inputOf(request, config);
  input.arrival = ros::WallTime::now();
  const ContactOutput output = chain.evaluate(input, [this] { return ended_.load(); });
  if (output.lacks_neighbour)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.lacking_neighbour;
  }
  return toMessage(output, true);
}

void ContactServices::count(std::uint64_t ServiceCounts::*requests, const WheelsetContact& result)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++(counts_.*requests);
  counts_.unusable += isUsable(result.status) ? 0U : 1U;
}

void ContactServices::fail(const std::exception& error)
{
  ROS_ERROR_THROTTLE(1.0, "internal error in a service: %s", error.what());
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts_.failed;
}
}  // namespace wheel_rail_contact
