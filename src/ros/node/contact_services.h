// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include <wheel_rail_contact/EvaluateWheelset.h>
#include <wheel_rail_contact/WheelsetInput.h>
#include "config/node_config.h"
#include "ros/evaluation/contact_statistics.h"
#include "ros/node/evaluation_chain.h"

namespace wheel_rail_contact
{
/// Services of the node, of the type EvaluateWheelset:
/// - `~evaluate` evaluates a state like a pair of the topics: checks, transforms, neighbours, warm start and
///   contact/hold_last are the same.
/// - `~static_start` solves height and roll from the load, whatever wheelset/free is. Each request starts cold, and
///   nothing is held.
///
/// One thread handles all requests in the order of their arrival, beside the topics. The services have evaluators of
/// their own: the results on the topics do not depend on them, and remain those of a replay. Each evaluator is made at
/// the first request.
class ContactServices
{
 public:
  /// Advertises the services.
  /// @param transforms,neighbours must outlive the services
  ContactServices(const ros::NodeHandle& private_nh, const NodeConfig& config, const TransformStore& transforms,
                  const NeighbourForces& neighbours);
  /// Ends after the current request.
  ~ContactServices();
  ContactServices(const ContactServices&) = delete;
  ContactServices& operator=(const ContactServices&) = delete;

  /// Evaluates an input as a request of `~evaluate`, in its turn. Thread-safe.
  /// @return its result. The future has an exception after an internal error, and stays empty if the services end
  /// before.
  std::future<WheelsetContact> evaluate(const WheelsetInput& input);

  /// Requests of both services so far. Thread-safe.
  ServiceCounts counts() const;

 private:
  struct Service
  {
    NodeConfig config;
    std::uint64_t ServiceCounts::*results;   ///< their number
    bool is_cold;                            ///< each request starts cold
    std::unique_ptr<EvaluationChain> chain;  ///< thread of the services only
    ros::ServiceServer server;
  };

  void advertise(Service& service, const std::string& name, ros::NodeHandle& own);
  /// @param request the messages of the input topics
  /// @throw std::exception after an internal error, which is logged and counted.
  template <typename Request>
  WheelsetContact resultOf(Service& service, const Request& request);

  const TransformStore& transforms_;
  const NeighbourForces& neighbours_;
  ros::CallbackQueue queue_;
  Service evaluate_, static_start_;
  std::atomic<bool> ended_{false};
  mutable std::mutex mutex_;  ///< guards `counts_`
  ServiceCounts counts_;
  ros::AsyncSpinner spinner_;
};
}  // namespace wheel_rail_contact
