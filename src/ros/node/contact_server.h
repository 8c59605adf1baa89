// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/publisher.h>
#include <ros/callback_queue_interface.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

#include "config/node_config.h"
#include "ros/evaluation/contact_statistics.h"
#include "ros/evaluation/transform_store.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/pressure_scale.h"
#include "ros/node/contact_services.h"
#include "ros/node/evaluation_chain.h"
#include "ros/node/newest_queue.h"

namespace wheel_rail_contact
{
/// Callback queue interface that runs each callback immediately, in the thread that received the message.
///
/// For short callbacks that must receive every message: no message waits in roscpp, so roscpp drops none. The callbacks
/// of one subscription never run concurrently; those of different subscriptions may.
class ImmediateCallbacks : public ros::CallbackQueueInterface
{
 public:
  /// Runs the callback.
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t /*owner_id*/) override { callback->call(); }
  /// Does nothing, because no callback is stored.
  void removeByID(std::uint64_t /*owner_id*/) override {}
};

/// Report on the rate of an input topic, and on the delay from the stamps of its messages to their arrival. Without a
/// bound it only states them, and silence is no fault: a simulation may pause.
class InputDiagnostic : public diagnostic_updater::TopicDiagnostic
{
 public:
  InputDiagnostic(const std::string& topic, diagnostic_updater::Updater& updater, const NodeConfig& config,
                  double delay)
      : TopicDiagnostic(topic, updater, {&least_, &largest_, 0}, {-delay, delay}), config_(config)
  {
  }

  void run(diagnostic_updater::DiagnosticStatusWrapper& status) override
  {
    TopicDiagnostic::run(status);
    if (config_.min_rate == 0 && config_.max_delay == 0)
    {
      status.summary(diagnostic_msgs::DiagnosticStatus::OK, "no bounds given");
    }
  }

 private:
  const NodeConfig& config_;
  double least_ = config_.min_rate, largest_ = std::numeric_limits<double>::infinity();  ///< rates [Hz]
};

/// One wheelset of node and nodelet: subscribes to the input topics; publishes results, markers and diagnostics;
/// provides the services (ContactServices).
///
/// The callbacks only pair the messages, at arrival. A separate thread evaluates the pairs in order and publishes the
/// results. If inputs arrive faster than they are evaluated, the newest ones are kept; the dropped ones are counted. No
/// input stops the server.
class ContactServer
{
 public:
  /// Largest number of complete inputs that wait for evaluation.
  static constexpr std::size_t input_capacity = 200;

  /// Reads the parameters, advertises and subscribes to the topics, and starts the evaluation.
  /// @throw std::invalid_argument for invalid parameters (readNodeConfig()), or if the topic of a neighbour is that of
  /// this node.
  ContactServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  /// Ends after the current evaluation. Logs the number of inputs without a published result: the waiting ones, and
  /// those whose evaluation ended after ROS had shut down.
  ~ContactServer();
  ContactServer(const ContactServer&) = delete;
  ContactServer& operator=(const ContactServer&) = delete;

  /// Services of this wheelset.
  ContactServices& services() { return services_; }

 private:
  void advertise();
  void subscribe();
  template <typename Message>
  void subscribeToInput(InputTopic topic);
  void subscribeToNeighbours();
  void subscribeToTransforms(const std::string& topic, bool is_static);
  /// Calls `receive` at the arrival of each message; no message waits in a queue that could drop it.
  template <typename Message>
  void subscribeAtOnce(const std::string& topic,
                       const boost::function<void(const boost::shared_ptr<const Message>&)>& receive);

  void work();
  void reportUnevaluated();
  void evaluate(const ContactInput& input);
  void warn(const std::string& beyond_linear_range);
  void countDamaged(const std::string& topic);
  void warnOfMissingStamp(InputTopic topic, const ros::Time& stamp);
  bool pictureIsDue();
  void publishMarkers(const ContactOutput& output);
  void publishPlain(const ContactOutput& output) const;
  void reportNow();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle nh_, private_nh_;
  const NodeConfig config_;
  const std::string wheelset_frame_;
  InputPairing pairing_;  ///< under `mutex_`, together with pushing to `inputs_`
  TransformStore transforms_;
  ros::Time last_transform_;  ///< ROS time of the last message on /tf or /tf_static; under `mutex_`
  NewestQueue<ContactInput> inputs_;

  std::mutex mutex_;              ///< guards `statistics_` to `warned_of_missing_stamp_`, and `pairing_`
  ContactStatistics statistics_;  ///< without results after ROS has shut down
  ContactStatistics reported_;    ///< statistics at the last report
  ContactStatistics warned_;      ///< statistics at the last warning of dropped inputs
  ros::WallTime next_drop_warning_;
  std::uint64_t input_count_ = 0;  ///< number of inputs pushed to `inputs_`
  bool warned_of_missing_stamp_ = false;

  NeighbourForces neighbours_;
  EvaluationChain chain_;  ///< worker only
  ContactServices services_;

  ImmediateCallbacks immediate_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher contact_publisher_, marker_publisher_, profile_publisher_, frame_publisher_;
  core::Sides<ros::Publisher> wrench_publishers_;  ///< with wheelset/publish_wrenches
  MarkerKeys shown_markers_;                       ///< markers of the last published array; worker only
  PressureScale pressure_scale_;                   ///< of the markers; worker only
  PressureScale stress_scale_{0};                  ///< of the markers; worker only
  ros::WallTime next_picture_;                     ///< earliest time of the next markers; worker only
  ros::WallTime next_warning_;                     ///< earliest time of the next warning; worker only
  diagnostic_updater::Updater diagnostics_;
  std::deque<InputDiagnostic> input_diagnostics_;
  ros::WallTimer diagnostics_timer_;
  std::thread worker_;
};
}  // namespace wheel_rail_contact
