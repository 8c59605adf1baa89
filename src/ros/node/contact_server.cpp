// SPDX-License-Identifier: BSD-3-Clause
#include "ros/node/contact_server.h"

#include <exception>
#include <iostream>

#include "core/option_check.h"
#include "ros/evaluation/conversions.h"
#include "ros/evaluation/plain_messages.h"
#include "ros/markers/contact_scene.h"
#include "ros/markers/stress_section.h"
#include "ros/markers/track_markers.h"
#include "ros/parameters/node_parameters.h"

namespace wheel_rail_contact
{
constexpr std::uint32_t queue_size = 1000;      ///< of the queues of roscpp [messages]
constexpr double most_queued_bytes = 1 << 26;   ///< of results that wait for a subscriber
constexpr double bytes_per_layer = 40e3;        ///< of the values of all cells of a result
constexpr std::uint32_t marker_queue_size = 2;  ///< small, because old markers are of no use [messages]
constexpr double diagnostics_period = 1.0;      ///< [s]
constexpr double warning_period = 10.0;         ///< shortest time between two warnings [s]

/// Passes damaged messages to a function. roscpp would log each one, and count none.
template <typename Message>
struct DamageFinder : ros::SubscriptionCallbackHelperT<const boost::shared_ptr<const Message>&>
{
  using Helper = ros::SubscriptionCallbackHelperT<const boost::shared_ptr<const Message>&>;
  using Helper::Helper;

  ros::VoidConstPtr deserialize(const ros::SubscriptionCallbackHelperDeserializeParams& message) override
  {
    try
    {
      return Helper::deserialize(message);
    }
    catch (const std::exception&)  // truncated, or a size for which there is no memory
    {
      damaged();
      return {};
    }
  }

  std::function<void()> damaged;
};

ContactServer::ContactServer(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : nh_(nh),
      private_nh_(private_nh),
      config_(readNodeParameters(private_nh_)),
      wheelset_frame_(wheelsetFrame(config_, nh_.getNamespace())),
      pairing_(config_),
      inputs_(input_capacity),
      neighbours_(config_),
      chain_(config_, transforms_, neighbours_),
      services_(private_nh_, config_, transforms_, neighbours_),
      pressure_scale_(config_.markers.max_pressure),
      diagnostics_(nh_, private_nh_, private_nh_.getNamespace())
{
  for (const std::string& note : config_.notes)
  {
    ROS_INFO("%s: %s", private_nh_.getNamespace().c_str(), note.c_str());
  }
  for (const std::string& warning : config_.warnings)
  {
    ROS_WARN("%s: %s", private_nh_.getNamespace().c_str(), warning.c_str());
  }
  diagnostics_.setHardwareID("none");
  diagnostics_.add("wheel-rail contact", this, &ContactServer::report);
  advertise();
  subscribe();
  diagnostics_timer_ =
      nh_.createWallTimer(ros::WallDuration(diagnostics_period), [this](const ros::WallTimerEvent&) { reportNow(); });
  worker_ = std::thread(&ContactServer::work, this);
}

ContactServer::~ContactServer()
{
  diagnostics_timer_.stop();
  for (ros::Subscriber& subscriber : subscribers_)
  {
    subscriber.shutdown();
  }
  inputs_.close();
  if (!ros::isShuttingDown())
  {
    worker_.join();  // the result of the current evaluation is still published
  }
  reportUnevaluated();
  if (worker_.joinable())
  {
    worker_.join();
  }
}

void ContactServer::reportUnevaluated()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::uint64_t unevaluated = input_count_ - inputs_.dropped() - statistics_.evaluated();
  if (unevaluated == 0)
  {
    return;
  }
  const std::string text = private_nh_.getNamespace() + " ends, inputs not evaluated: " + std::to_string(unevaluated);
  if (ros::isShuttingDown())
  {
    std::cerr << text << std::endl;  // the ROS log is closed
  }
  else
  {
    ROS_WARN("%s", text.c_str());
  }
}

/// Number of results that wait for a slow subscriber. Their values of cells are pressure, tractions and layers of
/// stress.
std::uint32_t resultQueueSize(const NodeConfig& config)
{
  const bool has_creep = config.model.creep.method != core::CreepMethod::none;
  const int layers = 1 + (has_creep ? 2 : 0) + (config.model.stress.field ? config.model.stress.depths : 0);
  return static_cast<std::uint32_t>(std::min<double>(queue_size, most_queued_bytes / (bytes_per_layer * layers)));
}

void ContactServer::advertise()
{
  contact_publisher_ = private_nh_.advertise<WheelsetContact>("contact", resultQueueSize(config_));
  marker_publisher_ = private_nh_.advertise<visualization_msgs::MarkerArray>("markers", marker_queue_size);
  profile_publisher_ = private_nh_.advertise<visualization_msgs::MarkerArray>("profiles", 1, true);
  profile_publisher_.publish(profileMarkers(config_));
  if (config_.path || config_.publish_tf || config_.publish_wrenches)
  {
    frame_publisher_ = nh_.advertise<tf2_msgs::TFMessage>("/tf", queue_size);
  }
  for (std::size_t i = 0; config_.publish_wrenches && i < core::sides.size(); ++i)
  {
    const std::string wheel = std::string(nameOf(core::sides[i])) + "_wheel/wrench";
    wrench_publishers_[core::sides[i]] = private_nh_.advertise<geometry_msgs::WrenchStamped>(wheel, queue_size);
  }
}

void ContactServer::subscribe()
{
  for (const InputTopic topic : inputTopics(config_))
  {
    withMessageType(topic, [this, topic](auto type) { subscribeToInput<typename decltype(type)::Message>(topic); });
  }
  subscribeToNeighbours();
  subscribeToTransforms("/tf", false);
  subscribeToTransforms("/tf_static", true);
}

/// tf2_ros::TransformListener would end the process at a stamp near the end of the range of ros::Time.
void ContactServer::subscribeToTransforms(const std::string& topic, bool is_static)
{
  subscribeAtOnce<tf2_msgs::TFMessage>(topic,
                                       [this, is_static](const boost::shared_ptr<const tf2_msgs::TFMessage>& message)
                                       {
                                         const std::lock_guard<std::mutex> lock(mutex_);
                                         const ros::Time now = ros::Time::now();
                                         if (now < last_transform_)
                                         {
                                           transforms_.clear();
                                         }
                                         last_transform_ = now;
                                         for (const auto& transform : message->transforms)
                                         {
                                           transforms_.add(transform, is_static);
                                         }
                                       });
}

template <typename Message>
void ContactServer::subscribeToInput(InputTopic topic)
{
  const double delay = config_.max_delay > 0 ? config_.max_delay : std::numeric_limits<double>::infinity();
  InputDiagnostic& diagnostic = input_diagnostics_.emplace_back(nameOf(topic), diagnostics_, config_, delay);
  subscribeAtOnce<Message>(nameOf(topic),
                           [this, topic, &diagnostic](const boost::shared_ptr<const Message>& message)
                           {
                             diagnostic.tick(message->header.stamp);
                             const std::lock_guard<std::mutex> lock(mutex_);
                             for (ContactInput& input : pairing_.add(topic, message))
                             {
                               input.arrival = ros::WallTime::now();
                               inputs_.push(std::move(input));
                               ++input_count_;
                             }
                             warnOfMissingStamp(topic, message->header.stamp);
                           });
}

template <typename Message>
void ContactServer::subscribeAtOnce(const std::string& topic,
                                    const boost::function<void(const boost::shared_ptr<const Message>&)>& receive)
{
  auto options = ros::SubscribeOptions::create<Message>(topic, queue_size, receive, nullptr, &immediate_);
  const auto helper = boost::make_shared<DamageFinder<Message>>(receive);
  helper->damaged = [this, topic] { countDamaged(topic); };
  options.helper = helper;
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  subscribers_.push_back(nh_.subscribe(options));
}

void ContactServer::subscribeToNeighbours()
{
  for (std::size_t i = 0; i < config_.neighbours.size(); ++i)
  {
    const std::string& topic = config_.neighbours[i].topic;
    core::refuseIf(nh_.resolveName(topic) == private_nh_.resolveName("contact"),
                   "parameter " + private_nh_.getNamespace() + "/rail_bending/neighbours: topic " + topic +
                       " is published by this node itself");
    subscribeAtOnce<ResultHead>(
        topic, [this, i](const boost::shared_ptr<const ResultHead>& result) { neighbours_.add(i, *result); });
  }
}

void ContactServer::work()
{
  while (const auto input = inputs_.pop())
  {
    try
    {
      evaluate(*input);
    }
    catch (const std::exception& error)
    {
      ROS_ERROR_THROTTLE(1.0, "internal error: %s", error.what());
      const std::lock_guard<std::mutex> lock(mutex_);
      ++statistics_.internal_errors;
      statistics_.last_reason = error.what();
    }
  }
}

void ContactServer::evaluate(const ContactInput& input)
{
  const ContactOutput output = chain_.evaluate(input, [this] { return inputs_.closed(); });
  if (frame_publisher_)
  {
    publishPlain(output);
  }
  const bool wants_message = contact_publisher_.getNumSubscribers() > 0;
  if (wants_message)
  {
    contact_publisher_.publish(toMessage(output, true));
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (ros::isShuttingDown())
    {
      return;  // the result is not published any more
    }
    statistics_.count(output);
    statistics_.messages_built += wants_message ? 1U : 0U;
  }
  warn(output.beyond_linear_range);
  if (marker_publisher_.getNumSubscribers() > 0 && pictureIsDue())
  {
    publishMarkers(output);
  }
}

void ContactServer::publishPlain(const ContactOutput& output) const
{
  if (const tf2_msgs::TFMessage frames = framesOf(output, config_, wheelset_frame_); !frames.transforms.empty())
  {
    frame_publisher_.publish(frames);
  }
  if (config_.publish_wrenches && output.result)
  {
    for (const core::Side side : core::sides)
    {
      wrench_publishers_[side].publish(wrenchMessage(output, side, wheelset_frame_));
    }
  }
}

void ContactServer::warn(const std::string& beyond_linear_range)
{
  if (!beyond_linear_range.empty() && ros::WallTime::now() >= next_warning_)
  {
    ROS_WARN("%s: %s", private_nh_.getNamespace().c_str(), beyond_linear_range.c_str());
    next_warning_ = ros::WallTime::now() + ros::WallDuration(warning_period);
  }
}

void ContactServer::countDamaged(const std::string& topic)
{
  ROS_WARN_THROTTLE(warning_period, "%s: a message on %s is truncated or damaged, and is dropped",
                    private_nh_.getNamespace().c_str(), nh_.resolveName(topic).c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  ++statistics_.truncated;
}

/// Warns at the first message whose stamp is 0.
void ContactServer::warnOfMissingStamp(InputTopic topic, const ros::Time& stamp)
{
  if (stamp.isZero() && !warned_of_missing_stamp_)
  {
    ROS_WARN("%s: a message on %s has the stamp 0, which means that it is unknown; such messages are dropped",
             private_nh_.getNamespace().c_str(), nh_.resolveName(nameOf(topic)).c_str());
    warned_of_missing_stamp_ = true;
  }
}

/// True if the current result is to be drawn. Markers are drawn at most at the configured rate. Before the time of the
/// next markers, the function waits for this time: the result is drawn then, unless a newer input arrives first. The
/// last result before a pause is therefore always drawn.
bool ContactServer::pictureIsDue()
{
  const double left = (next_picture_ - ros::WallTime::now()).toSec();
  return left <= 0 || !inputs_.waitForEntry(left);
}

void ContactServer::publishMarkers(const ContactOutput& output)
{
  const std::vector<core::Side> sides{core::Side::left, core::Side::right};
  const ros::Time& stamp = output.header.stamp;
  const SceneOptions options =
      sceneOptions(config_.markers, pressure_scale_.update(stamp, highestPressure(output, sides)),
                   stress_scale_.update(stamp, highestStress(output, sides)));
  visualization_msgs::MarkerArray markers = sceneMarkers(output, &config_.model, ContactTrail(), options);
  shown_markers_ = appendDeletions(shown_markers_, output.header, markers);
  marker_publisher_.publish(markers);
  next_picture_ = ros::WallTime::now() + ros::WallDuration(1 / config_.markers.rate);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++statistics_.marker_arrays_built;
}

/// The updater adds to ROS time, which throws at the end of its range.
void ContactServer::reportNow()
{
  try
  {
    diagnostics_.force_update();
  }
  catch (const std::exception& error)
  {
    ROS_ERROR_THROTTLE(warning_period, "%s: no diagnostics: %s", private_nh_.getNamespace().c_str(), error.what());
  }
}

void ContactServer::report(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  statistics_.pairing = pairing_.counts();
  statistics_.overload = inputs_.dropped();
  statistics_.services = services_.counts();
  const std::string before = std::exchange(statistics_.load_doubt, statistics_.loads.doubt(config_.model.wheelset));
  if (before.empty() && !statistics_.load_doubt.empty())
  {
    ROS_WARN("%s: %s", private_nh_.getNamespace().c_str(), statistics_.load_doubt.c_str());
  }
  diagnose(statistics_, reported_, status);
  reported_ = statistics_;
  const std::string dropped = droppedBetween(warned_, statistics_);
  if (!dropped.empty() && ros::WallTime::now() >= next_drop_warning_)
  {
    ROS_WARN("%s: inputs dropped: %s", private_nh_.getNamespace().c_str(), dropped.c_str());
    warned_ = statistics_;
    next_drop_warning_ = ros::WallTime::now() + ros::WallDuration(warning_period);
  }
  statistics_.solve_time_max = 0;
}
}  // namespace wheel_rail_contact
