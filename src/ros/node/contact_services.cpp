// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/contact_services.h"

#include <boost/function.hpp>
#include <boost/make_shared.hpp>
#include <exception>

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
template <typename Request>
ContactInput inputOf(const Request& request, const NodeConfig& config)
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
  take(InputTopic::twist, request.twist, input.twist);
  return input;
}

/// A task in a queue of roscpp.
struct QueuedTask : ros::CallbackInterface
{
  explicit QueuedTask(std::packaged_task<WheelsetContact()> function) : task(std::move(function)) {}

  CallResult call() override
  {
    task();
    return Success;
  }

  std::packaged_task<WheelsetContact()> task;
};
}  // namespace

ContactServices::ContactServices(const ros::NodeHandle& private_nh, const NodeConfig& config,
                                 const TransformStore& transforms, const NeighbourForces& neighbours)
    : transforms_(transforms),
      neighbours_(neighbours),
      evaluate_{config, &ServiceCounts::evaluate, false, {}, {}},
      static_start_{withSolvedHeight(config), &ServiceCounts::static_start, true, {}, {}},
      spinner_(1, &queue_)
{
  ros::NodeHandle own(private_nh);
  own.setCallbackQueue(&queue_);
  advertise(evaluate_, "evaluate", own);
  advertise(static_start_, "static_start", own);
  spinner_.start();
}

void ContactServices::advertise(Service& service, const std::string& name, ros::NodeHandle& own)
{
  using Callback = boost::function<bool(EvaluateWheelset::Request&, EvaluateWheelset::Response&)>;
  service.server = own.advertiseService(
      name, Callback(
                [this, &service](EvaluateWheelset::Request& request, EvaluateWheelset::Response& response)
                {
                  response.contact = resultOf(service, request);
                  return true;
                }));
}

ContactServices::~ContactServices()
{
  ended_ = true;
  evaluate_.server.shutdown();
  static_start_.server.shutdown();
  spinner_.stop();
}

ServiceCounts ContactServices::counts() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return counts_;
}

std::future<WheelsetContact> ContactServices::evaluate(const WheelsetInput& input)
{
  const auto task = boost::make_shared<QueuedTask>(
      std::packaged_task<WheelsetContact()>([this, input] { return resultOf(evaluate_, input); }));
  std::future<WheelsetContact> result = task->task.get_future();
  queue_.addCallback(task);
  return result;
}

template <typename Request>
WheelsetContact ContactServices::resultOf(Service& service, const Request& request)
{
  try
  {
    if (!service.chain)
    {
      service.chain = std::make_unique<EvaluationChain>(service.config, transforms_, neighbours_);
    }
    if (service.is_cold)
    {
      service.chain->restart();
    }
    ContactInput input = inputOf(request, service.config);
    input.arrival = ros::WallTime::now();
    const ContactOutput output = service.chain->evaluate(input, [this] { return ended_.load(); });
    const std::lock_guard<std::mutex> lock(mutex_);
    ++(counts_.*service.results);
    counts_.unusable += isUsable(output.status) ? 0U : 1U;
    counts_.lacking_neighbour += output.lacks_neighbour ? 1U : 0U;
    return toMessage(output, true);
  }
  catch (const std::exception& error)
  {
    ROS_ERROR_THROTTLE(1.0, "internal error in a service: %s", error.what());
    const std::lock_guard<std::mutex> lock(mutex_);
    ++counts_.failed;
    throw;
  }
}
}  // namespace wheel_rail_contact
