// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/contact_services.h"

#include <boost/make_shared.hpp>
#include <exception>
#include <utility>

#include "ros/evaluation/conversions.h"
#include "ros/evaluation/service_input.h"
#include "ros/node/transform_wait.h"

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
}  // namespace

ContactServices::Chain::Chain(NodeConfig node_config)
    : config(std::move(node_config)), preparation(config), evaluator(config), hold(config)
{
}

ContactServices::ContactServices(const ros::NodeHandle& private_nh, NodeConfig config,
                                 const tf2::BufferCore& transforms, Neighbours neighbours)
    : config_(std::move(config)), transforms_(transforms), neighbours_(std::move(neighbours)), spinner_(1, &queue_)
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
      evaluate_ = std::make_unique<Chain>(config_);
    }
    const auto result = boost::make_shared<WheelsetContact>(resultOf(request, *evaluate_));
    evaluate_->hold.apply(result);
    response.contact = *result;
    count(&ServiceCounts::evaluate, *result);
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
      static_start_ = std::make_unique<Chain>(withSolvedHeight(config_));
    }
    static_start_->preparation = InputPreparation(static_start_->config);  // each request starts cold
    response.contact = resultOf(request, *static_start_);
    count(&ServiceCounts::static_start, response.contact);
  }
  catch (const std::exception& error)
  {
    fail(error);
    return false;
  }
  return true;
}

WheelsetContact ContactServices::resultOf(const EvaluateWheelset::Request& request, Chain& chain)
{
  ContactInput input = inputOf(request, chain.config);
  input.arrival = ros::WallTime::now();
  waitForTransform(chain.preparation, input, transforms_, [this] { return ended_.load(); });
  const ros::WallTime start = ros::WallTime::now();
  PreparedInput prepared = chain.preparation.prepare(input, transforms_);
  apply(neighbours_(prepared.stamp), prepared);
  const ContactOutput output = chain.evaluator.evaluate(prepared);
  if (output.lacks_neighbour)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.lacking_neighbour;
  }
  return toMessage(output, true, (ros::WallTime::now() - start).toSec());
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
