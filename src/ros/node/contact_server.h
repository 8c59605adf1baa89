// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ros/markers/marker_tools.h"
#include "ros/node/contact_evaluator.h"
#include "ros/node/contact_input.h"
#include "ros/node/contact_statistics.h"
#include "ros/node/immediate_callbacks.h"
#include "ros/node/neighbour_forces.h"
#include "ros/node/newest_queue.h"
#include "ros/parameters/parameters.h"

namespace wheel_rail_contact
{
/// The live contact server behind node and nodelet: topics in, answers, markers and diagnostics out.
///
/// Callbacks only pair what comes in, as it arrives; a thread of its own evaluates the pairs in order and publishes. If
/// more comes in than can be answered, the newest inputs are kept and the others counted. No input stops the server.
class ContactServer
{
 public:
  /// Greatest number of complete inputs that wait for evaluation.
  static constexpr std::size_t input_capacity = 200;
  /// Reads the parameters, subscribes and starts.
  /// @throw std::invalid_argument for parameters that cannot be used (see readNodeConfig()).
  ContactServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  /// Ends after the evaluation in hand. Tells how many inputs have no answer: those that wait, and those whose answer
  /// came too late to be published.
  ~ContactServer();
  ContactServer(const ContactServer&) = delete;
  ContactServer& operator=(const ContactServer&) = delete;

 private:
  void advertise();
  void subscribe();
  /// `take` gives a message to the pairing.
  template <typename Message, typename Take>
  void subscribeToInput(const std::string& topic, const Take& take);
  void subscribeToNeighbours();
  /// `receive` is called as each message arrives: none waits in a queue that could drop it.
  template <typename Message>
  void subscribeAtOnce(const std::string& topic,
                       const boost::function<void(const boost::shared_ptr<const Message>&)>& receive);

  void work();
  void reportUnevaluated();
  void waitForTransform(const ContactInput& input) const;
  PreparedInput prepare(const ContactInput& input);
  void evaluate(const ContactInput& input);
  void warn(const std::string& beyond_linear_range);
  bool pictureIsDue();
  void publishMarkers(const ContactOutput& output);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  ros::NodeHandle nh_, private_nh_;
  const NodeConfig config_;
  InputPairing pairing_;          ///< under `mutex_`, together with pushing to `inputs_`
  InputPreparation preparation_;  ///< worker only
  ContactEvaluator evaluator_;    ///< worker only
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener listener_;
  NewestQueue<ContactInput> inputs_;

  std::mutex mutex_;               ///< guards the statistics, the inputs' number and the pairing
  ContactStatistics statistics_;   ///< of what was answered before ROS shut down
  ContactStatistics reported_;     ///< as they were at the last report
  std::uint64_t input_count_ = 0;  ///< pushed to `inputs_`

  std::mutex neighbours_mutex_;  ///< guards the neighbours' forces
  NeighbourForces neighbours_;

  ImmediateCallbacks immediate_;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher contact_publisher_, marker_publisher_, profile_publisher_;
  MarkerKeys shown_markers_;    ///< by the last array published, worker only
  ros::WallTime next_picture_;  ///< worker only
  ros::WallTime next_warning_;  ///< worker only
  diagnostic_updater::Updater diagnostics_;
  ros::WallTimer diagnostics_timer_;
  std::thread worker_;
};
}  // namespace wheel_rail_contact
